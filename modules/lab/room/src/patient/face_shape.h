#pragma once
// FaceShape: the difference of the head's surface from the MRI's: lowered jaw and narrowed mouth (talking),
// closed lids, grimaces, blinks, moved hair. The skin's texture moves along, since looks use the point at
// rest.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "expression.h"
#include "facenav/room/virtual_patient.h"
#include "hair_pose.h"

namespace facenav::room {

class FaceShape {
 public:
  explicit FaceShape(const VirtualPatient& patient);
  /// `jaw_mm`: how far the chin is lowered; `lids`: 0 open .. 1 closed. True if the vertices changed.
  bool set(double jaw_mm, double lids, const Expression& expression = {}, const HairPose& hair = {});

  const std::vector<Eigen::Vector3d>& vertices_mm() const { return vertices_mm_; }
  const std::vector<Eigen::Vector3d>& normals() const { return normals_; }
  bool isAtRest() const { return jaw_mm_ == 0.0 && !isDeformed(); }
  const Expression& expression() const { return expression_; }
  float lids() const { return float(lids_); }
  /// Shift of a surface point from its position at rest.
  Eigen::Vector3d shift_mm(int triangle, float u, float v) const;

 private:
  /// True if anything other than the jaw deforms the surface.
  bool isDeformed() const { return !expression_.isNone() || !hair_.isAtRest(); }
  /// The skin that the face can move, and its triangles.
  struct Region {
    std::vector<int> vertices, triangles;
  };
  Region movingRegion() const;
  void prepareRegion();
  void renewNormals(const std::vector<int>& vertices, const std::vector<int>& triangles,
                    const std::function<bool(int)>& moves);
  void deform();

  const VirtualPatient& patient_;
  std::vector<Eigen::Vector3d> per_jaw_mm_;  // shift of each vertex per mm of jaw
  std::vector<int> moving_vertices_, moving_triangles_, touched_vertices_;
  std::vector<Eigen::Vector3d> vertices_mm_, normals_;
  double jaw_mm_ = 0.0, lids_ = 0.0;
  Expression expression_;
  HairPose hair_;
  Region region_;                    // computed at the first grimace
  std::vector<double> hair_weight_;  // per vertex: 0 at the hairline .. 1 well inside
  std::vector<bool> is_in_region_;
  std::vector<Eigen::Vector3d> shift_mm_;  // per vertex, while deformed
};

}  // namespace facenav::room
