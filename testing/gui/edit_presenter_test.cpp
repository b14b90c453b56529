#include "prepare/edit_presenter.h"

#include <gtest/gtest.h>

#include "facenav/casefile/edited_brain.h"
#include "facenav/scene/navigation_scene.h"
#include "gui_fixtures.h"
#include "prepare/sign_off_presenter.h"

namespace facenav::ui {
namespace {

class EditPresenterTest : public ::testing::Test {
 protected:
  EditPresenterTest() : edit_(model_, tasks_) {
    casefile::CaseStore::create(folder_.path() / "case", fixtures::ballWithBrain(), {}, false);
    open();
    plane_ =
        volume::anatomicalPlane(model_.current().mri->grid, volume::Anatomical::axial, Point<Mri>(0, 0, 2));
  }
  void open() {
    TaskMonitor monitor;
    model_.open(loadCase(folder_.path() / "case", monitor));
  }
  Eigen::Vector2d pixel(double x_mm, double y_mm) const {
    return plane_.toPixel(Point<Mri>(x_mm, y_mm, 2)).head<2>();
  }
  void stroke(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool is_inverse = false) {
    edit_.press(plane_, from, is_inverse);
    edit_.drag(plane_, to);
    edit_.release(plane_);
  }
  bool isBrain(double x_mm, double y_mm, double z_mm = 2) const {
    const Eigen::Vector3d v = edit_.mask()->grid.toVoxel(Point<Mri>(x_mm, y_mm, z_mm));
    return edit_.mask()->at(int(std::lround(v.x())), int(std::lround(v.y())), int(std::lround(v.z())));
  }
  void settle() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  testing::TemporaryFolder folder_;
  CaseModel model_;
  TaskRunner tasks_;
  EditPresenter edit_;
  volume::SlicePlane plane_;
};

TEST_F(EditPresenterTest, ABrushStrokeIsOneStepInTheSliceShownAndComesBack) {
  edit_.setTool(EditTool::brush);
  edit_.setRadius_mm(6);
  EXPECT_TRUE(edit_.isActive());
  EXPECT_FALSE(isBrain(60, 0));
  stroke(pixel(50, 0), pixel(70, 0));
  EXPECT_TRUE(isBrain(50, 0) && isBrain(60, 0) && isBrain(70, 0));
  EXPECT_FALSE(isBrain(60, 0, 6));  // the next slice is unchanged: a disc, not a ball
  edit_.undo();
  EXPECT_FALSE(isBrain(50, 0) || isBrain(70, 0));
  EXPECT_FALSE(edit_.canUndo());
  edit_.redo();
  EXPECT_TRUE(isBrain(60, 0));
}

TEST_F(EditPresenterTest, EraserAndShiftTakeAwayAndABallReachesTheNextSlice) {
  edit_.setRadius_mm(6);
  edit_.setTool(EditTool::eraser);
  stroke(pixel(0, 0), pixel(10, 0));
  EXPECT_FALSE(isBrain(0, 0) || isBrain(10, 0));
  EXPECT_TRUE(isBrain(0, 0, 6));
  edit_.setBall(true);
  edit_.setTool(EditTool::brush);
  stroke(pixel(-20, 0), pixel(-20, 0), true);
  EXPECT_FALSE(isBrain(-20, 0) || isBrain(-20, 0, 6));
}

TEST_F(EditPresenterTest, ALassoAddsWhatItSurroundsWhenItIsLetGo) {
  edit_.setTool(EditTool::lasso);
  edit_.press(plane_, pixel(50, -20), false);
  for (const auto& corner : {pixel(75, -20), pixel(75, 20), pixel(50, 20)}) edit_.drag(plane_, corner);
  EXPECT_EQ(edit_.outline().size(), 4u);
  EXPECT_FALSE(isBrain(62, 0));
  edit_.release(plane_);
  EXPECT_TRUE(isBrain(62, 0));
  EXPECT_TRUE(edit_.outline().empty());
}

TEST_F(EditPresenterTest, SavingStoresMaskAndModelKeepsTheAutomaticOneAndVoidsTheSignOff) {
  casefile::signOff(model_.current().store, {"XY", "", true});
  open();
  ASSERT_TRUE(model_.mayBeTreated());
  const auto before = *model_.current().brain_mask;
  edit_.setTool(EditTool::brush);
  stroke(pixel(44, 0), pixel(48, 0));
  ASSERT_TRUE(edit_.hasUnsaved());
  EXPECT_FALSE(model_.mayBeTreated());  // the mask shown now is unchecked
  edit_.save();
  settle();
  EXPECT_FALSE(edit_.hasUnsaved());
  EXPECT_FALSE(model_.mayBeTreated());
  EXPECT_TRUE(model_.current().sign_off.last.has_value());
  EXPECT_EQ(model_.current().store.brainMask()->voxels, edit_.mask()->voxels);
  EXPECT_EQ(model_.current().brain_mask->voxels, edit_.mask()->voxels);
  EXPECT_EQ(casefile::automaticBrainMask(model_.current().store)->voxels, before.voxels);
  EXPECT_EQ(model_.current().shown_sha256, casefile::seenFiles(model_.current().store));
  EXPECT_TRUE(std::filesystem::exists(model_.current().store.folder() / "surface_distance.png"));
  edit_.resetToAutomatic();
  EXPECT_EQ(edit_.mask()->voxels, before.voxels);
  edit_.undo();
  EXPECT_TRUE(isBrain(46, 0));
}

TEST_F(EditPresenterTest, AnUndoneStrokeLeavesNothingUnsaved) {
  casefile::signOff(model_.current().store, {"XY", "", true});
  open();
  edit_.setTool(EditTool::brush);
  stroke(pixel(44, 0), pixel(48, 0));
  ASSERT_TRUE(edit_.hasUnsaved());
  ASSERT_TRUE(fixtures::waitFor([&] { return casefile::hasBrainDraft(model_.current().store); }));
  edit_.undo();
  EXPECT_FALSE(edit_.hasUnsaved());
  EXPECT_FALSE(casefile::hasBrainDraft(model_.current().store)) << "the autosaved stroke is gone, too";
  EXPECT_TRUE(model_.mayBeTreated()) << "the sign-off holds again";
  edit_.redo();
  EXPECT_TRUE(edit_.hasUnsaved());
  EXPECT_FALSE(model_.mayBeTreated());
}

TEST_F(EditPresenterTest, ACheckedCaseIsCheckedNoMoreFromTheFirstStrokeAndAgainOnceItIsDiscarded) {
  casefile::signOff(model_.current().store, {"XY", "", true});
  open();
  SignOffPresenter sign_off(model_, tasks_);
  ASSERT_TRUE(sign_off.holds());
  EXPECT_TRUE(sign_off.statusWords().startsWith("checked"));
  edit_.setTool(EditTool::brush);
  edit_.setRadius_mm(20);
  edit_.press(plane_, pixel(44, 0), false);  // before the button is released
  EXPECT_FALSE(sign_off.holds());
  EXPECT_TRUE(sign_off.statusWords().contains("a correction of the brain is not saved"));
  edit_.release(plane_);
  EXPECT_EQ(model_.current().shownBrain()->voxels, edit_.mask()->voxels);
  const QString volume = QString("brain %1 ml").arg(std::lround(edit_.mask()->volume_ml()));
  EXPECT_TRUE(sign_off.volumes()[0].words.contains(volume)) << sign_off.volumes()[0].words.toStdString();
  EXPECT_TRUE(sign_off.volumes()[0].words.contains("not saved"));
  sign_off.setName("XY");
  for (int i = 0; i < sign_off.items().size(); ++i) sign_off.setSeen(i, true);
  EXPECT_FALSE(sign_off.canSign());  // the shown mask differs from the one that would be signed
  EXPECT_TRUE(sign_off.whatIsMissing().contains("save or discard"));
  edit_.discard();
  EXPECT_TRUE(sign_off.holds());
  EXPECT_TRUE(model_.mayBeTreated());
  EXPECT_EQ(model_.current().shownBrain(), model_.current().brain_mask);
}

TEST_F(EditPresenterTest, ADraftOutlivesTheProgramAndCanBeThrownAway) {
  {
    EditPresenter other(model_, tasks_);
    open();
    other.setTool(EditTool::brush);
    other.press(plane_, pixel(60, 0), false);
    other.release(plane_);
  }  // closed without saving
  open();
  EXPECT_TRUE(isBrain(60, 0));
  EXPECT_TRUE(edit_.hasUnsaved());
  edit_.discard();
  EXPECT_FALSE(isBrain(60, 0));
  EXPECT_FALSE(edit_.hasUnsaved());
  EXPECT_FALSE(casefile::brainDraft(model_.current().store));
}

TEST_F(EditPresenterTest, AWindowThatClosesDuringASaveKeepsTheStrokesBeforeAndDuringIt) {
  {
    TaskRunner tasks;
    EditPresenter other(model_, tasks);  // closes first, as in the window; then the save is cancelled
    open();
    other.setTool(EditTool::brush);
    other.press(plane_, pixel(60, 0), false);
    other.release(plane_);
    other.save();
    ASSERT_TRUE(tasks.isRunning());
    other.press(plane_, pixel(-60, 0), false);
    other.release(plane_);
  }
  open();
  EXPECT_TRUE(isBrain(60, 0)) << "painted before the save";
  EXPECT_TRUE(isBrain(-60, 0)) << "painted during the save";
  EXPECT_TRUE(edit_.hasUnsaved());
}

TEST_F(EditPresenterTest, StrokesDuringASaveStayADraftAndTheNextSaveTakesThem) {
  edit_.setTool(EditTool::brush);
  stroke(pixel(60, 0), pixel(60, 0));
  edit_.save();
  stroke(pixel(-60, 0), pixel(-60, 0));
  settle();
  const auto& store = model_.current().store;
  EXPECT_TRUE(edit_.hasUnsaved());
  EXPECT_TRUE(casefile::hasBrainDraft(store));
  EXPECT_TRUE(model_.current().sign_off.has_draft);
  EXPECT_NE(store.brainMask()->voxels, edit_.mask()->voxels);
  edit_.save();
  settle();
  EXPECT_FALSE(edit_.hasUnsaved());
  EXPECT_FALSE(casefile::hasBrainDraft(store));
  EXPECT_FALSE(model_.current().sign_off.has_draft);
  EXPECT_EQ(store.brainMask()->voxels, edit_.mask()->voxels);
}

TEST_F(EditPresenterTest, TheScalpelCutsBehindTheLineDownToItsDepthAndComesBack) {
  scene::NavigationScene scene;  // computed, not rendered: needs no display
  scene.setScalp(model_.current().scalp->mesh);
  scene.setView(scene::ViewPreset::front);  // along -y
  const auto seen = scene.projection(400, 300);
  const auto at = [&](double x_mm, double z_mm) {
    const Eigen::Vector4d h = seen.screen_from_mri * Eigen::Vector4d(x_mm, 40, z_mm, 1);
    return Eigen::Vector2d(h.head<2>() / h[3]);
  };
  EXPECT_GT(seen.eye.mm.y(), 100.0);
  edit_.setTool(EditTool::scalpel);
  EXPECT_FALSE(edit_.isActive());  // on slices the left button moves the crosshair
  edit_.setCutDepth_mm(12);
  edit_.cut({seen.screen_from_mri, seen.eye}, {at(-10, -10), at(10, -10), at(10, 14), at(-10, 14)});
  EXPECT_FALSE(isBrain(2, 36));
  EXPECT_FALSE(isBrain(2, 31));
  EXPECT_TRUE(isBrain(2, 20));   // deeper than the cut
  EXPECT_TRUE(isBrain(26, 24));  // beside the line
  EXPECT_TRUE(edit_.hasUnsaved());
  std::shared_ptr<const surface::BrainModel> followed;
  QObject::connect(&edit_, &EditPresenter::brainFollowed, [&](const auto& brain) { followed = brain; });
  EXPECT_TRUE(fixtures::waitFor([&] { return followed != nullptr; }));
  edit_.undo();
  EXPECT_TRUE(isBrain(2, 36));
  EXPECT_FALSE(edit_.canUndo());
}

TEST_F(EditPresenterTest, InterpolatesBetweenTheSlicesDrawnOn) {
  edit_.setTool(EditTool::brush);
  edit_.setRadius_mm(10);
  for (double z : {50.0, 66.0}) {  // above the brain's top, four slices apart
    plane_ =
        volume::anatomicalPlane(model_.current().mri->grid, volume::Anatomical::axial, Point<Mri>(0, 0, z));
    edit_.press(plane_, plane_.toPixel(Point<Mri>(0, 0, z)).head<2>(), false);
    edit_.release(plane_);
  }
  EXPECT_FALSE(isBrain(0, 0, 58));
  edit_.interpolate();
  EXPECT_TRUE(isBrain(0, 0, 58));
}

}  // namespace
}  // namespace facenav::ui
