#include "facenav/align/alignment_seen.h"

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/plan/case_landmarks.h"

namespace facenav::steps {
namespace {

std::string placeName(surface::Landmark landmark) {
  switch (landmark) {
    case surface::Landmark::tragus_left:
      return "left tragus";
    case surface::Landmark::tragus_right:
      return "right tragus";
    case surface::Landmark::nasion:
      return "nasion";
    default:
      return toString(landmark);
  }
}

}  // namespace

std::vector<surface::NamedPlace> placesToTouch(const casefile::CaseStore& store,
                                               const surface::ScalpSurface& scalp,
                                               const registration::ScalpField* field) {
  constexpr double kNoseTip_mm = 1.0;  // uncertainty of the foremost point of the flat tip
  std::vector<surface::NamedPlace> places;
  if (field && scalp.has_face) places.push_back({"nose tip", Point<Mri>(field->noseTip_mm()), kNoseTip_mm});
  try {
    const auto landmarks = landmarksOf(store, scalp);
    for (const auto which :
         {surface::Landmark::nasion, surface::Landmark::tragus_left, surface::Landmark::tragus_right})
      if (const auto& landmark = landmarks[which])
        places.push_back({placeName(which), landmark->point, landmark->sd_mm});
  } catch (const Error& error) {  // the skin alone is still useful
    logWarning(std::string("no landmarks for the check of the alignment: ") + error.what());
  }
  return places;
}

AlignmentSeen seeAlignment(const casefile::CaseStore& store, const AlignmentOutcome& alignment) {
  const auto scalp = store.scalp();
  auto places = placesToTouch(store, scalp, alignment.scalp.get());
  return {std::make_shared<const pictures::AlignedSkin>(pictures::makeAlignedSkin(scalp.mesh, places)),
          std::make_shared<const guidance::TipCheck>(scalp.mesh, places)};
}

pictures::CameraOverlay drawAlignment(const cameras::StereoRig& rig, const AlignmentOutcome& alignment,
                                      const AlignmentSeen& seen) {
  return pictures::drawAlignedSkin(rig, alignment.reference.frame, alignment.result.camera_T_mri, *seen.skin);
}

std::optional<guidance::TipReading> readTip(const session::NavigationState& state, const Point<Coil>& tip,
                                            const guidance::TipCheck& check) {
  if (!state.camera_T_mri || !state.camera_T_coil) return std::nullopt;
  return check.read(state.camera_T_mri->inverse() * (*state.camera_T_coil * tip));
}

std::optional<guidance::TipReading> readPickedSpot(const session::NavigationState& state,
                                                   const cameras::StereoRig& rig, stereo::PictureSide side,
                                                   const Eigen::Vector2d& px,
                                                   const guidance::TipCheck& check) {
  if (!state.camera_T_mri || !state.images || state.images->left.empty()) return std::nullopt;
  if (state.rig_correction) return std::nullopt;  // `rig` is no longer the cameras' pose
  const auto mri_T_camera = state.camera_T_mri->inverse();
  const auto spot = stereo::measurePickedSpot(rig, *state.images, side, px, [&](const Point<Camera>& place) {
    return check.read(mri_T_camera * place).isNear();
  });
  if (!spot) return std::nullopt;
  auto reading = check.read(mri_T_camera * spot->point);
  reading.what = guidance::TipReading::What::picked_spot;
  reading.sigma_mm = spot->sigma_mm;
  return reading;
}

std::string inWords(TipVerdict verdict, const guidance::TipReading& reading) {
  const bool is_tip = reading.what == guidance::TipReading::What::coil_tip;
  return std::string(verdict == TipVerdict::right ? "judged right: " : "judged wrong: ") + inWords(reading) +
         formatted("; %s at (%.1f, %.1f, %.1f) mm in the MRI", is_tip ? "tip" : "picked spot",
                   reading.tip.mm.x(), reading.tip.mm.y(), reading.tip.mm.z());
}

}  // namespace facenav::steps
