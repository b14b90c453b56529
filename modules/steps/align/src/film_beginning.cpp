#include "facenav/align/film_beginning.h"

#include <cmath>

#include "facenav/face/stereo_face.h"

namespace facenav::steps {
namespace {

/// Time in which the head turns to both sides; later frames add little.
constexpr double kFilm_s = 2.0;

}  // namespace

std::pair<std::int64_t, std::int64_t> beginningOf(const capture::Recording& recording,
                                                  const face::FaceDetector* detector) {
  const auto length = std::int64_t(std::lround(kFilm_s * recording.frames_per_s));
  const auto film = capture::makeSource(recording);
  const auto frame = film->next();
  const std::int64_t start = frame ? frame->number : 0;
  for (auto now = frame; detector && now && now->number <= start + length; now = film->next())
    if (face::findStereoFace(*detector, recording.rig, *now)) return {now->number, now->number + length};
  return {start, start + length};
}

std::optional<health::ScaleObservation> restingMarkerIn(const capture::Recording& recording,
                                                        const coil_tracking::CoilModel& coil,
                                                        coil_tracking::CoilTracker& tracker) {
  if (recording.frame_count < 2) return std::nullopt;
  const auto [first, last] = beginningOf(recording);
  return markerLengthIn(*capture::makeSource(recording), first, last, coil, tracker);
}

coil_tracking::CoilModel coilNamedIn(const std::vector<std::filesystem::path>& folders) {
  for (const auto& folder : folders)
    if (!folder.empty() && std::filesystem::exists(folder / "coil.json"))
      return coil_tracking::readCoil(folder / "coil.json");
  return coil_tracking::defaultCoil();
}

}  // namespace facenav::steps
