// Cost of a whole session for the tracking of a frame: plain tracking beside a session with everything on
// (guidance, log, pulses at 10 Hz with both pictures, drift watchdog, gap by stereo, checks of the
// registration, camera overlays with the skin, two coil slices 20 times a second), in turn on the same
// recording. With `--frames N` instead: N frames as fast as possible, with memory and times block by block.

#include <atomic>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "facenav/align/align_case.h"
#include "facenav/core/log.h"
#include "facenav/pictures/overlay_worker.h"
#include "facenav/plan/plan_edits.h"
#include "facenav/prepare/prepare_case.h"
#include "facenav/room/simulate.h"
#include "facenav/scene/coil_slices.h"
#include "facenav/treat/treatment.h"
#include "facenav/volume/nifti.h"
#include "metered_session.h"
#include "support/stopwatch.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::benchmarks;
namespace support = facenav::testing;
namespace fs = std::filesystem;

namespace {

constexpr int kRounds = 4, kFramesPerRound = 1500, kFramesPerBlock = 20000;

steps::Registrations methods() {
  steps::Registrations all;
  const std::shared_ptr<const face::FaceDetector> face = face::makeFaceDetector();
  all.face_detector = [face] { return face; };
  all.head_segmenters.add("head", "", segmentation::makeHeadSegmenter);
  all.brain_segmenters.add("brain", "", segmentation::makeBrainSegmenter);
  all.aligners.add("surface", "", registration::makeSurfaceAligner);
  all.head_trackers.add("model", "", [face] { return head_tracking::makeModelHeadTracker(face); });
  all.coil_trackers.add("marker", "", coil_tracking::makeMarkerCoilTracker);
  return all;
}

struct Places {
  fs::path case_folder, recording;
};

/// Makes the virtual patient's case with a target, and a recording of a treatment.
void make(const steps::Registrations& methods, const Places& places) {
  TaskMonitor monitor;
  steps::PrepareRequest request;
  request.input = support::virtualPatientMri();
  request.case_folder = places.case_folder;
  request.head_segmenter = "head";
  request.brain_segmenter = "brain";
  const auto prepared = steps::prepareCase(methods, request, monitor);
  const auto head = steps::plannedHead(prepared.store);
  const auto map = prepared.store.atlas();
  const auto target = steps::targetOverCortex(head, "M1 hand L",
                                              steps::cortexNear(head, map->toMri(Point<Mni>(-37, -21, 58))));
  prepared.store.setTargets(steps::with({}, target.name, target));
  room::ScenarioOptions options;
  options.frames = 180;
  const auto patient = std::make_shared<const room::VirtualPatient>(
      room::makePatient(volume::readNifti(support::virtualPatientMri()).volume, {}, monitor));
  room::simulate(options, patient, target.mri_T_target, places.recording, monitor);
}

/// Data shared by all runs.
struct Stage {
  steps::Registrations methods;
  casefile::CaseStore store;
  steps::TreatmentFilm recording;
  Film film;
  std::shared_ptr<const steps::AlignmentOutcome> alignment;
  steps::AlignmentSeen seen;
  scene::SliceScene slices;
  guidance::Target target;

