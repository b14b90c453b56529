#include "facenav/plan/plan_editor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "facenav/casefile/case_store.h"
#include "facenav/guidance/handle.h"
#include "facenav/plan/coil_slice_sheet.h"
#include "support/ball_case.h"
#include "support/test_data.h"

namespace facenav::steps {
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
  const Eigen::Vector3d place = editor_.active()->cortex_point.mm, skin = editor_.active()->scalp_point.mm;
  editor_.nudge(2, 0);
  EXPECT_NEAR((editor_.active()->scalp_point.mm - skin).norm(), 2.0, 0.1) << "of the coil, on the skin";
  EXPECT_NEAR((editor_.active()->cortex_point.mm - place).norm(), 2.0 * place.norm() / 90, 0.3)
      << "the target turns about the ball's centre with its coil";
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

TEST_F(PlanEditorTest, UndoAndRedoKeepATargetThatWasChosenSince) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.addTarget(Point<Mri>(40, 5, 60));
  editor_.addTarget(Point<Mri>(0, 40, 60));
  editor_.setActive("T1");
  EXPECT_TRUE(editor_.undo());
  EXPECT_EQ(names(), (Names{"T1", "T2"}));
  EXPECT_EQ(editor_.activeName(), "T1") << "the one that was chosen, not T2";
  EXPECT_TRUE(editor_.redo());
  EXPECT_EQ(editor_.activeName(), "T1");
  editor_.setActive("T3");
  EXPECT_TRUE(editor_.undo());
  EXPECT_EQ(editor_.activeName(), "T2") << "T3 is gone";
}

TEST_F(PlanEditorTest, TwoNudgesOfOneMillimetreHardlyTurnTheHandle) {
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(-40, 5, 60), Eigen::Vector3d(-25, 45, 45),
                                       Eigen::Vector3d(50, -20, 45), Eigen::Vector3d(5, 0, 70)})
    for (const double x : {1.0, -1.0})
      for (const double y : {0.0, 1.0}) {
        editor_.addTarget(Point<Mri>(place));
        const double before_deg = handle_deg();
        const Eigen::Matrix3d before = editor_.active()->mri_T_target.rotation();
        for (int i = 0; i < 2; ++i) editor_.nudge(x, y);
        EXPECT_NEAR(handle_deg(), before_deg, 3.5) << place.transpose();  // a ball of facets
        const Eigen::Matrix3d after = editor_.active()->mri_T_target.rotation();
        const Eigen::Vector3d carried =
            Eigen::Quaterniond::FromTwoVectors(before.col(2), after.col(2)) * before.col(1);
        EXPECT_NEAR(std::acos(std::min(1.0, carried.dot(after.col(1)))) * 180 / M_PI, 0.0, 0.1)
            << "its direction is carried along the scalp";
      }
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

TEST_F(PlanEditorTest, EveryChangeHasTimeAndAuthorAndAHeldKeyIsOne) {
  PlanEditor editor({[this]() -> const guidance::TreatmentPlan& { return plan_; }, [this] { return head_; },
                     [this](const guidance::TreatmentPlan& next) { plan_ = next; },
                     [](int n) { return "T" + std::to_string(n); }, [] { return "AB"; }});
  editor.begin();
  editor.addTarget(Point<Mri>(-40, 5, 60));
  for (int i = 0; i < 5; ++i) editor.nudge(1, 0);
  editor.turn(0.1);
  const auto& changes = editor.active()->changes;
  ASSERT_EQ(changes.size(), 3u);
  EXPECT_EQ(changes[0].what, "planned");
  EXPECT_EQ(changes[1].what, "moved");
  EXPECT_EQ(changes[2].what, "turned");
  for (const auto& change : changes) {
    EXPECT_EQ(change.by, "AB");
    EXPECT_EQ(change.utc.size(), 24u) << change.utc;
  }
}

TEST_F(PlanEditorTest, ALockedTargetCanBeNeitherChangedNorRemoved) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.setLocked(true);
  const auto before = editor_.active()->mri_T_target;
  const auto isRefused = [&](const auto& edit) {
    try {
      edit();
    } catch (const PlanRefused& refused) {
      return refused.refusal() == PlanRefusal::locked;
    }
    return false;
  };
  EXPECT_TRUE(isRefused([&] { editor_.turn(0.1); }));
  EXPECT_TRUE(isRefused([&] { editor_.nudge(1, 0); }));
  EXPECT_TRUE(isRefused([&] { editor_.rename("M1"); }));
  EXPECT_TRUE(isRefused([&] { editor_.remove(); }));
  EXPECT_TRUE(isRefused([&] { editor_.setNote("x"); }));
  EXPECT_TRUE(isRefused([&] { editor_.addTarget(PresetPlace{Point<Mri>(-40, 5, 60), {}, ""}, "T1"); }));
  EXPECT_EQ(editor_.active()->mri_T_target.translation_mm(), before.translation_mm());
  editor_.setLocked(false);
  editor_.turn(0.1);
}

TEST_F(PlanEditorTest, ACopyHasAFreeNameAndIsNotLocked) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.setLocked(true);
  editor_.duplicate();
  editor_.duplicate();
  EXPECT_EQ(names(), (Names{"T1", "T1 copy", "T1 copy copy"}));
  EXPECT_FALSE(editor_.active()->is_locked);
}

TEST_F(PlanEditorTest, AMirroredTargetHasTheSameHandleAndGapOnTheOtherSide) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.replace(guidance::withHairGap(*editor_.active(), 3.0));
  editor_.mirror([](const Point<Mri>& p) { return Point<Mri>(-p.mm.x(), p.mm.y(), p.mm.z()); });
  EXPECT_EQ(editor_.activeName(), "T1 mirrored");
  EXPECT_GT(editor_.active()->scalp_point.mm.x(), 20);
  EXPECT_NEAR(handle_deg(), 45.0, 1e-6);
  EXPECT_NEAR(guidance::hairGap_mm(*editor_.active()), 3.0, 1e-9);
}

