// The slices along the coil's axis, overlays, dose and coil of Plan, and the slices of Treat.

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <algorithm>
#include <cstdio>
#include <fstream>

#include "facenav/casefile/protocol.h"
#include "facenav/core/processor_time.h"
#include "facenav/volume/nifti.h"
#include "gui_fixtures.h"
#include "plan/map_legend.h"
#include "plan/overlay_presenter.h"
#include "plan/plan_presenter.h"
#include "treat/live_slices.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::ui {
namespace {

class PlanViews : public ::testing::Test {
 protected:
  PlanViews() : plan_(model_) {
    model_.open(fixtures::loadBallCase(folder_.path()));
    QObject::connect(&plan_, &PlanPresenter::refused, [this](const QString& words) { refusal_ = words; });
    plan_.addTarget(Point<Mri>(-40, 5, 60));
  }
  std::filesystem::path write(const char* name, const std::string& content) {
    std::ofstream(folder_.path() / name) << content;
    return folder_.path() / name;
  }
  testing::TemporaryFolder folder_;
  CaseModel model_;
  PlanPresenter plan_;
  QString refusal_;
};

/// State with the coil at the target, seen by a camera.
session::NavigationState stateAt(const guidance::Target& target) {
  session::NavigationState state;
  const auto camera_T_mri = session::fakes::cameraAtReference();
  state.camera_T_mri = Tracked<RigidTransform<Camera, Mri>>(camera_T_mri, 0.9);
  state.camera_T_coil =
      Tracked<RigidTransform<Camera, Coil>>(camera_T_mri * target.mri_T_target.reframe<Mri, Coil>(), 0.9);
  state.chosen = std::make_shared<session::ChosenTarget>(session::ChosenTarget{target, 1.2});
  state.target = target.name;
  state.guidance.predicted_error_mm = 1.2;
  return state;
}

TEST_F(PlanViews, LiveSlicesShowNothingOfALostPose) {
  LiveSlices slices;
  slices.resize(300, 400);
  slices.show(model_.current());
  const auto seen = stateAt(*plan_.active());
  slices.follow(seen, "hold");
  for (auto* view : slices.views()) {
    EXPECT_TRUE(view->showsSlice());
    EXPECT_EQ(view->boundWords(), "") << "the bound is not known";
  }
  slices.follow(seen, "hold", 1.62);
  EXPECT_EQ(slices.views()[1]->boundWords(), "ring: 95 % within 1.6 mm");
  const QImage live = slices.views()[0]->grab().toImage();
  session::NavigationState coil_lost = seen;
  coil_lost.camera_T_coil = Lost{LostReason::no_marker};
  slices.follow(coil_lost, "COIL NOT SEEN");
  const auto expectBlank = [&](const QString& words) {
    for (auto* view : slices.views()) {
      EXPECT_FALSE(view->showsSlice());
      EXPECT_EQ(view->words(), words);
      EXPECT_NE(view->grab().toImage(), live);
    }
    // Only words on black: the bright skin of the ball is gone.
    const QImage blank = slices.views()[0]->grab().toImage();
    int bright = 0;
    for (int y = 0; y < blank.height(); ++y)
      for (int x = 0; x < blank.width(); ++x) bright += qGray(blank.pixel(x, y)) > 150;
    EXPECT_LT(bright, blank.width() * blank.height() / 50);
  };
  expectBlank("COIL NOT SEEN");
  slices.follow(seen, "hold");
  EXPECT_TRUE(slices.views()[0]->showsSlice());
  slices.follow(session::blanked(seen, LostReason::stale), "NO IMAGES");
  expectBlank("NO IMAGES");
}

TEST_F(PlanViews, LiveSlicesSayHowFarTheBeamPasses) {
  LiveSlices slices;
  slices.show(model_.current());
  auto target = *plan_.active();
  auto state = stateAt(target);
  const RigidTransform<Coil, Coil> aside(Eigen::Quaterniond::Identity(), {3, 0, 0});
  state.camera_T_coil = Tracked<RigidTransform<Camera, Coil>>(state.camera_T_coil.value() * aside, 0.9);
  slices.follow(state, {});
  EXPECT_TRUE(slices.views()[1]->caption().contains("beam 3.0 mm off"))
      << slices.views()[1]->caption().toStdString();
}

TEST_F(PlanViews, TheTimeOfOneUpdateIsPrinted) {
  LiveSlices slices;
  slices.resize(320, 500);
  slices.show(model_.current());
  const auto state = stateAt(*plan_.active());
  std::vector<double> updates_ms;
  for (int i = 0; i < 60; ++i) {
    auto moved = state;
    const RigidTransform<Coil, Coil> by(
        Eigen::Quaterniond(Eigen::AngleAxisd(0.01 * i, Eigen::Vector3d::UnitZ())), {0.1 * i, 0, 0});
    moved.camera_T_coil = Tracked<RigidTransform<Camera, Coil>>(state.camera_T_coil.value() * by, 0.9);
    const double begun_ms = processorTime_ms();
    slices.follow(moved, {});
    for (auto* view : slices.views()) view->grab();
    updates_ms.push_back(processorTime_ms() - begun_ms);
  }
  std::sort(updates_ms.begin(), updates_ms.end());
  std::printf("two live slices of 320 x 248: %.1f ms of processor time an update (median), %.1f at most\n",
              updates_ms[30], updates_ms.back());
}

TEST_F(PlanViews, AnOverlayIsAddedChangedAndRemoved) {
  volume::Volume map = *model_.current().mri;
  for (std::size_t i = 0; i < map.voxels.size(); ++i) map.voxels[i] = i % 3 ? 0.5f * float(i % 7) : -1.f;
  volume::writeNifti(map, folder_.path() / "map.nii.gz");
  OverlayPresenter overlays(model_);
  MapLegend legend(overlays);
  EXPECT_TRUE(legend.isHidden());
  overlays.add(QString::fromStdString((folder_.path() / "map.nii.gz").string()),
               casefile::OverlaySpace::native, "tapping");
  ASSERT_TRUE(fixtures::waitFor([&] { return !overlays.entries().empty(); }));
  ASSERT_EQ(overlays.shown().size(), 1u);
  EXPECT_FALSE(legend.isHidden());
  auto entry = overlays.entries()[0];
  entry.opacity = 0.2, entry.threshold = 1.5;
  overlays.change(entry);
  EXPECT_EQ(overlays.shown()[0].opacity, 0.2);
  EXPECT_EQ(overlays.shown()[0].threshold, 1.5);
  EXPECT_EQ(casefile::readOverlays(model_.current().store.folder())[0].threshold, 1.5);
  OverlayPresenter again(model_);  // as after a restart
  model_.open(std::make_shared<LoadedCase>(model_.current()));
  ASSERT_TRUE(fixtures::waitFor([&] { return again.shown().size() == 1; }));
  overlays.remove("tapping");
  EXPECT_TRUE(overlays.shown().empty());
  EXPECT_TRUE(legend.isHidden());
}

TEST_F(PlanViews, AnOverlayRemovedAndAddedInAnotherSpaceIsDrawnOnce) {
  volume::Volume map = *model_.current().mri;
  for (std::size_t i = 0; i < map.voxels.size(); ++i) map.voxels[i] = 0.25f * float(i % 7);
  volume::writeNifti(map, folder_.path() / "map.nii.gz");
  const QString file = QString::fromStdString((folder_.path() / "map.nii.gz").string());
  OverlayPresenter overlays(model_);
  overlays.add(file, casefile::OverlaySpace::native, "map");
  ASSERT_TRUE(fixtures::waitFor([&] { return overlays.shown().size() == 1; }));
  overlays.remove("map");
  EXPECT_TRUE(overlays.shown().empty());
  for (auto& value : map.voxels) value += 0.5f;  // another file of the same name
  volume::writeNifti(map, folder_.path() / "map.nii.gz");
  overlays.add(file, casefile::OverlaySpace::native, "map");
  ASSERT_TRUE(fixtures::waitFor([&] { return !overlays.isBusy() && !overlays.entries().empty(); }));
  ASSERT_EQ(overlays.shown().size(), 1u) << "the removed one is drawn, too";
  ASSERT_TRUE(overlays.shown()[0].map);
  EXPECT_EQ(overlays.shown()[0].map->at(0, 0, 0), 0.5f) << "the new one";
}

TEST_F(PlanViews, ADamagedOverlayIsRefusedInWords) {
  OverlayPresenter overlays(model_);
  QString words;
  QObject::connect(&overlays, &OverlayPresenter::refused, [&](const QString& each) { words = each; });
  overlays.add(QString::fromStdString(write("a.trk", "TRACK but not much more").string()), std::nullopt, {});
  ASSERT_TRUE(fixtures::waitFor([&] { return !words.isEmpty(); }));
  EXPECT_TRUE(words.contains("a.trk"));
  EXPECT_TRUE(overlays.entries().empty());
}

TEST_F(PlanViews, TheTargetsDoseAndTheProtocolAreKept) {
  EXPECT_EQ(plan_.protocolWords(), "none");
  plan_.setProtocol(QString::fromStdString(
      write("p.json", R"({"name": "M1 10 Hz", "version": 2, "pulses": 3000, "trains": 60, "frequency_hz": 10,
                          "pause_s": 25})")
          .string()));
  EXPECT_EQ(plan_.protocolWords(), "'M1 10 Hz', version 2: 3000 pulses");
  ASSERT_TRUE(plan_.doseInForce());
  EXPECT_EQ(plan_.doseInForce()->pulses, 3000);
  EXPECT_FALSE(plan_.durationWords().isEmpty());
  guidance::Dose own;
  own.pulses = 600, own.frequency_hz = 1, own.output_pct = 52;
  plan_.setDose(own);
  EXPECT_EQ(model_.current().store.targets().targets[0].dose, own);
  plan_.undo();
  EXPECT_FALSE(plan_.active()->dose);
  own.pulses = 0;
  plan_.setDose(own);
  EXPECT_FALSE(refusal_.isEmpty());
  EXPECT_FALSE(plan_.active()->dose);
  plan_.removeProtocol();
  EXPECT_FALSE(plan_.doseInForce());
}

TEST_F(PlanViews, TargetsRestOnTheCasesOwnCoil) {
  const auto usual_mm = plan_.slicedCoil()->plate.outline_mm.size();
  plan_.setCoil(QString::fromStdString(
      write("coil.json",
            R"({"name": "small", "contact_outline_mm": [[-20, -20], [20, -20], [20, 20], [-20, 20]]})")
          .string()));
  EXPECT_EQ(plan_.coilWords(), "small");
  EXPECT_EQ(plan_.slicedCoil()->plate.outline_mm.size(), 4u);
  EXPECT_NE(usual_mm, 4u);
  EXPECT_EQ(steps::plannedHead(model_.current().store).plate.outline_mm.size(), 4u) << "the command line's";
  plan_.setCoil(QString::fromStdString(write("bad.json", "{}x").string()));
  EXPECT_FALSE(refusal_.isEmpty());
  EXPECT_EQ(plan_.coilWords(), "small");
}

}  // namespace
}  // namespace facenav::ui
