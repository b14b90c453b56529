#include "facenav/health/pair_diagnosis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <tuple>

#include "facenav/cameras/rig_file.h"
#include "facenav/geometry/rotation.h"
#include "facenav/health/pair_matches.h"
#include "support/stereo_rigs.h"
#include "support/test_data.h"

namespace facenav::health {

using namespace cameras;
namespace {

using ::testing::HasSubstr;

using Matches = std::vector<Correspondence>;

StereoRig turnedRig(const StereoRig& rig, const Eigen::Vector3d& turn_deg, const Eigen::Vector3d& shift_mm) {
  StereoRig other = rig;
  Eigen::Isometry3d pose = rig.right_T_left.isometry();
  pose.prerotate(expRotation(turn_deg * M_PI / 180));
  pose.pretranslate(shift_mm);
  other.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(pose);
  return other;
}

/// Matches of 120 points of a face and 60 of the shoulders, 0.2 px of noise, every twelfth match wrong.
/// `step`: motion of the face until the right camera exposes; the shoulders move by a third of it, and a
/// grimace by `grimace_mm`.
Matches seen(const StereoRig& rig, const Eigen::Isometry3d& step = Eigen::Isometry3d::Identity(),
             double grimace_mm = 0, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 0.2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Eigen::Vector3d middle =
      0.5 * rig.right_T_left.inverse().translation_mm() + Eigen::Vector3d(0, 0, 600);
  Matches matches;
  for (int i = 0; i < 180; ++i) {
    const bool is_face = i < 120;
    const Eigen::Vector3d at(70 * uniform(random),
                             is_face ? 80 * uniform(random) : 120 + 20 * uniform(random),
                             40 * uniform(random));
    Eigen::Vector3d later =
        is_face ? Eigen::Vector3d(step * at) : Eigen::Vector3d(at + step.translation() / 3);
    if (is_face && at.y() > 20) later.y() += grimace_mm * (at.y() - 20) / 60;
    Eigen::Vector2d left = project(rig.left, middle + at);
    Eigen::Vector2d right = project(rig.right, rig.right_T_left.isometry() * Eigen::Vector3d(middle + later));
    for (Eigen::Vector2d* px : {&left, &right}) *px += Eigen::Vector2d(normal(random), normal(random));
    if (i % 12 == 5) right.y() += 6 * uniform(random);
    matches.push_back({left, right, 0.2});
  }
  return matches;
}

RigState faultOf(const StereoRig& calibrated, const Matches& matches) {
  return diagnoseMatches(calibrated, matches).state;
}

TEST(PairDiagnosis, FindsNothingWrongWithARightRig) {
  for (const auto& rig : {testing::convergingRig(), testing::verticalRig(), testing::rolledRig()})
    EXPECT_EQ(faultOf(rig, seen(rig)), RigState::holds);
}

TEST(PairDiagnosis, KnowsNothingFromAFewMatches) {
  const auto rig = testing::convergingRig();
  Matches few = seen(rig);
  few.resize(12);
  EXPECT_EQ(faultOf(rig, few), RigState::unclear);
  EXPECT_EQ(diagnoseMatches(rig, {}).verdict().words(), "");
}

TEST(PairDiagnosis, NamesExchangedSides) {
  for (const auto& rig : {testing::convergingRig(), testing::verticalRig()}) {
    Matches matches = seen(rig);
    for (auto& match : matches) std::swap(match.left_px, match.right_px);
    EXPECT_EQ(faultOf(rig, matches), RigState::swapped);
  }
}

TEST(PairDiagnosis, NamesACameraThatWasKnocked) {
  const auto rig = testing::convergingRig();
  for (const Eigen::Vector3d& turn_deg : {Eigen::Vector3d(0.3, 0, 0), Eigen::Vector3d(-0.2, 0.2, 0.8)})
    EXPECT_EQ(faultOf(turnedRig(rig, turn_deg, {0, 0, 0}), seen(rig)), RigState::moved) << turn_deg;
  EXPECT_EQ(faultOf(turnedRig(rig, {0, 0, 0}, {0, 3, 0}), seen(rig)), RigState::moved);
}

TEST(PairDiagnosis, NamesTheCalibrationOfAnotherRig) {
  const auto rig = testing::convergingRig();
  const auto other = turnedRig(rig, {3, 6, -4}, {5, 3, 45});
  const auto said = diagnoseMatches(other, seen(rig));
  EXPECT_EQ(said.state, RigState::other_cameras);
  EXPECT_EQ(said.verdict().finding, "the calibration does not belong to these cameras");
  EXPECT_EQ(said.verdict().advice, "give the right stereo.yml, or calibrate");
}

// Another rig that converges less sees this face behind its cameras.
TEST(PairDiagnosis, NamesAnotherRigThatSeesTheFaceBehindItself) {
  const auto rig = testing::convergingRig();
  const auto matches = seen(rig);
  for (const double turn_deg : {-25.0, -30.0}) {
    const auto other = turnedRig(rig, {1, turn_deg, 0}, {0, 0, 0});
    const auto& some = matches.front();
    const double depth_mm = triangulate(other, some.left_px, some.right_px).mm.z();
    ASSERT_FALSE(depth_mm > 0 && depth_mm < 1e6) << depth_mm;
    EXPECT_EQ(faultOf(other, matches), RigState::other_cameras) << turn_deg;
  }
}

TEST(PairDiagnosis, NamesPicturesOfDifferentMoments) {
  const auto rig = testing::convergingRig();
  for (const Vector6d& step : {(Vector6d() << 0.02, 0.03, 0, 4, 5, -3).finished(),
                               (Vector6d() << -0.05, 0.02, 0.04, -8, -6, 5).finished()}) {
    const auto said = diagnoseMatches(rig, seen(rig, expRigid(step), 6));
    EXPECT_EQ(said.state, RigState::out_of_step) << said.agreement;
    EXPECT_EQ(said.verdict().finding, "the two cameras' pictures are of different moments");
  }
}

/// Matches of 600 points of a face, made as by `seen`.
Matches seenSkin(const StereoRig& rig, const Eigen::Isometry3d& step = Eigen::Isometry3d::Identity(),
                 double grimace_mm = 0) {
  Matches skin;
  for (int i = 0; i < 5; ++i) {
    const Matches more = seen(rig, step, grimace_mm, 3 + i);
    skin.insert(skin.end(), more.begin(), more.begin() + 120);
  }
  return skin;
}

TEST(PairDiagnosis, AsksTheSkinBeforeItNamesAMovedCamera) {
  const auto rig = testing::convergingRig();
  const Eigen::Isometry3d step = expRigid((Vector6d() << 0.002, 0.001, 0, 1, 3, -1).finished());
  Matches corners = seen(rig, step);  // of brows and eyes, which move with the skull
  corners.resize(120);
  const auto of_corners = diagnoseMatches(rig, corners);
  ASSERT_EQ(of_corners.state, RigState::moved);
  EXPECT_EQ(withSkin(rig, of_corners, seenSkin(rig, step)).state, RigState::moved);
  const auto said = withSkin(rig, of_corners, seenSkin(rig, step, 6));
  EXPECT_EQ(said.state, RigState::out_of_step) << said.skin_px;
}

TEST(PairDiagnosis, LeavesACameraMovedWhereTheSkinAgrees) {
  const auto rig = testing::convergingRig();
  for (const auto& calibrated :
       {turnedRig(rig, {0.3, 0, 0}, {0, 0, 0}), turnedRig(rig, {0, 0, 0}, {0, 3, 0})}) {
    const auto of_corners = diagnoseMatches(calibrated, seen(rig));
    ASSERT_EQ(of_corners.state, RigState::moved);
    const auto said = withSkin(calibrated, of_corners, seenSkin(rig));
    EXPECT_EQ(said.state, RigState::moved) << said.skin_px;
    EXPECT_GT(said.skin_px, 0.0);
  }
}

TEST(PairDiagnosis, AsksNoSkinWhereTheRigHolds) {
  const auto rig = testing::convergingRig();
  const auto said =
      withSkin(rig, diagnoseMatches(rig, seen(rig)), seenSkin(rig, Eigen::Isometry3d::Identity(), 6));
  EXPECT_EQ(said.state, RigState::holds);
}

/// Matches of a room that stands still, 400 to 900 mm behind the face of `seen`.
Matches seenRoom(const StereoRig& rig) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal(0, 0.2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Matches room;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d at(300 * uniform(random), 200 * uniform(random), 1250 + 250 * uniform(random));
    Eigen::Vector2d left = project(rig.left, at),
                    right = project(rig.right, rig.right_T_left.isometry() * at);
    for (Eigen::Vector2d* px : {&left, &right}) *px += Eigen::Vector2d(normal(random), normal(random));
    room.push_back({left, right, 0.2});
  }
  return room;
}

Matches faceOf(Matches matches) {
  matches.resize(120);
  return matches;
}

TEST(OffsetCause, IsTheHeadWhereTheRoomFits) {
  const auto rig = testing::convergingRig();
  const Eigen::Isometry3d step = expRigid((Vector6d() << 0.002, 0.001, 0, 1, 3, -1).finished());
  EXPECT_EQ(likelierCause(rig, faceOf(seen(rig, step)), seenRoom(rig)), OffsetCause::two_exposures);
}

TEST(OffsetCause, IsACameraWhereFaceAndRoomMovedAlike) {
  const auto rig = testing::convergingRig(), calibrated = turnedRig(rig, {0.3, 0, 0}, {0, 0, 0});
  EXPECT_EQ(likelierCause(calibrated, faceOf(seen(rig)), seenRoom(rig)), OffsetCause::camera_moved);
}

TEST(OffsetCause, IsNoCameraWhereTheCalibrationItselfIsThatInexact) {
  const auto rig = testing::convergingRig();
  auto calibrated = turnedRig(rig, {0.05, 0, 0}, {0, 0, 0});
  calibrated.rms_px = 0.1;
  ASSERT_EQ(likelierCause(calibrated, faceOf(seen(rig)), seenRoom(rig)), OffsetCause::camera_moved);
  calibrated.rms_px = 2.0;
  EXPECT_EQ(likelierCause(calibrated, faceOf(seen(rig)), seenRoom(rig)), OffsetCause::unknown);
}

TEST(OffsetCause, IsUnknownWithoutARoomAndWithWallpaperThatMatchesAnywhere) {
  const auto rig = testing::convergingRig(), calibrated = turnedRig(rig, {0.3, 0, 0}, {0, 0, 0});
  EXPECT_EQ(likelierCause(calibrated, faceOf(seen(rig)), {}), OffsetCause::unknown);
  Matches wallpaper = seenRoom(rig);
  for (std::size_t i = 0; i < wallpaper.size(); ++i)
    wallpaper[i].right_px.y() += 12.0 * double(int(i % 5) - 2);
  EXPECT_NE(likelierCause(calibrated, faceOf(seen(rig)), wallpaper), OffsetCause::two_exposures);
}

TEST(PairDiagnosis, NamesAMovedCameraOnlyWhereTheRoomSaysSo) {
  const auto rig = testing::convergingRig(), turned = turnedRig(rig, {0.3, 0, 0}, {0, 0, 0});
  const auto face = faceOf(seen(rig));
  const auto of_face = diagnoseMatches(turned, face);
  ASSERT_EQ(of_face.state, RigState::moved);
  EXPECT_EQ(withRoom(turned, of_face, face, seenRoom(rig)).state, RigState::moved);
  EXPECT_EQ(withRoom(turned, of_face, face, seenRoom(turned)).state, RigState::out_of_step);
  const auto alone = withRoom(turned, of_face, face, {});
  EXPECT_EQ(alone.state, RigState::disagree);
  EXPECT_TRUE(alone.isFault());
  EXPECT_THAT(alone.verdict().words(),
              HasSubstr("a camera has moved since, or they were taken at two moments"));
}

/// A real person before real cameras, with exact rigs.
class RealPair : public ::testing::Test {
 protected:
  void SetUp() override { FACENAV_NEEDS(folder()); }
  static std::filesystem::path folder() { return testing::sharedData() / "real_faces"; }
  static StereoRig rig(const std::string& cameras) { return readRig(folder() / (cameras + "_stereo.yml")); }
  static const Matches& matches(const std::string& left, const std::string& right) {
    static std::map<std::string, Matches> kept;
    auto [found, is_new] = kept.try_emplace(left + right);
    if (is_new) found->second = matchPictures(picture(left), picture(right));
    return found->second;
  }
  static cv::Mat picture(const std::string& name) {
    return cv::imread((folder() / "person" / (name + ".jpg")).string(), cv::IMREAD_GRAYSCALE);
  }
  static PairDiagnosis whole(const StereoRig& calibrated, const std::string& left, const std::string& right) {
    const auto said = diagnoseMatches(calibrated, matches(left, right));
    return withSkin(calibrated, said, growMatches(picture(left), picture(right), matches(left, right)));
  }
};

TEST_F(RealPair, OfOneMomentFitsItsRigAndNoOther) {
  for (const auto& [cameras, other] : {std::pair("lm", "mr"), std::pair("mr", "lr")})
    for (const std::string moment : {"_1", "_1669"}) {
      const auto& pair = matches(cameras[0] + moment, cameras[1] + moment);
      EXPECT_EQ(faultOf(rig(cameras), pair), RigState::holds) << cameras << moment;
      EXPECT_EQ(faultOf(rig(other), pair), RigState::other_cameras) << cameras << moment;
    }
}

TEST_F(RealPair, OfDifferentMomentsIsNamed) {
  EXPECT_EQ(faultOf(rig("lm"), matches("l_1", "m_418")), RigState::out_of_step);
  EXPECT_EQ(faultOf(rig("mr"), matches("m_1252", "r_1669")), RigState::out_of_step);
}

// The corners of eyes and brows alone would fit a moved camera here.
TEST_F(RealPair, OfDifferentMomentsIsNamedByTheSkin) {
  for (const auto& [cameras, left, right] :
       {std::tuple("lm", "l_418", "m_835"), std::tuple("lm", "l_835", "m_418"),
        std::tuple("mr", "m_418", "r_1252"), std::tuple("mr", "m_835", "r_1252")}) {
    ASSERT_EQ(faultOf(rig(cameras), matches(left, right)), RigState::moved) << left;
    const auto said = whole(rig(cameras), left, right);
    EXPECT_EQ(said.state, RigState::out_of_step) << left << " " << right << " " << said.skin_px;
  }
}

TEST_F(RealPair, BeforeAMovedCameraIsNamedSo) {
  for (const auto& [cameras, left, right] :
       {std::tuple("lm", "l_1", "m_1"), std::tuple("mr", "m_1669", "r_1669")})
    for (const Eigen::Vector3d& turn_deg : {Eigen::Vector3d(0.25, 0, 0), Eigen::Vector3d(0, 0, 0.5)}) {
      const auto said = whole(turnedRig(rig(cameras), turn_deg, {0, 0, 0}), left, right);
      EXPECT_EQ(said.state, RigState::moved) << left << " " << said.skin_px;
    }
}

TEST_F(RealPair, WithSidesExchangedIsNamed) {
  EXPECT_EQ(faultOf(rig("lm"), matches("m_835", "l_835")), RigState::swapped);
}

}  // namespace
}  // namespace facenav::health