TEST_F(PlanEditorTest, AGridFollowsItsSeedAndKeepsWhatAHandEdited) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.setGrid(guidance::GridSpec{3, 3, 8, guidance::GridOn::scalp});
  ASSERT_EQ(plan_.targets.size(), 9u);  // the seed is the centre
  editor_.setActive("T1 r1 c1");
  editor_.nudge(2, 0);
  const auto edited = find(plan_, "T1 r1 c1")->cortex_point.mm;
  const auto follower = find(plan_, "T1 r3 c3")->cortex_point.mm;
  editor_.setActive("T1");
  editor_.nudge(0, 4);
  EXPECT_EQ(plan_.targets.size(), 9u);
  EXPECT_EQ(find(plan_, "T1 r1 c1")->cortex_point.mm, edited);
  EXPECT_GT((find(plan_, "T1 r3 c3")->cortex_point.mm - follower).norm(), 1.0);
  EXPECT_TRUE(editor_.undo()) << "the seed and its grid move back in one step";
  EXPECT_EQ(find(plan_, "T1 r3 c3")->cortex_point.mm, follower);
  editor_.setGrid(std::nullopt);
  EXPECT_EQ(names(), (Names{"T1", "T1 r1 c1"}));
}

TEST_F(PlanEditorTest, TargetsAreMovedInTheList) {
  editor_.addTarget(Point<Mri>(-40, 5, 60));
  editor_.addTarget(Point<Mri>(40, 5, 60));
  editor_.move(-1);
  EXPECT_EQ(names(), (Names{"T2", "T1"}));
  editor_.move(-1);  // it is the first
  EXPECT_EQ(names(), (Names{"T2", "T1"}));
}

TEST_F(PlanEditorTest, AClickOnTheScalpPutsTheCoilThere) {
  const Eigen::Vector3d place = 90 * Eigen::Vector3d(-0.5, 0.3, 0.8).normalized();
  editor_.addTargetAtScalp(Point<Mri>(place));
  EXPECT_LT((editor_.active()->scalp_point.mm - place).norm(), 0.5);
  const Eigen::Vector3d aim = (editor_.active()->mri_T_target.inverse() * editor_.active()->cortex_point).mm;
  EXPECT_LT(aim.head<2>().norm(), 1e-6) << "the cortex point lies on the axis";
}

TEST(Presets, EachOfTheLeftHasOneOfTheRight) {
  for (const auto& preset : presets()) {
    if (!preset.mni) continue;
    const auto isMirrored = [&](const Preset& other) {
      return other.mni &&
             other.mni->mm == Eigen::Vector3d(-preset.mni->mm.x(), preset.mni->mm.y(), preset.mni->mm.z());
    };
    EXPECT_TRUE(std::any_of(presets().begin(), presets().end(), isMirrored)) << preset.name;
  }
  EXPECT_EQ(presetNamed("dlpfc-fox-right").mni->mm, Eigen::Vector3d(38, 44, 26));
  EXPECT_EQ(presetNamed("dlpfc-fox-right").words, "right prefrontal cortex (DLPFC), MNI 38 44 26");
  EXPECT_EQ(presetNamed("dlpfc-group-right").mni->mm, Eigen::Vector3d(42, 44, 30));
  EXPECT_FALSE(presetNamed("beam-f4").mni);
}

TEST(Presets, AreFoundByNameAndListedWhenThereIsNone) {
  EXPECT_EQ(presetNamed("M1-Hand-Left").mni->mm, Eigen::Vector3d(-37, -21, 58));
  EXPECT_EQ(presetNamed("m1-hand-right").mni->mm, Eigen::Vector3d(37, -21, 58));
  EXPECT_EQ(presetNamed("dlpfc-fox").mni->mm, Eigen::Vector3d(-38, 44, 26));
  EXPECT_EQ(presetNamed("dlpfc-group").mni->mm, Eigen::Vector3d(-42, 44, 30));
  EXPECT_EQ(presetNamed("eeg:t3").name, "eeg:T7");
  EXPECT_FALSE(presetNamed("beam-f3").mni);
  try {
    presetNamed("f3");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("beam-f3"), std::string::npos);
  }
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

TEST(AlignedBound, OfTheRingIsNeverBelowTheBoundThatTheAlignmentStored) {
  const testing::TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", testing::ballCase(), {}, false);
  guidance::Target target;
  target.name = "M1";
  target.cortex_point = Point<Mri>(0, 0, 60);
  EXPECT_FALSE(alignedBound95_mm(store, target)) << "not aligned";
  casefile::StoredAlignment alignment;
  alignment.predicted_tre_p95_mm = {{"M1", 6.0}, {"other", 4.0}};
  alignment.uncertainty.emplace();
  alignment.uncertainty->covariance.diagonal().tail<3>().setConstant(0.01);  // 0.1 mm an axis
  casefile::writeAlignment(alignment, store.folder() / "alignment.json");
  EXPECT_DOUBLE_EQ(alignedBound95_mm(store, target).value(), 6.0) << "a camera that may have turned";
  target.name = "planned later";
  EXPECT_DOUBLE_EQ(alignedBound95_mm(store, target).value(), 6.0);
  alignment.uncertainty->covariance.diagonal().tail<3>().setConstant(100.0);
  casefile::writeAlignment(alignment, store.folder() / "alignment.json");
  EXPECT_GT(alignedBound95_mm(store, target).value(), 15.0);
}

}  // namespace
}  // namespace facenav::steps
