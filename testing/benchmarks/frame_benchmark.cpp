// The whole stereo frame: head and coil tracked in the virtual room's treatment, ours and the 2010 paper's
// seven features, on one core and on all. Error against the room's truth, and time, in the same run. Prints a
// Markdown table.

#include <cstdio>
#include <memory>
#include <vector>

#include "facenav/core/parallel_for.h"
#include "facenav/peers/feature_head_tracker.h"
#include "facenav/volume/nifti.h"
#include "support/room_film.h"
#include "support/stopwatch.h"
#include "support/test_data.h"

using namespace facenav;
namespace support = facenav::testing;

namespace {

constexpr int kFrames = 60;

using Film = support::RoomFilm;

std::shared_ptr<const room::VirtualPatient> patient() {
  TaskMonitor monitor;
  return std::make_shared<const room::VirtualPatient>(
      room::makePatient(volume::readNifti(support::virtualPatientMri()).volume, {}, monitor));
}

/// A scenario, rendered once: the trackers' input, and the truth.
Film filmOf(const char* scenario, const std::shared_ptr<const room::VirtualPatient>& patient,
            const face::FaceDetector& detector) {
  room::ScenarioOptions options;
  options.name = scenario;
  options.frames = kFrames;
  return support::filmed(options, patient, detector);
}

/// One pass through the film.
struct Pass {
  std::vector<double> ms;  // a frame
  double squares_mm2 = 0.0;
  int tracked = 0;
  double rms_mm() const { return tracked ? std::sqrt(squares_mm2 / tracked) : 0.0; }
};

void note(Pass& pass, double ms, const std::optional<double>& error_mm) {
  pass.ms.push_back(ms);
  if (!error_mm) return;
  pass.squares_mm2 += *error_mm * *error_mm;
  ++pass.tracked;
}

using Clock = double (*)();

/// Runs each frame through a tracker. `error_mm`: error of a pose against the truth of its frame.
template <class Tracker, class ErrorOf>
Pass run(const Film& film, Tracker& tracker, Clock clock, const ErrorOf& error_mm) {
  Pass pass;
  for (std::size_t i = 0; i < film.frames.size(); ++i) {
    const double start_ms = clock();
    const auto pose = tracker.track(*film.frames[i]);
    const double ms = clock() - start_ms;
    note(pass, ms, pose ? std::optional<double>(error_mm(*pose, i)) : std::nullopt);
  }
  return pass;
}

Pass headPass(const Film& film, head_tracking::HeadTracker& tracker, Clock clock) {
  tracker.start(film.rig, film.reference);
  return run(film, tracker, clock, [&](const head_tracking::HeadPose& pose, std::size_t frame) {
    return film.errorAtTarget_mm(pose, frame);
  });
}

Pass coilPass(const Film& film, coil_tracking::CoilTracker& tracker, Clock clock) {
  tracker.start(film.rig, film.coil);
  return run(film, tracker, clock, [&](const coil_tracking::CoilPose& pose, std::size_t frame) {
    return (pose.camera_T_marker.translation_mm() - film.truth[frame].camera_T_marker->translation_mm())
        .norm();
  });
}

/// Tracks head and coil as the session does, with a shared work budget. Every `forget_every` frames (if not
/// 0) both are lost: time jumps so far that no prediction is valid.
Pass bothPass(const Film& film, head_tracking::HeadTracker& head, coil_tracking::CoilTracker& coil,
              Clock clock, int forget_every = 0) {
  constexpr double kForgotten_s = 10.0;
  head.start(film.rig, film.reference);
  coil.start(film.rig, film.coil);
  Pass pass;
  FrameWork deferred;
  double passed_s = 0.0;
  for (std::size_t i = 0; i < film.frames.size(); ++i) {
    cameras::StereoFrame frame = *film.frames[i];
    if (forget_every > 0 && i % std::size_t(forget_every) == 0) passed_s += kForgotten_s;
    frame.captured.s += passed_s;
    const double start_ms = clock();
    const auto pose = head.track(frame, {deferred, false});
    deferred = coil.track(frame, {pose.exposure_offset, pose.work}).deferred;
    const double ms = clock() - start_ms;
    note(pass, ms, pose ? std::optional(film.errorAtTarget_mm(*pose, i)) : std::nullopt);
  }
  return pass;
}

/// Prints times but no error: in some of these films the head must be lost.
void stateRow(const char* name, const Pass& pass) {
  std::printf("| %s | %d of %zu | %.2f | %.2f | %.2f |\n", name, pass.tracked, pass.ms.size(),
              support::quantile(pass.ms, 0.5), support::quantile(pass.ms, 0.99),
              support::quantile(pass.ms, 1.0));
}

void row(const char* name, const Pass& one_core, const Pass& all_cores) {
  char error[48] = "";
  if (one_core.tracked > 0)
    std::snprintf(error, sizeof error, "%.3f mm, %d of %zu", one_core.rms_mm(), one_core.tracked,
                  one_core.ms.size());
  std::printf("| %s | %s | %.2f | %.2f | %.2f | %.2f |\n", name, error, support::quantile(one_core.ms, 0.5),
              support::quantile(one_core.ms, 0.99), support::quantile(all_cores.ms, 0.5),
              support::quantile(all_cores.ms, 0.99));
}

}  // namespace

