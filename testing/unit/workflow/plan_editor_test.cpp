#include "facenav/workflow/plan_editor.h"

#include <gtest/gtest.h>

#include "facenav/guidance/handle.h"
#include "support/ball_case.h"
#include "support/test_data.h"

namespace facenav::workflow {
namespace {

/// A ball of 90 mm with a brain of 40 mm, and a plan in memory whose writing can fail on request.
class PlanEditorTest : public ::testing::Test {
 protected:
  PlanEditorTest()
      : editor_({[this]() -> const guidance::TreatmentPlan& { return plan_; }, [this] { return head_; },
                 [this](const guidance::TreatmentPlan& next) {
                   if (is_full_) throw Error("the disk is full");
                   plan_ = next;
                 },
                 [](int n) { return "T" + std::to_string(n); }}) {
    const auto prepared = facenav::testing::ballWithBrain();
    head_ = {std::make_shared<const surface::ScalpSurface>(prepared.scalp),
             std::make_shared<const volume::Mask>(prepared.head_mask),
             std::make_shared<const surface::BrainModel>(*prepared.brain)};
    editor_.begin();
  }
  double handle_deg() const {
    return guidance::handleAngle(*editor_.active(), *head_.scalp).angle_rad * 180 / M_PI;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& target : plan_.targets) all.push_back(target.name);
    return all;
  }
  PlannedHead head_;
  guidance::TreatmentPlan plan_;
  bool is_full_ = false;
  PlanEditor editor_;
};

using Names = std::vector<std::string>;

TEST_F(PlanEditorTest, PlacesATargetUnderTheScalpAndTurnsIt) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  ASSERT_NE(editor_.active(), nullptr);
  EXPECT_EQ(editor_.activeName(), "T1");
  EXPECT_NEAR(editor_.active()->scalp_point.mm.norm(), 90.0, 1.0);
  EXPECT_NEAR(handle_deg(), 45.0, 1.0);
  const double before_deg = handle_deg();
  editor_.turn(10 * M_PI / 180);
  EXPECT_NEAR(std::abs(handle_deg() - before_deg), 10.0, 1e-6);
}

TEST_F(PlanEditorTest, ANudgeKeepsHandleAndGap) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.replace(guidance::planTarget("T1", *head_.scalp, Point<Mri>(-40, 5, 60), -45 * M_PI / 180, 4.0));
  const Eigen::Vector3d place = editor_.active()->cortex_point.mm;
  editor_.nudge(2, 0);
  EXPECT_NEAR((editor_.active()->cortex_point.mm - place).norm(), 2.0, 0.2);
  EXPECT_NEAR(handle_deg(), -45.0, 5.0);  // the ball's facets are 6 degrees wide
  EXPECT_NEAR(guidance::hairGap_mm(*editor_.active()), 4.0, 1e-9);
}

TEST_F(PlanEditorTest, EveryStepIsUndoneAndDoneAgainWithItsTargetActive) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.addTarget(Point<Mri>(40, 5, 60));
  editor_.setActive("T1");
  editor_.rename("M1");
  editor_.remove();
  EXPECT_EQ(names(), Names{"T2"});
  EXPECT_EQ(editor_.activeName(), "T2");
  EXPECT_TRUE(editor_.undo());
  EXPECT_EQ(names(), (Names{"M1", "T2"}));
  EXPECT_EQ(editor_.activeName(), "M1");
  EXPECT_TRUE(editor_.undo());
  EXPECT_EQ(editor_.activeName(), "T1");
  EXPECT_TRUE(editor_.redo());
  EXPECT_TRUE(editor_.redo());
  EXPECT_FALSE(editor_.redo());
  EXPECT_EQ(names(), Names{"T2"});
  while (editor_.undo()) continue;
  EXPECT_TRUE(plan_.targets.empty());
}

TEST_F(PlanEditorTest, AStepThatCannotBeWrittenChangesNothing) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  is_full_ = true;
  EXPECT_THROW(editor_.rename("M1"), Error);
  EXPECT_EQ(editor_.activeName(), "T1");
  EXPECT_THROW(editor_.undo(), Error);
  EXPECT_TRUE(editor_.canUndo());
  EXPECT_FALSE(editor_.canRedo());
  is_full_ = false;
  EXPECT_TRUE(editor_.undo());
  is_full_ = true;
  EXPECT_THROW(editor_.redo(), Error);
  is_full_ = false;
  EXPECT_TRUE(editor_.redo());
  EXPECT_EQ(names(), Names{"T1"});
}

TEST_F(PlanEditorTest, RefusesANameThatIsTakenAndAPlaceOutsideTheHead) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.addTarget(Point<Mri>(40, 5, 60));
  const auto refusalOf = [](const auto& edit) -> std::optional<PlanRefusal> {
    try {
      edit();
    } catch (const PlanRefused& refused) {
      return refused.refusal();
    }
    return std::nullopt;
  };
  EXPECT_EQ(refusalOf([&] { editor_.rename("T1"); }), PlanRefusal::name_taken);
  EXPECT_EQ(refusalOf([&] { editor_.addTarget(Point<Mri>(0, 100, 0)); }), PlanRefusal::outside_head);
  EXPECT_EQ(refusalOf([&] { editor_.addTargetNear(Point<Mri>(300, 0, 0)); }), PlanRefusal::outside_head);
  head_.brain = nullptr;
  EXPECT_EQ(refusalOf([&] { editor_.addTargetAtScalp(Point<Mri>(0, 0, 90)); }), PlanRefusal::no_brain);
  EXPECT_EQ(names(), (Names{"T1", "T2"}));
}

TEST_F(PlanEditorTest, APlaceOutsideTheBrainIsTakenToTheNearestCortex) {
  editor_.addTargetNear(Point<Mri>(110, 0, 0));
  EXPECT_NEAR(editor_.active()->cortex_point.mm.x(), 40.0, 4.0);
  editor_.addTargetNear(Point<Mri>(10, 20, 20));  // inside: the point itself
  EXPECT_LT((editor_.active()->cortex_point.mm - Eigen::Vector3d(10, 20, 20)).norm(), 1e-9);
}

TEST(PlanEdits, ATargetReplacesTheOneOfItsName) {
  guidance::TreatmentPlan plan;
  guidance::Target target;
  target.name = "M1";
  plan = with(plan, "M1", target);
  target.note = "anew";
  plan = with(plan, "M1", target);
  ASSERT_EQ(plan.targets.size(), 1u);
  EXPECT_EQ(find(plan, "M1")->note, "anew");
  EXPECT_TRUE(without(plan, "M1").targets.empty());
}

}  // namespace
}  // namespace facenav::workflow
