#pragma once
// LooseHair: locks that hang from the hairline over temples, cheeks and the edge of the forehead. They are
// not in the MRI and move relative to the skull.

#include <memory>
#include <vector>

#include "facenav/room/virtual_patient.h"
#include "hair_pose.h"
#include "optics/look.h"

namespace facenav::room {

class LooseHair {
 public:
  /// Makes the locks. The same patient and seed give the same locks; none if the patient has no hair.
  LooseHair(const VirtualPatient& patient, std::uint64_t seed);

  /// Mesh of the locks at rest, Mri.
  const surface::TriangleMesh& mesh() const { return mesh_; }
  /// Vertex positions: roots do not move, tips move up to 1.5 times as far as the scalp's hair.
  std::vector<Eigen::Vector3d> vertices_mm(const HairPose& pose) const;

 private:
  struct Root {
    Eigen::Vector3d p_mm, normal;
  };
  void addLock(const Root& root, const std::vector<Eigen::Vector3d>& path);

  surface::TriangleMesh mesh_;
  std::vector<Root> roots_;        // root of each vertex's lock
  std::vector<double> from_root_;  // per vertex: 0 at the root, 1 at the tip
};

/// Makes the look. Keeps a reference to `rest`, which must outlive it.
std::shared_ptr<const Look> makeLockLook(const surface::TriangleMesh& rest);

}  // namespace facenav::room
