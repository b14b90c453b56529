#include "facenav/casefile/landmarks_file.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

using surface::Landmark;
using surface::LandmarkSource;
using ::testing::HasSubstr;

TEST(LandmarksFile, KeepsWhereEachComesFromAndHowFarOffItMayBe) {
  const facenav::testing::TemporaryFolder folder;
  EXPECT_FALSE(readLandmarks(folder.path()));
  surface::ScalpLandmarks written;
  written[Landmark::nasion] =
      surface::ScalpLandmark{Point<Mri>(1.25, 84, -40), 1.5, LandmarkSource::skin, false, {}, {}};
  written[Landmark::tragus_left] = surface::ScalpLandmark{
      Point<Mri>(-80, -20, -48), 2, LandmarkSource::hand, true, "2026-11-23T14:05:09.123Z", "AB"};
  writeLandmarks(written, folder.path());
  const auto read = *readLandmarks(folder.path());
  EXPECT_FALSE(read[Landmark::inion]);
  EXPECT_FALSE(read.isComplete());
  EXPECT_THAT(read[Landmark::nasion]->point.mm,
              facenav::testing::EigenNear(Eigen::Vector3d(1.25, 84, -40), 1e-3));
  EXPECT_EQ(read[Landmark::tragus_left]->source, LandmarkSource::hand);
  EXPECT_TRUE(read[Landmark::tragus_left]->is_cut);
  EXPECT_EQ(read[Landmark::tragus_left]->by, "AB");
  EXPECT_FALSE(read[Landmark::nasion]->is_cut);
}

TEST(LandmarksFile, NamesFileAndKeyOfAFault) {
  const facenav::testing::TemporaryFolder folder;
  const auto refusal = [&](const std::string& landmark) -> std::string {
    writeWholeFile(folder.path() / "landmarks.json", R"({"landmarks": [)" + landmark + "]}");
    try {
      readLandmarks(folder.path());
    } catch (const Error& error) {
      return error.what();
    }
    return "read";
  };
  EXPECT_THAT(refusal(R"({"name": "nasion", "mm": [1, 2], "sd_mm": 1, "source": "skin"})"),
              HasSubstr("landmarks[0].mm"));
  EXPECT_THAT(refusal(R"({"name": "nasion", "mm": [1, 2, 3], "sd_mm": 1, "source": "guess"})"),
              HasSubstr("source"));
  EXPECT_THAT(refusal(R"({"name": "nasion", "mm": [1, 2, 3], "sd_mm": -1, "source": "skin"})"),
              HasSubstr("sd_mm"));
  EXPECT_EQ(refusal(R"({"name": "bregma", "mm": [1, 2, 3]})"), "read")
      << "another tool's landmark is passed over";
}

}  // namespace
}  // namespace facenav::casefile
