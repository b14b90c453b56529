#pragma once
// A case, a recording and services for tests of Treat: trackers that always see head and coil, the coil at
// the planned target.

#include <filesystem>
#include <memory>

#include "facenav/capture/recording.h"
#include "gui_fixtures.h"
#include "shell/services.h"
#include "support/shared_recording.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::ui::treat_fixtures {

namespace fakes = session::fakes;

inline const RigidTransform<Camera, Marker> kMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});

/// Trackers that always see head and coil; the coil is at the planned target.
inline Services fakeServices() {
  Services services;
  services.align = [](const casefile::CaseStore&, const capture::Recording&, const HeadKnown&, TaskMonitor&) {
    steps::AlignmentOutcome outcome;
    outcome.result.camera_T_mri = fakes::cameraAtReference();
    outcome.reference.frame = *fakes::frame(0, 0);
    return outcome;
  };
  services.makeNavigator = [](const session::NavigatorSetup& setup) {
    return std::make_unique<session::Navigator>(
        setup, std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
        std::make_unique<fakes::Coil>(kMarker));
  };
  return services;
}

inline std::filesystem::path writeRecording(const std::filesystem::path& folder, int frames) {
  testing::shareRecording(
      std::to_string(frames),
      [&](const std::filesystem::path& place) {
        capture::RecordingWriter writer(place, fakes::rig());
        for (int i = 0; i < frames; ++i) writer.add(*fakes::frame(i, i * 0.02));
        writer.close();
      },
      folder / "recording");
  return folder / "recording";
}

/// A ball case with a target under the coil; signed off on request.
inline std::filesystem::path plannedCase(const std::filesystem::path& folder, bool is_signed_off) {
  const auto case_folder = fixtures::writeBallCase(folder);
  guidance::TreatmentPlan plan;
  plan.targets.push_back(fakes::targetAt(kMarker.reframe<Camera, Coil>()).target);
  const auto store = casefile::CaseStore::open(case_folder);
  store.setTargets(plan);
  if (is_signed_off) casefile::signOff(store, {"XY", "", true});
  return case_folder;
}

}  // namespace facenav::ui::treat_fixtures
