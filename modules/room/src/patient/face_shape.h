#pragma once
// FaceShape: how the face differs from the MRI's: lowered jaw and drawn mouth corners (talking), closed lids,
// grimaces.
// The skin's texture moves along, since looks ask for the place at rest.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "expression.h"
#include "facenav/room/virtual_patient.h"

namespace facenav::room {

class FaceShape {
 public:
  explicit FaceShape(const VirtualPatient& patient);
  /// `jaw_mm`: chin lowered; `lids`: 0 open .. 1 closed. True where the vertices changed.
  bool set(double jaw_mm, double lids, const Expression& expression = {});

  const std::vector<Eigen::Vector3d>& vertices_mm() const { return vertices_mm_; }
  const std::vector<Eigen::Vector3d>& normals() const { return normals_; }
  bool isAtRest() const { return jaw_mm_ == 0.0 && expression_.isNone(); }
  const Expression& expression() const { return expression_; }
  float lids() const { return float(lids_); }
  /// Shift of a surface point from its place at rest.
  Eigen::Vector3d shift_mm(int triangle, float u, float v) const;

 private:
  /// The skin that some part of the face can move, and the triangles whose corners it is.
  struct Region {
    std::vector<int> vertices, triangles;
  };
  Region expressiveRegion() const;
  void renewNormals(const std::vector<int>& vertices, const std::vector<int>& triangles,
                    const std::function<bool(int)>& moves);
  void deform();

  const VirtualPatient& patient_;
  std::vector<Eigen::Vector3d> per_jaw_mm_;  // shift of each vertex for 1 mm of jaw
  std::vector<int> moving_vertices_, moving_triangles_, touched_vertices_;
  std::vector<Eigen::Vector3d> vertices_mm_, normals_;
  double jaw_mm_ = 0.0, lids_ = 0.0;
  Expression expression_;
  Region region_;  // found when the first grimace is made
  std::vector<bool> is_in_region_;
  std::vector<Eigen::Vector3d> shift_mm_;  // of each vertex, while there is a grimace
};

}  // namespace facenav::room
