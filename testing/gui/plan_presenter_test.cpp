#include "plan/plan_presenter.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QtTest/QTest>
#include <filesystem>

#include "facenav/guidance/handle.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "plan/handle_panel.h"
#include "plan/head_presenter.h"

namespace facenav::ui {
namespace {

class PlanPresenterTest : public ::testing::Test {
 protected:
  PlanPresenterTest() : presenter_(model_) {
    model_.open(fixtures::loadBallCase(folder_.path()));
    QObject::connect(&presenter_, &PlanPresenter::refused,
                     [this](const QString& words) { refusal_ = words; });
  }
  std::vector<std::string> storedNames() const {
    std::vector<std::string> names;
    for (const auto& t : model_.current().store.targets().targets) names.push_back(t.name);
    return names;
  }
  /// Adds a target on the ball's left side, not through the presenter; it becomes the active one.
  void plan(const std::string& name, double handle_deg, double gap_mm) {
    auto plan = model_.current().plan;
    plan.targets.push_back(guidance::planTarget(name, *model_.current().scalp, Point<Mri>(-40, 5, 60),
                                                handle_deg * M_PI / 180, gap_mm));
    model_.setPlan(plan);
    presenter_.setActive(QString::fromStdString(name));
  }
  testing::TemporaryFolder folder_;
  CaseModel model_;
  PlanPresenter presenter_;
  QString refusal_;
};

TEST_F(PlanPresenterTest, AClickMakesATargetThatIsStoredAtOnce) {
  presenter_.addTarget(Point<Mri>(-40, 5, 60));
  ASSERT_NE(presenter_.active(), nullptr);
  EXPECT_EQ(storedNames(), std::vector<std::string>{presenter_.activeName().toStdString()});
  EXPECT_NEAR(presenter_.active()->scalp_point.mm.norm(), 90.0, 1.0);
  EXPECT_NEAR(presenter_.handleAngle_deg(*presenter_.active()), 45.0, 1.0);
}

TEST_F(PlanPresenterTest, EveryStepCanBeUndoneAndDoneAgain) {
  presenter_.addTarget(Point<Mri>(-40, 5, 60));
  presenter_.addTarget(Point<Mri>(40, 5, 60));
  presenter_.renameActive("M1 hand R");
  EXPECT_EQ(storedNames().back(), "M1 hand R");
  presenter_.undo();
  EXPECT_NE(storedNames().back(), "M1 hand R");
  presenter_.undo();
  EXPECT_EQ(storedNames().size(), 1u);
  presenter_.redo();
  presenter_.redo();
  EXPECT_EQ(storedNames().back(), "M1 hand R");
  EXPECT_FALSE(presenter_.canRedo());
  presenter_.removeActive();
  EXPECT_EQ(storedNames().size(), 1u);
}

TEST_F(PlanPresenterTest, TurningKeepsPlaceAndAxis) {
  presenter_.addTarget(Point<Mri>(-40, 5, 60));
  const auto before = *presenter_.active();
  presenter_.turnActive(5);
  const auto after = *presenter_.active();
  EXPECT_LT((before.mri_T_target.translation_mm() - after.mri_T_target.translation_mm()).norm(), 1e-9);
  EXPECT_GT(before.mri_T_target.rotation().col(2).dot(after.mri_T_target.rotation().col(2)), 1 - 1e-9);
  const double turned_deg =
      std::acos(before.mri_T_target.rotation().col(1).dot(after.mri_T_target.rotation().col(1))) * 180 / M_PI;
  EXPECT_NEAR(turned_deg, 5.0, 1e-6);
}

TEST_F(PlanPresenterTest, RefusesASecondTargetOfTheSameNameAndAPointOutsideTheHead) {
  presenter_.addTarget(Point<Mri>(-40, 5, 60));
  const QString first = presenter_.activeName();
  presenter_.addTarget(Point<Mri>(40, 5, 60));
  presenter_.renameActive(first);
  EXPECT_TRUE(refusal_.contains(first));
  EXPECT_EQ(storedNames().size(), 2u);
  refusal_.clear();
  presenter_.addTarget(Point<Mri>(0, 0, 300));
  EXPECT_FALSE(refusal_.isEmpty());
  EXPECT_EQ(storedNames().size(), 2u);
}

TEST_F(PlanPresenterTest, ANudgeKeepsHandleAndGap) {
  for (const double planned_deg : {-90.0, -45.0, -10.0, 45.0}) {
    plan("spot " + std::to_string(planned_deg), planned_deg, 4.0);
    const Eigen::Vector3d before = presenter_.active()->mri_T_target.rotation().col(1);
    presenter_.nudgeActive(1, 0);
    const auto& moved = *presenter_.active();
    EXPECT_NEAR(presenter_.handleAngle_deg(moved), planned_deg, 5.0);  // the ball's facets are 6 degrees wide
    EXPECT_GT(before.dot(moved.mri_T_target.rotation().col(1)), std::cos(10 * M_PI / 180));
    EXPECT_NEAR(guidance::hairGap_mm(moved), 4.0, 1e-9);
  }
}

TEST_F(PlanPresenterTest, SaysOnWhichSideTheHandleLiesAndHowWideTheGapIs) {
  plan("to", 60, 4.0);
  plan("fro", -60, 0.0);
  const auto& targets = presenter_.plan().targets;
  EXPECT_TRUE(presenter_.describe(targets[0]).contains(QString::fromUtf8("handle +60\u00b0 from anterior")))
      << presenter_.describe(targets[0]).toStdString();
  EXPECT_TRUE(presenter_.describe(targets[0]).contains("gap 4.0 mm"));
  EXPECT_TRUE(presenter_.describe(targets[1]).contains(QString::fromUtf8("handle -60\u00b0 from anterior")));
  EXPECT_TRUE(presenter_.describe(targets[1]).contains("gap 0.0 mm"));
  const auto forehead = guidance::planTarget("front", *model_.current().scalp, Point<Mri>(2, 70, 5), 0.0);
  EXPECT_TRUE(presenter_.describe(forehead).contains(QString::fromUtf8("handle 0\u00b0 from superior")));
}

TEST_F(PlanPresenterTest, TakesTypedHandleAngleAndGapAndUndoesThem) {
  plan("spot", 45, 4.0);
  EXPECT_EQ(presenter_.handleFigure(), "+45");
  EXPECT_EQ(presenter_.gapFigure(), "4.0");
  presenter_.setHandle("-12,5");
  EXPECT_NEAR(presenter_.handleAngle_deg(*presenter_.active()), -12.5, 1e-6);
  EXPECT_EQ(presenter_.handleFigure(), "-12.5");
  presenter_.setHandle(QString::fromUtf8(" +30\u00b0"));
  EXPECT_NEAR(presenter_.handleAngle_deg(*presenter_.active()), 30, 1e-6);
  presenter_.setGap("6,5 mm");
  EXPECT_NEAR(guidance::hairGap_mm(*presenter_.active()), 6.5, 1e-9);
  EXPECT_NEAR(presenter_.handleAngle_deg(*presenter_.active()), 30, 1e-6);
  EXPECT_NEAR(guidance::hairGap_mm(model_.current().store.targets().targets[0]), 6.5, 1e-6);  // stored
  EXPECT_TRUE(refusal_.isEmpty()) << refusal_.toStdString();
  presenter_.undo();
  presenter_.undo();
  presenter_.undo();
  EXPECT_NEAR(guidance::hairGap_mm(*presenter_.active()), 4.0, 1e-9);
  EXPECT_NEAR(presenter_.handleAngle_deg(*presenter_.active()), 45, 1e-6);
}

TEST_F(PlanPresenterTest, RefusesAnAngleOrAGapThatCannotBeInOneLineAndChangesNothing) {
  plan("spot", 45, 4.0);
  const auto refuses = [&](QString (PlanPresenter::*set)(const QString&), const char* typed) {
    const QString why = (presenter_.*set)(typed);
    return !why.isEmpty() && !why.contains('\n') && !presenter_.canUndo();
  };
  for (const char* typed : {"", "left", "181", "-190", "nan", "1,2,3", "4 5"})
    EXPECT_TRUE(refuses(&PlanPresenter::setHandle, typed)) << typed;
  for (const char* typed : {"", "thick", "-1", "20,5", "400", "inf"})
    EXPECT_TRUE(refuses(&PlanPresenter::setGap, typed)) << typed;
  EXPECT_NEAR(guidance::hairGap_mm(*presenter_.active()), 4.0, 1e-9);
  EXPECT_TRUE(
      presenter_.setGap("99").startsWith("'99' is not taken: a gap for hair lies between 0 and 20 mm"))
      << presenter_.setGap("99").toStdString();
  presenter_.lockActive(true);
  EXPECT_TRUE(presenter_.setGap("5").contains("locked"));
}

TEST_F(PlanPresenterTest, TheFieldsShowTheActiveTargetAndGoBackToWhatHoldsWhenRefused) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  HandlePanel panel(presenter_);
  panel.show();
  const auto fields = panel.findChildren<QLineEdit*>();
  ASSERT_EQ(fields.size(), 2);
  EXPECT_FALSE(fields[0]->isEnabled());
  plan("spot", -10, 3.0);
  EXPECT_EQ(fields[0]->text(), "-10");
  EXPECT_EQ(fields[1]->text(), "3.0");
  const auto type = [](QLineEdit* field, const char* words) {
    field->selectAll();
    QTest::keyClicks(field, words);
    QTest::keyClick(field, Qt::Key_Return);
  };
  type(fields[0], "60");
  EXPECT_NEAR(presenter_.handleAngle_deg(*presenter_.active()), 60, 1e-6);
  EXPECT_EQ(fields[0]->text(), "+60");
  const auto fault = [&] {
    for (auto* label : panel.findChildren<QLabel*>("fault"))
      if (!label->isHidden()) return label->text();
    return QString();
  };
  type(fields[1], "99");
  EXPECT_TRUE(fault().contains("between 0 and 20 mm")) << fault().toStdString();
  EXPECT_EQ(fields[1]->text(), "3.0");
  QApplication::processEvents();
  EXPECT_FALSE(fault().isEmpty()) << "it stays until it is read";
  QTest::keyClicks(fields[1], "1");
  EXPECT_TRUE(fault().isEmpty()) << "something else is typed";
  type(fields[1], "-4");
  EXPECT_FALSE(fault().isEmpty());
  presenter_.undo();
  EXPECT_TRUE(fault().isEmpty()) << "something else is done";
  EXPECT_EQ(fields[0]->text(), "-10");
}

TEST_F(PlanPresenterTest, AStepThatCouldNotBeWrittenCanStillBeUndoneAndDoneAgain) {
  presenter_.addTarget(Point<Mri>(-40, 5, 60));
  presenter_.turnActive(5);
  const auto folder = model_.current().store.folder(), away = folder.parent_path() / "away";
  const auto turned_deg = presenter_.handleAngle_deg(*presenter_.active());
  std::filesystem::rename(folder, away);
  presenter_.undo();
  EXPECT_FALSE(refusal_.isEmpty());
  EXPECT_NEAR(presenter_.handleAngle_deg(*presenter_.active()), turned_deg, 1e-9);
  EXPECT_FALSE(presenter_.canRedo());
  std::filesystem::rename(away, folder);
  presenter_.undo();
  EXPECT_GT(std::abs(presenter_.handleAngle_deg(*presenter_.active()) - turned_deg), 4.0);
  std::filesystem::rename(folder, away);
  refusal_.clear();
  presenter_.redo();
  EXPECT_FALSE(refusal_.isEmpty());
  EXPECT_TRUE(presenter_.canRedo());
  std::filesystem::rename(away, folder);
  presenter_.redo();
  EXPECT_NEAR(presenter_.handleAngle_deg(*presenter_.active()), turned_deg, 1e-9);
  presenter_.undo();
  presenter_.undo();
  EXPECT_TRUE(storedNames().empty());
  EXPECT_FALSE(presenter_.canUndo());
}

TEST_F(PlanPresenterTest, UndoAndRedoKeepTheActiveTarget) {
  presenter_.addTarget(Point<Mri>(-40, 5, 60));
  const QString first = presenter_.activeName();
  presenter_.addTarget(Point<Mri>(40, 5, 60));
  const QString second = presenter_.activeName();
  presenter_.setActive(first);
  presenter_.turnActive(5);
  presenter_.undo();
  EXPECT_EQ(presenter_.activeName(), first);
  presenter_.setActive(second);
  presenter_.redo();
  EXPECT_EQ(presenter_.activeName(), second) << "it was chosen since";
  presenter_.setActive(first);
  presenter_.renameActive("M1");
  presenter_.undo();
  EXPECT_EQ(presenter_.activeName(), first);
  presenter_.redo();
  EXPECT_EQ(presenter_.activeName(), "M1");
  presenter_.removeActive();
  presenter_.undo();
  EXPECT_EQ(presenter_.activeName(), "M1");
}

TEST_F(PlanPresenterTest, APlaceOutsideTheHeadBecomesNoTargetAndIsSaidInOneLine) {
  TaskMonitor monitor;
  casefile::CaseStore::create(folder_.path() / "brain", fixtures::ballWithBrain(), {}, false);
  model_.open(loadCase(folder_.path() / "brain", monitor));
  presenter_.addTargetNear(Point<Mri>(300, 0, 0));
  EXPECT_TRUE(presenter_.plan().targets.empty());
  EXPECT_TRUE(refusal_.contains("210 mm outside the head")) << refusal_.toStdString();
  presenter_.addTarget(Point<Mri>(0, 100, 0));  // no scalp above: the coil would face away from the head
  EXPECT_TRUE(presenter_.plan().targets.empty());
  EXPECT_TRUE(refusal_.contains("10 mm outside the head")) << refusal_.toStdString();
  refusal_.clear();
  presenter_.addTargetNear(Point<Mri>(110, 0, 0));  // a little outside: the nearest cortex is used
  ASSERT_EQ(presenter_.plan().targets.size(), 1u) << refusal_.toStdString();
  EXPECT_NEAR(presenter_.plan().targets[0].cortex_point.mm.x(), 40.0, 4.0);
}

/// The presenter on a case with a brain, and a head whose landmarks are set by hand.
class PlannedHeadTest : public PlanPresenterTest {
 protected:
  PlannedHeadTest() : head_(model_) {
    TaskMonitor monitor;
    casefile::CaseStore::create(folder_.path() / "brain", fixtures::ballWithBrain(), {}, false);
    model_.open(loadCase(folder_.path() / "brain", monitor));
    QObject::connect(&head_, &HeadPresenter::refused, [this](const QString& words) { refusal_ = words; });
  }
  void setLandmarks() {
    head_.setLandmark(surface::Landmark::nasion, Point<Mri>(0, 92, 0));
    head_.setLandmark(surface::Landmark::inion, Point<Mri>(0, -92, 0));
    head_.setLandmark(surface::Landmark::tragus_left, Point<Mri>(-92, 0, 0));
    head_.setLandmark(surface::Landmark::tragus_right, Point<Mri>(92, 0, 0));
  }
  HeadPresenter head_;
};

TEST_F(PlannedHeadTest, AnEegSiteNeedsLandmarksAndIsThenATargetOfItsName) {
  presenter_.addPreset("eeg:C3", *head_.measures());
  EXPECT_TRUE(refusal_.contains("nasion is not known")) << refusal_.toStdString();
  EXPECT_TRUE(presenter_.plan().targets.empty());
  refusal_.clear();
  setLandmarks();
  EXPECT_TRUE(head_.describe().contains("nasion: by hand")) << head_.describe().toStdString();
  presenter_.addPreset("eeg:C3", *head_.measures());
  EXPECT_TRUE(refusal_.isEmpty()) << refusal_.toStdString();
  EXPECT_EQ(storedNames(), std::vector<std::string>{"eeg:C3"});
  ASSERT_TRUE(head_.site("C3"));
  EXPECT_LT((head_.site("C3")->mm - presenter_.active()->scalp_point.mm).norm(), 0.5);
}

TEST_F(PlannedHeadTest, ALandmarkFarFromTheSkinIsRefusedInOneLine) {
  head_.setLandmark(surface::Landmark::nasion, Point<Mri>(0, 0, 0));
  EXPECT_TRUE(refusal_.contains("from the skin")) << refusal_.toStdString();
}

TEST_F(PlannedHeadTest, LockGridCopyAndOrderAreStepsThatUndo) {
  presenter_.addTarget(Point<Mri>(-40, 5, 60));
  presenter_.lockActive(true);
  presenter_.turnActive(5);
  EXPECT_TRUE(refusal_.contains("locked"));
  presenter_.undo();
  presenter_.setGrid(guidance::GridSpec{3, 3, 8, guidance::GridOn::scalp});
  EXPECT_EQ(storedNames().size(), 9u) << refusal_.toStdString();
  presenter_.undo();
  EXPECT_EQ(storedNames().size(), 1u);
  presenter_.duplicateActive();
  EXPECT_EQ(storedNames().size(), 2u);
  EXPECT_TRUE(presenter_.compareWords(QString::fromStdString(storedNames()[0])).contains("0.0 mm"));
  presenter_.moveActive(-1);
  EXPECT_EQ(storedNames()[0], presenter_.activeName().toStdString());
  presenter_.setNote("  hotspot ");
  EXPECT_EQ(model_.current().store.targets().targets[0].note, "hotspot");
}

TEST_F(PlannedHeadTest, SaysHowTheCoilStandsOnTheHead) {
  presenter_.addTarget(Point<Mri>(-40, 5, 60));
  EXPECT_TRUE(presenter_.describe(*presenter_.active()).contains("rests flat on the head"))
      << presenter_.describe(*presenter_.active()).toStdString();
  auto deep = *presenter_.active();
  deep.mri_T_target = RigidTransform<Mri, frames::Target>(
      deep.mri_T_target.quaternion(),
      deep.mri_T_target.translation_mm() + 3 * deep.mri_T_target.rotation().col(2));
  deep.scalp_point = Point<Mri>(deep.mri_T_target.translation_mm());
  EXPECT_TRUE(presenter_.contactWords(deep).contains("through the skin"))
      << presenter_.contactWords(deep).toStdString();
}

}  // namespace
}  // namespace facenav::ui
