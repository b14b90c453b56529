#include "treat/read_out.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "treat/figures_panel.h"

namespace facenav::ui {
namespace {

session::NavigationState trackedState() {
  session::NavigationState state;
  state.frame = 7;
  state.images = std::make_shared<cameras::StereoFrame>();
  state.is_aligned = true;
  state.head = {head_tracking::HeadPose{}, 0.9};
  state.coil = {coil_tracking::CoilPose{}, 0.9};
  state.camera_T_mri = {RigidTransform<Camera, Mri>(), 0.9};
  state.camera_T_coil = {RigidTransform<Camera, Coil>(), 0.9};
  state.target = "spot";
  guidance::Target target;
  state.chosen = std::make_shared<session::ChosenTarget>(session::ChosenTarget{target, 0.8, 1.4});
  const RigidTransform<Mri, Coil> coil(Eigen::Quaterniond::Identity(), {2.4, 0.0, -1.0});
  state.guidance = {
      guidance::State::adjust, guidance::Action::move, {}, guidance::evaluate(target, coil), 0.8, "move"};
  return state;
}

TEST(ReadOut, GivesMillimetresWithOneDecimalAndWholeDegrees) {
  const ReadOut out = makeReadOut(trackedState());
  EXPECT_EQ(out.across, "2.4");
  EXPECT_EQ(out.depth, "-1.0");
  EXPECT_EQ(out.tilt, QString("0") + QChar(0xb0));
  EXPECT_TRUE(out.instruction.startsWith("ADJUST"));
  EXPECT_EQ(out.predicted, "95 % within 1.4 mm at the target");
  EXPECT_EQ(out.face.level, Level::good);
}

TEST(ReadOut, TheSecondCoilHasItsOwnLineAndNoFigureWhenItIsLost) {
  EXPECT_TRUE(makeReadOut(trackedState()).second.isEmpty());
  auto state = trackedState();
  state.second.emplace();
  auto& second = *state.second;
  second.name = "B";
  EXPECT_EQ(makeReadOut(state).second, "B: NO NEW IMAGES");
  second.coil = Lost{LostReason::no_marker};
  EXPECT_EQ(makeReadOut(state).second, "B: COIL NOT SEEN");
  second.coil = {coil_tracking::CoilPose{}, 0.9};
  second.camera_T_coil = {RigidTransform<Camera, Coil>(), 0.9};
  EXPECT_EQ(makeReadOut(state).second, "B: tracked, no target");
  second.chosen = state.chosen;
  second.guidance = state.guidance;
  second.guidance.state = guidance::State::on_target;
  EXPECT_EQ(makeReadOut(state).second,
            QString("B: on target, across 2.4, depth -1.0 mm, tilt 0") + QChar(0xb0));
  EXPECT_EQ(makeReadOut(session::blanked(state, LostReason::stale)).second, "B: NO NEW IMAGES");
  EXPECT_TRUE(whilePaused(makeReadOut(state), "PAUSED").second.isEmpty());
}

TEST(ReadOut, BlanksEveryFigureWhenLostOrStale) {
  for (auto reason : {LostReason::no_face, LostReason::few_features, LostReason::camera, LostReason::stale}) {
    const ReadOut out = makeReadOut(session::blanked(trackedState(), reason));
    const QString dash(QChar(0x2013));
    EXPECT_EQ(out.across, dash);
    EXPECT_EQ(out.depth, dash);
    EXPECT_EQ(out.tilt, dash);
    EXPECT_EQ(out.twist, dash);
    EXPECT_TRUE(out.predicted.isEmpty());
    EXPECT_EQ(out.level, Level::lost);
    EXPECT_FALSE(out.instruction.isEmpty());
    // The tip has the problem and what to do, no code.
    EXPECT_TRUE(out.face.tip.contains(": ")) << out.face.tip.toStdString();
    EXPECT_EQ(out.face.tip.indexOf('_'), -1);
  }
}

TEST(ReadOut, WhilePausedNoFigureStandsAndNothingIsOnTarget) {
  auto state = trackedState();
  state.guidance.state = guidance::State::on_target;
  ASSERT_TRUE(makeReadOut(state).instruction.startsWith("ON TARGET"));
  const ReadOut out = whilePaused(makeReadOut(state), "PAUSED: coil too warm");
  EXPECT_EQ(out.instruction, "PAUSED: coil too warm");
  EXPECT_EQ(out.level, Level::idle);
  for (const QString& figure : {out.across, out.depth, out.tilt, out.twist})
    EXPECT_EQ(figure, QString(QChar(0x2013)));
  EXPECT_TRUE(out.predicted.isEmpty());
}

TEST(FiguresPanel, FiguresAreLegibleFromTwoMetres) {
  FiguresPanel panel;
  panel.ensurePolished();
  int figures = 0;
  for (const QLabel* label : panel.findChildren<QLabel*>()) {
    if (!label->objectName().startsWith("figure")) continue;
    label->ensurePolished();
    EXPECT_GE(label->font().pointSize(), 48);
    ++figures;
  }
  EXPECT_EQ(figures, 4);
  panel.set(makeReadOut(trackedState()));
  EXPECT_EQ(panel.figures()[0], "2.4");
  panel.set(makeReadOut(session::blanked(trackedState(), LostReason::stale)));
  EXPECT_EQ(panel.figures()[0], QString(QChar(0x2013)));
}

}  // namespace
}  // namespace facenav::ui