  std::unique_ptr<session::Navigator> navigator(const session::NavigatorSetup& setup,
                                                const std::shared_ptr<Meter>& meter) const {
    return std::make_unique<session::Navigator>(
        setup, std::make_unique<MeteredHead>(methods.head_trackers.create("model"), meter),
        std::make_unique<MeteredCoil>(methods.coil_trackers.create("marker"), meter));
  }
};

Stage stageOf(const Places& places, steps::Registrations all) {
  TaskMonitor monitor;
  auto store = casefile::CaseStore::open(places.case_folder);
  auto recording = steps::openTreatmentFilm(places.recording);
  auto outcome = std::make_shared<const steps::AlignmentOutcome>(
      steps::alignRecording(all, store, recording.recording, {"surface"}, monitor).outcome);
  auto seen = steps::seeAlignment(store, *outcome);
  scene::SliceScene slices;
  slices.mri = std::make_shared<const volume::Volume>(store.mri());
  scene::setUsualWindow(slices);
  const auto target = store.targets().targets.front();
  slices.targets = {target};
  slices.active_target = target.name;
  return {std::move(all), store, recording, filmOf(places.recording), outcome, seen, slices, target};
}

/// Tracks head and coil, and nothing else.
void runPlain(const Stage& stage, const FilmOrder& order, const std::shared_ptr<Meter>& meter) {
  session::NavigatorSetup setup;
  setup.rig = stage.film.rig;
  setup.reference = stage.alignment->reference;
  setup.camera_T_mri_at_reference = stage.alignment->result.camera_T_mri;
  setup.coil = stage.recording.coil;
  setup.pace = head_tracking::Pace::live;
  auto navigator = stage.navigator(setup, meter);
  session::SessionOptions options;
  options.is_paced = false;
  session::Session session(std::make_unique<FilmSource>(stage.film, order, meter, nullptr),
                           std::move(navigator), options);
  session.start();
  while (!session.hasEnded()) session.take(std::chrono::milliseconds(50));
}

/// Work that the window does beside the frames.
class Window {
 public:
  explicit Window(const Stage& stage) : stage_(stage), overlays_([this](const auto&) { ++overlays_drawn; }) {}
  void look(steps::Treatment& treatment) {
    const auto state = treatment.session().latest();
    const double now_s = Timestamp::now().s;
    if (now_s - overlay_s_ > 1 / 30.0 && state->images) {
      overlays_.ask({stage_.film.rig, state, stage_.target,
                     pictures::AlignmentShown{stage_.seen.skin, treatment.tip()}});
      overlay_s_ = now_s;
    }
    if (now_s - slices_s_ > 1 / 20.0 && state->camera_T_mri && state->camera_T_coil) {
      const scene::SlicedCoil coil{state->camera_T_mri->inverse() * *state->camera_T_coil,
                                   guidance::figureOfEight(), 2.0};
      for (const auto cut : {scene::CoilCut::along_handle, scene::CoilCut::across_handle})
        scene::coilSlicePicture(stage_.slices, coil, cut, scene::coilPlane(coil.mri_T_coil, cut, 360, 300));
      steps::readTip(*state, treatment.tip(), *stage_.seen.check);
      slices_s_ = now_s;
      ++slices_drawn;
    }
    const auto minute = state->frame / std::int64_t(60 * kFramesPerSecond);
    if (state->frame >= 0 && minute != checked_minute_) treatment.checkRegistration();
    if (state->frame >= 0) checked_minute_ = minute;
    if (state->check) checks = state->check->number;
    treatment.log().takeKept();  // as `track --commands` does for its reader
  }

  std::atomic<int> overlays_drawn{0};
  int slices_drawn = 0, checks = 0;

