#pragma once
// A case with two made sessions of known content, for tests of Review.

#include <gtest/gtest.h>

#include "facenav/guidance/target.h"
#include "gui_fixtures.h"
#include "review/review_presenter.h"
#include "support/made_session.h"

namespace facenav::ui::review_fixtures {

namespace fs = std::filesystem;

inline guidance::Target someTarget(const casefile::PreparedCase& prepared) {
  return guidance::planTarget("M1 hand L", prepared.scalp, Point<Mri>(-28, 4, 28), 0.8, 4.0);
}

class ReviewTest : public ::testing::Test {
 protected:
  ReviewTest() {
    const auto prepared = fixtures::ballWithBrain();
    const auto store = casefile::CaseStore::create(folder_.path() / "case", prepared, {}, false);
    store.setLabel("Jane Quixley");
    guidance::TreatmentPlan plan;
    plan.targets.push_back(someTarget(prepared));
    store.setTargets(plan);
    testing::MadeSession made;
    first_ = testing::writeMadeSession(store.folder(), someTarget(prepared), made);
    made.off_mm = {1.5, 0, 0}, made.has_meps = true, made.seed = 6;
    second_ = testing::writeMadeSession(store.folder(), someTarget(prepared), made);
    TaskMonitor monitor;
    model_.open(loadCase(store.folder(), monitor));
  }
  void waitForSession(const ReviewPresenter& review) {
    ASSERT_TRUE(fixtures::waitFor([&] { return review.session() && !review.isReading(); }));
  }
  testing::TemporaryFolder folder_;
  fs::path first_, second_;
  CaseModel model_;
};

}  // namespace facenav::ui::review_fixtures
