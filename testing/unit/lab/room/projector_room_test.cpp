// The projector of the virtual room, calibrated from a face that it lights, as live cameras would see it.

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "egg_patient.h"
#include "facenav/room/synthetic_source.h"
#include "facenav/setup/projector_run.h"

namespace facenav::room {
namespace {

TEST(ProjectorRoom, AFaceCalibratesTheProjector) {
  ScenarioOptions options;
  options.exposure = 0.5;  // with the usual one the skin is white in the projector's full light
  SyntheticSource source(options, facenav::testing::eggPatient());
  const auto truth = source.projector();
  steps::ProjectorRun run(source.rig(), {truth.width_px, truth.height_px, 16});
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

/// Mistakes that a person makes: each gives one sentence and no calibration.
class ProjectorMistakes : public ::testing::Test {
 protected:
  ProjectorMistakes() {
    options_.exposure = 0.5;
    source_ = std::make_unique<SyntheticSource>(options_, facenav::testing::eggPatient());
    const auto truth = source_->projector();
    run_ = std::make_unique<steps::ProjectorRun>(source_->rig(),
                                                 stereo::ProjectorCode{truth.width_px, truth.height_px, 16});
  }
  void take(const std::function<cameras::StereoFrame(int, const cv::Mat&)>& photograph) {
    run_->startScene();
    for (int i = 0; run_->isShowing(); ++i) {
      run_->shown(i);
      auto frame = photograph(i, run_->picture());
      frame.captured = {i + 0.5};
      run_->add(frame);
    }
  }
  ScenarioOptions options_;
  std::unique_ptr<SyntheticSource> source_;
  std::unique_ptr<steps::ProjectorRun> run_;
};

TEST_F(ProjectorMistakes, AProjectorThatIsOffIsSaid) {
  const auto dark = source_->captureShowing(
      cv::Mat::zeros(cv::Size(source_->projector().width_px, source_->projector().height_px), CV_8U));
  take([&](int, const cv::Mat&) { return dark; });
  EXPECT_THAT(run_->words(), ::testing::HasSubstr("the projector's light is not seen: switch it on"));
  EXPECT_FALSE(run_->result());
}

/// The face is shifted by up to six pixels in the later pictures.
TEST_F(ProjectorMistakes, AHeadThatMovesIsSaidAndLeftOut) {
  take([&](int i, const cv::Mat& picture) {
    auto frame = source_->captureShowing(picture);
    for (cv::Mat* image : {&frame.left, &frame.right}) {
      const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, 0.5 * i, 0, 1, 0);
      cv::warpAffine(*image, *image, shift, image->size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    }
    return frame;
  });
  EXPECT_FALSE(run_->result()) << run_->words();
  EXPECT_THAT(run_->words(), ::testing::HasSubstr("something moved while the pictures were taken"));
}

TEST_F(ProjectorMistakes, CamerasThatGiveNoPictureEndTheScene) {
  run_->startScene();
  run_->shown(10.0);
  run_->wait(11.0);
  EXPECT_TRUE(run_->isShowing());
  run_->wait(13.5);
  EXPECT_FALSE(run_->isShowing());
  EXPECT_THAT(run_->words(), ::testing::HasSubstr("the cameras give no picture"));
  EXPECT_FALSE(run_->result());
}

}  // namespace
}  // namespace facenav::room
