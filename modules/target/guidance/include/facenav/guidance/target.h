#pragma once
// Target: the wanted pose of the coil, and its planning from a point on the cortex. Reads and writes
// targets.json.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/file_access.h"
#include "facenav/geometry/rigid_transform.h"
#include "facenav/guidance/dose.h"
#include "facenav/guidance/target_record.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::guidance {

struct Target {
  std::string name;
  RigidTransform<Mri, frames::Target>
      mri_T_target;  // Coil convention: +z into the head, +y along the handle's prolongation
  Point<Mri> cortex_point, scalp_point;
  std::string note;
  double lift_mm = 0;  // height of the coil's centre above the skin while its plate touches it without hair
  bool is_locked = false;             // a locked target cannot be changed
  std::optional<Dose> dose = {};      // its own; if absent, the case's protocol applies
  std::optional<GridSpec> grid = {};  // the grid whose seed it is
  std::optional<GridPlace> grid_place = {};
  std::vector<Change> changes = {};       // oldest first
  std::optional<ExpertPose> expert = {};  // set if the pose is one that an expert used
};

struct TreatmentPlan {
  std::vector<Target> targets;
  std::vector<std::string> damaged = {};  // what the file held and could not be read, one line each
  /// Finds a target by name. Throws Error that lists the existing names and says what was damaged.
  const Target& find(const std::string& name) const;
};

/// Places the coil tangent to the scalp over `cortex_point`: at the nearest scalp point, z inward towards the
/// cortex point, y in the tangent plane at `handle_angle_rad` from anterior, turning towards the midline (45
/// degrees: the usual posterior-lateral handle over M1). On the side of the head "towards the midline" is
/// upwards; on the midline itself it is towards the patient's left. Over forehead and occiput superior
/// replaces anterior (limits in handle.h). `gap_mm`: between contact face and scalp (hair). Throws Error for
/// a scalp without triangles, or a cortex point that is not 1 to 80 mm below the scalp.
Target planTarget(const std::string& name, const surface::ScalpSurface& scalp, const Point<Mri>& cortex_point,
                  double handle_angle_rad, double gap_mm = 0.0);

/// Throws Error that names the target and the fault: no name, control characters, a pose or point that is not
/// finite or lies farther away than 1 m, a dose out of range.
void requireSound(const Target& target);

/// Reads targets.json. A target that is damaged (a missing or malformed key, a mirrored or non-rigid matrix,
/// a duplicate name, one that is not sound) is left out and told in `damaged`, with file and key. Throws
/// Error if the file holds no list of targets.
TreatmentPlan readTargets(const std::filesystem::path& path);
/// Writes the file completely or not at all. Keys unknown to FaceNav are kept from the replaced file. A
/// replaced file that was damaged is kept beside it as targets_damaged.json. Throws Error, also for a target
/// that is not sound; the file then stays as it was.
void writeTargets(const TreatmentPlan& plan, const std::filesystem::path& path,
                  FileAccess access = FileAccess::owner_only);

}  // namespace facenav::guidance