 private:
  const Stage& stage_;
  double overlay_s_ = 0, slices_s_ = 0;
  std::int64_t checked_minute_ = -1;
  pictures::OverlayWorker overlays_;  // last, because its thread must end first
};

struct Counted {
  int pulses = 0, waiting = 0, overlays = 0, slices = 0, checks = 0;
  std::string failure;
  fs::path folder;
};

using Look = std::function<void(const steps::Treatment&, const Window&)>;

Counted runAll(const Stage& stage, const FilmOrder& order, const std::shared_ptr<Meter>& meter,
               const Look& look = {}) {
  auto pulses = std::make_unique<FilmPulses>();
  auto* teller = pulses.get();
  steps::TreatmentRequest request{stage.store, stage.recording.recording, true, stage.recording.coil,
                                  stage.alignment};
  request.override = steps::SignOffOverride{"benchmark", "virtual patient"};
  steps::TreatmentDevices devices;
  devices.makeNavigator = [&](const session::NavigatorSetup& setup) { return stage.navigator(setup, meter); };
  devices.openSource = [&] {
    return std::make_unique<FilmSource>(stage.film, order, meter,
                                        [teller](Timestamp at) { teller->tell(at); });
  };
  steps::Treatment treatment(steps::prepareTreatment(request, devices),
                             steps::chosenTarget(stage.target, stage.alignment.get()));
  treatment.listen(std::move(pulses));
  Window window(stage);
  while (!treatment.session().hasEnded()) {
    window.look(treatment);
    if (look) look(treatment, window);
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  Counted counted{treatment.log().pulses(),
                  treatment.log().pulsesWaiting(),
                  window.overlays_drawn,
                  window.slices_drawn,
                  window.checks,
                  treatment.log().failure(),
                  treatment.log().folder()};
  treatment.end();
  return counted;
}

void append(Times& all, Times more) {
  all.wall_ms.insert(all.wall_ms.end(), more.wall_ms.begin(), more.wall_ms.end());
  all.thread_ms.insert(all.thread_ms.end(), more.thread_ms.begin(), more.thread_ms.end());
}

void row(const char* name, const Times& times) {
  using support::quantile;
  std::printf("| %s | %zu | %.2f | %.2f | %.2f | %.2f | %.2f |\n", name, times.wall_ms.size(),
              quantile(times.wall_ms, 0.5), quantile(times.wall_ms, 0.99), quantile(times.wall_ms, 1.0),
              quantile(times.thread_ms, 0.5), quantile(times.thread_ms, 0.99));
}

void compare(const Stage& stage) {
  Times plain, all;
  Counted sum;
  FilmOrder order;
  order.frames = kFramesPerRound;
  for (int round = 0; round < kRounds; ++round) {
    auto meter = std::make_shared<Meter>();
    runPlain(stage, order, meter);
    append(plain, meter->take());
    meter = std::make_shared<Meter>();
    const auto counted = runAll(stage, order, meter);
    append(all, meter->take());
    sum.pulses += counted.pulses, sum.overlays += counted.overlays, sum.slices += counted.slices;
    sum.checks += counted.checks;
  }
  std::printf(
      "\n## A whole session beside plain tracking, 60 frames a second, %d rounds of %d frames in turn\n\n"
      "| what | frames | head + coil, wall clock: median, ms | p99 | max | tracking thread, processor time: "
      "median, ms | p99 |\n|---|---|---|---|---|---|---|\n",
      kRounds, kFramesPerRound);
  row("plain: head and coil", plain);
  row("everything on", all);
  std::printf(
      "\np99, everything on beside plain: %.2f times (wall clock), %.2f times (processor time). "
      "%d pulses kept, %d overlays, %d times two slices, %d checks.\n",
      support::quantile(all.wall_ms, 0.99) / support::quantile(plain.wall_ms, 0.99),
      support::quantile(all.thread_ms, 0.99) / support::quantile(plain.thread_ms, 0.99), sum.pulses,
      sum.overlays, sum.slices, sum.checks);
}

double memory_mb() {
  std::ifstream file("/proc/self/statm");
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * 4096 / 1e6;
}

void runLong(const Stage& stage, std::int64_t frames) {
  std::printf(
      "| frames | processor time: median, ms | p99 | max | wall clock: p99 | memory, MB | pulses | "
      "waiting | log |\n|---|---|---|---|---|---|---|---|---|\n");
  FilmOrder order;
  order.frames = frames;
  order.is_paced = false;
  order.train_of = 20;
  order.pause = 1180;  // a train every two minutes: 4800 pulses in eight hours
  const auto meter = std::make_shared<Meter>();
  std::int64_t next = kFramesPerBlock;
  const auto counted = runAll(stage, order, meter, [&](const steps::Treatment& treatment, const Window&) {
    if (meter->done() < next) return;
    const Times times = meter->take();
    using support::quantile;
    std::printf("| %lld | %.2f | %.2f | %.2f | %.2f | %.1f | %d | %d | %s |\n", (long long)meter->done(),
                quantile(times.thread_ms, 0.5), quantile(times.thread_ms, 0.99), quantile(times.thread_ms, 1),
                quantile(times.wall_ms, 0.99), memory_mb(), treatment.log().pulses(),
                treatment.log().pulsesWaiting(), treatment.log().failure().c_str());
    std::fflush(stdout);
    next += kFramesPerBlock;
  });
  std::printf("\n%d pulses kept, %d waiting, %d overlays, %d times two slices, %d checks %s\n",
              counted.pulses, counted.waiting, counted.overlays, counted.slices, counted.checks,
              counted.failure.c_str());
}

}  // namespace

/// session_benchmark [--case CASE --recording RECORDING] [--frames N]
int main(int count, char** words) {
  support::TemporaryFolder folder;
  Places places{folder.path() / "case", folder.path() / "recording"};
  std::int64_t frames = 0;
  bool is_given = false;
  for (int i = 1; i + 1 < count; i += 2) {
    if (!std::strcmp(words[i], "--case")) places.case_folder = words[i + 1], is_given = true;
    if (!std::strcmp(words[i], "--recording")) places.recording = words[i + 1];
    if (!std::strcmp(words[i], "--frames")) frames = std::atoll(words[i + 1]);
  }
  if (!is_given && !fs::exists(support::virtualPatientMri())) {
    std::printf("\nThe virtual patient's MRI is not here: the session benchmark is left out.\n");
    return 0;
  }
  auto all = methods();
  if (!is_given) make(all, places);
  const Stage stage = stageOf(places, std::move(all));
  frames > 0 ? runLong(stage, frames) : compare(stage);
  return 0;
}
