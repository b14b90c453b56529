#include "plan/place_presenter.h"

#include <gtest/gtest.h>

#include "gui_fixtures.h"
#include "plan/typed_coordinates.h"

namespace facenav::ui {
namespace {

/// Case in which MNI = RAS shifted by (2, 0, 0), with one label over x < 0.
class PlacePresenterTest : public ::testing::Test {
 protected:
  PlacePresenterTest() : place_(services_, model_) {
    services_.readTemplate = [] {
      atlas::BrainTemplate made;
      auto& labels = made.aal.labels;
      labels.grid.size = {40, 40, 40};
      labels.grid.mri_from_voxel.linear() *= 5.0;
      labels.grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-97.5);
      for (int n = 0; n < 40 * 40 * 40; ++n) labels.voxels.push_back(n % 40 < 20 ? 7.f : 0.f);
      made.aal.names[7] = "Precentral_L";
      made.brodmann = made.aal;
      made.brodmann.names[7] = "BA 4";
      return made;
    };
  }
  void open(bool has_atlas) {
    auto loaded = fixtures::loadBallCase(folder_.path());
    Eigen::Affine3d shift = Eigen::Affine3d::Identity();
    shift.translation().x() = -2.0;  // Mri from MNI
    volume::VoxelGrid grid;
    grid.size = {2, 2, 2};
    grid.mri_from_voxel.linear() *= 200.0;
    if (has_atlas)
      loaded->atlas.emplace(shift, grid, std::vector<Eigen::Vector3f>(8, Eigen::Vector3f::Zero()));
    model_.open(loaded);
  }
  testing::TemporaryFolder folder_;
  Services services_;
  CaseModel model_;
  PlacePresenter place_;
};

TEST_F(PlacePresenterTest, GivesBothCoordinatesAndBothLabels) {
  open(true);
  const Place place = place_.at(Point<Mri>(-40, 5, 60));
  ASSERT_TRUE(place.mni);
  EXPECT_NEAR(place.mni->mm.x(), -38.0, 0.02);
  EXPECT_EQ(place.aal, "Precentral_L");
  EXPECT_EQ(place.brodmann, "BA 4");
  const QString words = place_.describe(Point<Mri>(-40, 5, 60));
  for (const char* part : {"RAS", "-40.0", "MNI", "-38.0", "Precentral_L", "BA 4"})
    EXPECT_TRUE(words.contains(part)) << part;
  EXPECT_TRUE(place_.describe(Point<Mri>(60, 5, 60)).contains("no label"));
}

TEST_F(PlacePresenterTest, ReadsTypedCoordinatesInEitherFrame) {
  open(true);
  QString why;
  EXPECT_NEAR(place_.read("-38 5 60", true, why)->mm.x(), -40.0, 1e-6);
  EXPECT_NEAR(place_.read("-38, 5; 60", false, why)->mm.x(), -38.0, 1e-6);
  EXPECT_NEAR(place_.read("ras -38 5 60", true, why)->mm.x(), -38.0, 1e-6);
  EXPECT_NEAR(place_.read("MNI -38 5 60", false, why)->mm.x(), -40.0, 1e-6);
  EXPECT_TRUE(why.isEmpty());
  for (const char* bad : {"", "1 2", "1 2 3 4", "a b c", "nan 0 0", "9999 0 0"}) {
    why.clear();
    EXPECT_FALSE(place_.read(bad, false, why)) << bad;
    EXPECT_FALSE(why.isEmpty()) << bad;
  }
}

TEST_F(PlacePresenterTest, WithoutAnAtlasItSaysSoAndTakesRasOnly) {
  open(false);
  EXPECT_FALSE(place_.at(Point<Mri>(0, 0, 0)).mni);
  EXPECT_TRUE(place_.describe(Point<Mri>(0, 0, 0)).contains("no atlas"));
  QString why;
  EXPECT_FALSE(place_.read("1 2 3", true, why));
  EXPECT_TRUE(why.contains("RAS"));
  EXPECT_TRUE(place_.read("1 2 3", false, why));
}

TEST_F(PlacePresenterTest, RefusesAPlaceFarOutsideTheHeadInOneLineThatSaysHowFar) {
  open(true);
  QString why;
  EXPECT_FALSE(place_.read("MNI 300 0 0", false, why));  // the ball's skin is at 90 mm, MNI is shifted by 2
  EXPECT_TRUE(why.contains("208 mm outside the head")) << why.toStdString();
  EXPECT_FALSE(why.contains('\n'));
  why.clear();
  EXPECT_FALSE(place_.read("RAS 0 -125 0", false, why));
  EXPECT_TRUE(why.contains("35 mm outside")) << why.toStdString();
  why.clear();
  EXPECT_TRUE(place_.read("RAS 0 -115 0", false, why));
  EXPECT_TRUE(why.isEmpty());
}

TEST(TypedCoordinates, AreReadWithADecimalPointOrComma) {
  const Eigen::Vector3d wanted(12.5, -3.0, 40.0);
  for (const char* typed : {"12,5; -3,0; 40", "12.5, -3.0, 40", "12.5 -3 40", "12,5 -3,0 40", "12,5;-3;40",
                            "12,5, -3,0, 40", "12.5,-3.0,40", " +12.5 ,-3 , 40.0 ", "12,5\t-3\t40"}) {
    const auto read = readCoordinates(typed);
    ASSERT_TRUE(read.mm) << typed << ": " << read.fault.toStdString();
    EXPECT_LT((*read.mm - wanted).norm(), 1e-9) << typed;
    EXPECT_TRUE(read.fault.isEmpty()) << typed;
  }
  EXPECT_EQ(readCoordinates("-38,5,60").mm->x(), -38.0);
  EXPECT_EQ(readCoordinates(QString(QChar(0x2212)) + "38, 5, 60").mm->x(), -38.0);
}

TEST(TypedCoordinates, ThatCanBeReadInTwoWaysAreRefusedInOneLine) {
  for (const char* typed :
       {"12,5,-3,0,40", "12,5 40", "12,5,3,40", "1.234,5; 0; 0", "12,5; 3.2; 40", "1,2,3 4 5", "12,5; 40"}) {
    const auto read = readCoordinates(typed);
    EXPECT_FALSE(read.mm) << typed;
    EXPECT_TRUE(read.fault.contains("comma")) << typed;
    EXPECT_FALSE(read.fault.contains('\n'));
  }
  for (const char* typed : {"", "1 2", "1 2 3 4", "a,b,c", "nan 0 0", "inf 0 0", "1e30 0 0"}) {
    EXPECT_FALSE(readCoordinates(typed).mm) << typed;
    EXPECT_TRUE(readCoordinates(typed).fault.contains("three numbers")) << typed;
  }
}

}  // namespace
}  // namespace facenav::ui
