#include "facenav/treat/guide_poses.h"

#include <cmath>
#include <map>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/session/navigator.h"

namespace facenav::steps {
namespace {

/// Throws Error unless the poses are camera_T_mri and camera_T_coil, which guidance needs.
void requirePlacedPoses(const std::vector<casefile::PoseRow>& poses) {
  bool has_marker_poses = false;
  for (const auto& row : poses) {
    if (row.of_frame == "head")
      throw Error("the head's poses are not placed in the MRI", {}, "track again with --case");
    has_marker_poses |= row.of_frame == "marker";
  }
  if (has_marker_poses)
    logWarning("the coil's poses are the marker's (no --coil was given): the marker is guided, not the coil");
}

}  // namespace

std::optional<double> predictedError_mm(const casefile::CaseStore& store, const std::string& target) {
  const auto alignment = store.alignment();
  if (!alignment) return std::nullopt;
  const auto plan = store.targets();
  const auto& wanted = plan.find(target);
  auto predicted_mm = alignment->predictedError_mm(wanted);
  // The value stored without a covariance includes the skin's share.
  if (predicted_mm && alignment->uncertainty)
    predicted_mm = std::hypot(*predicted_mm, surface::skinDoubtUnder_mm(store.scalp(), wanted.scalp_point));
  return predicted_mm;
}

std::vector<guidance::GuidanceRow> guidePoses(const casefile::CaseStore& store,
                                              const std::vector<casefile::PoseRow>& poses,
                                              const std::string& target_name,
                                              const registration::ScalpField* scalp) {
  requirePlacedPoses(poses);
  const auto plan = store.targets();
  const auto& target = plan.find(target_name);
  const double predicted_mm =
      predictedError_mm(store, target_name).value_or(0.0);  // 0 in guidance.csv: unknown

  std::map<std::int64_t, std::pair<const casefile::PoseRow*, const casefile::PoseRow*>> frames;
  for (const auto& row : poses)
    (row.object == casefile::PoseObject::head ? frames[row.frame].first : frames[row.frame].second) = &row;
  std::vector<guidance::GuidanceRow> rows;
  guidance::GuidanceState previous;
  for (const auto& [frame, pair] : frames) {
    const auto [head, coil] = pair;
    const Tracked<RigidTransform<Camera, Mri>> camera_T_mri =
        head ? head->tracked<Camera, Mri>() : Tracked<RigidTransform<Camera, Mri>>(Lost{LostReason::no_face});
    const Tracked<RigidTransform<Camera, Coil>> camera_T_coil =
        coil ? coil->tracked<Camera, Coil>()
             : Tracked<RigidTransform<Camera, Coil>>(Lost{LostReason::no_marker});
    previous = guidance::evaluate(target, camera_T_mri, camera_T_coil, {}, predicted_mm, previous);
    rows.push_back({frame, (head ? head : coil)->t_s, target_name, previous, {}});
    if (scalp && camera_T_mri && camera_T_coil)
      rows.back().gap.by_poses_mm = session::gapToSkin_mm(camera_T_mri->inverse() * *camera_T_coil, *scalp);
  }
  return rows;
}

}  // namespace facenav::steps
