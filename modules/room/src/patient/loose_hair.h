#pragma once
// LooseHair: locks that hang from the hairline over temples, cheeks and the edge of the forehead. They are
// not part of the MRI and move against the skull.

#include <memory>
#include <vector>

#include "facenav/room/virtual_patient.h"
#include "hair_pose.h"
#include "optics/look.h"

namespace facenav::room {

class LooseHair {
 public:
  /// Same patient and seed, same locks. None where no hair grows.
  LooseHair(const VirtualPatient& patient, std::uint64_t seed);

  /// At rest, Mri.
  const surface::TriangleMesh& mesh() const { return mesh_; }
  /// The vertices' places: roots stay, tips move up to 1.5 times as far as the scalp's hair.
  std::vector<Eigen::Vector3d> vertices_mm(const HairPose& pose) const;

 private:
  struct Root {
    Eigen::Vector3d p_mm, normal;
  };
  void addLock(const Root& root, const std::vector<Eigen::Vector3d>& path);

  surface::TriangleMesh mesh_;
  std::vector<Root> roots_;        // of each vertex's lock
  std::vector<double> from_root_;  // of each vertex: 0 at the root, 1 at the tip
};

/// Keeps a reference to `rest`, which must outlive the look.
std::shared_ptr<const Look> makeLockLook(const surface::TriangleMesh& rest);

}  // namespace facenav::room