int main() {
  if (!std::filesystem::exists(support::virtualPatientMri())) {
    std::printf("\nThe virtual patient's MRI is not here: the frame benchmark is left out.\n");
    return 0;
  }
  const std::shared_ptr<const face::FaceDetector> detector = face::makeFaceDetector();
  const auto seated = patient();
  const Film film = filmOf("treatment", seated, *detector);
  std::printf(
      "\n## Stereo frame end to end, 640 x 480, treatment (%d frames)\n\nHead: error at the cortical target, "
      "alignment "
      "apart; coil: error of the marker's centre.\n\n| what | rms, tracked | one core: median, ms | p99 | "
      "all cores: "
      "median, ms | p99 |\n|---|---|---|---|---|---|\n",
      kFrames);
  const auto model = head_tracking::makeModelHeadTracker(detector),
             features = peers::makeFeatureHeadTracker(detector);
  const auto marker = coil_tracking::makeMarkerCoilTracker();
  cv::setNumThreads(1);
  auto one_core = std::make_unique<OneCoreOnly>();
  const Pass head = headPass(film, *model, processorTime_ms),
             seven = headPass(film, *features, processorTime_ms),
             coil = coilPass(film, *marker, processorTime_ms),
             both = bothPass(film, *model, *marker, processorTime_ms);
  cv::setNumThreads(-1);
  one_core.reset();
  const Pass head_all = headPass(film, *model, support::wall_ms),
             seven_all = headPass(film, *features, support::wall_ms),
             coil_all = coilPass(film, *marker, support::wall_ms),
             both_all = bothPass(film, *model, *marker, support::wall_ms);
  row("head, model", head, head_all);
  row("head, features7 (2010)", seven, seven_all);
  row("coil, marker", coil, coil_all);
  row("head, model + coil", both, both_all);
  std::printf("\nModel beside features7: %.1f times the speed, %.2f times the error.\n",
              support::quantile(seven.ms, 0.5) / support::quantile(head.ms, 0.5),
              head.rms_mm() / seven.rms_mm());
  std::printf(
      "\nHead and coil, one core, by what the frames show (%d each):\n\n| film | head tracked | median, ms | "
      "p99 | max |\n|---|---|---|---|---|\n",
      kFrames);
  cv::setNumThreads(1);
  one_core = std::make_unique<OneCoreOnly>();
  stateRow("treatment, the coil comes", both);
  stateRow("treatment, both lost every 9 frames", bothPass(film, *model, *marker, processorTime_ms, 9));
  const std::pair<const char*, const char*> others[] = {{"lost", "face away, gone, cameras at fault"},
                                                        {"other_face", "a stranger sits there"},
                                                        {"occlusion", "a hand and the coil before the face"},
                                                        {"coil_sweep", "the coil comes, goes, leaps"}};
  for (const auto& [scenario, name] : others)
    stateRow(name, bothPass(filmOf(scenario, seated, *detector), *model, *marker, processorTime_ms));
  return 0;
}
