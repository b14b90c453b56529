#pragma once
// Services, a recording and a case for tests of treatment at home. The trackers see what the test wants.

#include <atomic>

#include "facenav/casefile/sign_off.h"
#include "facenav/plan/expert_pose.h"
#include "treat_fixtures.h"

namespace facenav::ui::home_fixtures {

using namespace treat_fixtures;
namespace fs = std::filesystem;

/// Measurements that the trackers return, set by the test.
struct Seen {
  std::atomic<bool> head{true}, coil{true};
};

class SeenCoil : public coil_tracking::CoilTracker {
 public:
  SeenCoil(std::shared_ptr<Seen> seen, const RigidTransform<Camera, Marker>& pose)
      : seen_(std::move(seen)), coil_(pose) {}
  void start(const cameras::StereoRig&, const coil_tracking::CoilModel&) override {}
  coil_tracking::CoilResult track(const cameras::StereoFrame& frame,
                                  const coil_tracking::CoilContext& context) override {
    if (!seen_->coil) return Lost{LostReason::no_marker};
    return coil_.track(frame, context);
  }

 private:
  std::shared_ptr<Seen> seen_;
  fakes::Coil coil_;
};

/// Makes the services. `off`: offset of the coil from the target, in the coil's axes.
inline Services homeServices(std::shared_ptr<Seen> seen,
                             const Eigen::Vector3d& off_mm = Eigen::Vector3d::Zero(),
                             const std::string& refusal = {}) {
  Services services = fakeServices();
  if (!refusal.empty())
    services.align = [refusal](const casefile::CaseStore&, const capture::Recording&, const HeadKnown&,
                               TaskMonitor&) -> steps::AlignmentOutcome { throw Error(refusal); };
  services.makeNavigator = [seen, off_mm](const session::NavigatorSetup& setup) {
    const RigidTransform<Marker, Marker> off(Eigen::Quaterniond::Identity(), off_mm);
    return std::make_unique<session::Navigator>(
        setup, std::make_unique<fakes::Head>([seen](auto) {
          return seen->head ? std::optional(RigidTransform<Camera, Head>()) : std::nullopt;
        }),
        std::make_unique<SeenCoil>(seen, kMarker * off));
  };
  return services;
}

inline fs::path writeCapturedRecording(const fs::path& folder) {
  testing::shareRecording(
      "captured",
      [](const fs::path& place) {
        capture::RecordingWriter writer(place, fakes::rig());
        const auto frame = fakes::frame(0, 0);
        writer.setCapture({*frame, *frame});
        for (int i = 0; i < 2000; ++i) writer.add(*fakes::frame(i, i * 0.02));
        writer.close();
      },
      folder / "recording");
  return folder / "recording";
}

/// Writes a case as imported: a face, the expert's pose under the coil, the coil.
inline fs::path writeHomeCase(const fs::path& folder) {
  const auto store = casefile::CaseStore::createFromFace(
      folder / "home", {testing::ballCase().scalp, {"no MRI"}, {}, {}}, {}, false);
  auto target = fakes::targetAt(kMarker.reframe<Camera, Coil>()).target;
  target.expert = guidance::ExpertPose{"20260101T100000Z", 40, 0.6, 0.5, 0.4, "figure-8"};
  target.dose.emplace();
  target.dose->pulses = 200;
  store.setTargets({{target}});
  auto coil = coil_tracking::defaultCoil();
  coil.name = "figure-8";
  writeCoil(coil, store.folder() / "coil.json");
  casefile::signOff(store, {"clinic", "", true});
  return store.folder();
}

}  // namespace facenav::ui::home_fixtures
