#include "facenav/plan/case_landmarks.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/plan/plan_editor.h"
#include "support/ball_case.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using surface::Landmark;
using surface::LandmarkSource;

class CaseLandmarks : public ::testing::Test {
 protected:
  CaseLandmarks()
      : store_(casefile::CaseStore::create(folder_.path() / "case", facenav::testing::ballWithBrain(), {},
                                           false)),
        scalp_(store_.scalp()) {}
  void setAll() {
    setLandmark(store_, scalp_, Landmark::nasion, Point<Mri>(0, 92, 0), "AB");
    setLandmark(store_, scalp_, Landmark::inion, Point<Mri>(0, -92, 0), "AB");
    setLandmark(store_, scalp_, Landmark::tragus_left, Point<Mri>(-92, 0, 0), "AB");
    setLandmark(store_, scalp_, Landmark::tragus_right, Point<Mri>(92, 0, 0), "AB");
  }
  facenav::testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  surface::ScalpSurface scalp_;
};

TEST_F(CaseLandmarks, ABallShowsNoneAndTheyAreSetByHandOnItsSkin) {
  EXPECT_FALSE(landmarksOf(store_, scalp_)[Landmark::nasion]);
  setAll();
  const auto landmarks = landmarksOf(store_, scalp_);
  ASSERT_TRUE(landmarks.isComplete());
  const auto& nasion = landmarks.known(Landmark::nasion);
  EXPECT_NEAR(nasion.point.mm.norm(), 90, 0.5);
  EXPECT_EQ(nasion.source, LandmarkSource::hand);
  EXPECT_EQ(nasion.by, "AB");
  EXPECT_FALSE(nasion.utc.empty());
}

TEST_F(CaseLandmarks, APlaceFarFromTheSkinIsRefusedAndChangesNothing) {
  setAll();
  EXPECT_THROW(setLandmark(store_, scalp_, Landmark::nasion, Point<Mri>(0, 130, 0), "AB"), Error);
  EXPECT_NEAR(landmarksOf(store_, scalp_).known(Landmark::nasion).point.mm.y(), 90, 0.5);
}

TEST_F(CaseLandmarks, APresetOfTheScalpStandsOverItsSite) {
  setAll();
  const HeadMeasures measures(std::make_shared<const surface::ScalpSurface>(scalp_),
                              landmarksOf(store_, scalp_));
  PlanEditor editor(plannedCase(store_, "AB"));
  editor.begin();
  editor.addTarget(placeOf(presetNamed("eeg:C3"), nullptr, measures), "C3", {0.0, 2.0});
  const auto target = store_.targets().find("C3");
  const Eigen::Vector3d site = measures.eegSites().find("C3").point.mm;
  EXPECT_LT((target.scalp_point.mm - site).norm(), 0.5);
  EXPECT_LT(site.x(), -45) << "on the patient's left";
  EXPECT_EQ(target.changes.back().what, "planned");
  EXPECT_THROW(placeOf(presetNamed("dlpfc-fox"), nullptr, measures), Error) << "there is no atlas";
}

TEST_F(CaseLandmarks, ASiteWithoutItsLandmarksSaysWhichOneIsMissing) {
  const HeadMeasures measures(std::make_shared<const surface::ScalpSurface>(scalp_),
                              landmarksOf(store_, scalp_));
  try {
    placeOf(presetNamed("eeg:C3"), nullptr, measures);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("nasion is not known"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace facenav::steps
