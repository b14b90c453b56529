// The projector of the virtual room, calibrated from a face that it lights, as live cameras would see it.

#include <gmock/gmock.h>

#include "egg_patient.h"
#include "facenav/room/synthetic_source.h"
#include "facenav/workflow/projector_run.h"

namespace facenav::room {
namespace {

TEST(ProjectorRoom, AFaceCalibratesTheProjector) {
  ScenarioOptions options;
  options.exposure = 0.5;  // with the usual one the skin is white in the projector's full light
  SyntheticSource source(options, facenav::testing::eggPatient());
  const auto truth = source.projector();
  workflow::ProjectorRun run(source.rig(), {truth.width_px, truth.height_px, 16});
  run.startScene();
  for (int i = 0; run.isShowing(); ++i) {
    run.shown(i);
    auto early = cameras::StereoFrame();
    early.captured = {i + 0.05};  // the projector does not show the new picture yet
    run.add(early);
    auto frame = source.captureShowing(run.picture());
    frame.captured = {i + 0.5};
    run.add(frame);
  }
  ASSERT_TRUE(run.result()) << run.words();
  const auto& found = run.result()->projector;
  std::printf("%s; %d places, %d left out, median of others %.3f px\n", run.words().c_str(),
              run.result()->places, run.result()->left_out, run.result()->held_out_px);
  EXPECT_LT(run.result()->held_out_px, 0.5);
  double worst_px = 0;
  for (const double x : {-50.0, 0.0, 50.0})
    for (const double y : {-50.0, 0.0, 50.0}) {
      const Eigen::Vector3d at(60 + x, y, 590);  // on the face, in the left camera
      worst_px = std::max(worst_px, (cameras::project(truth.lens, truth.projector_T_camera.isometry() * at) -
                                     cameras::project(found.lens, found.projector_T_camera.isometry() * at))
                                        .norm());
    }
  std::printf("worst place on the face: %.2f px\n", worst_px);
  EXPECT_LT(worst_px, 2.0);
}

}  // namespace
}  // namespace facenav::room
