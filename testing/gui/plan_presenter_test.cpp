#include "presenters/plan_presenter.h"

#include <gtest/gtest.h>

#include "gui_fixtures.h"

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
  EXPECT_NEAR(PlanPresenter::handleAngle_deg(*presenter_.active()), 45.0, 1.0);
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

}  // namespace
}  // namespace facenav::ui
