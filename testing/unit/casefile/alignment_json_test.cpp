#include <gtest/gtest.h>

#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {
using facenav::testing::PoseNear;
using facenav::testing::TemporaryFolder;

TEST(AlignmentJson, RoundTripKeepsEveryDigit) {
  const TemporaryFolder folder;
  StoredAlignment alignment;
  alignment.camera_T_mri = {Eigen::Quaterniond(0.1, -0.7, 0.5, 0.3), {1.0 / 3, -20, 612.123456789}};
  alignment.rms_mm = 0.31;
  alignment.max_mm = 1.7;
  alignment.inlier_fraction = 0.93;
  alignment.points = 15234;
  alignment.predicted_tre_mm = {{"M1 hand L", 0.42}};
  alignment.predicted_tre_p95_mm = {{"M1 hand L", 0.81}};
  alignment.face_scale = 0.987;
  alignment.face_scale_sigma = 0.004;
  alignment.cautions = {"the skin fits loosely"};
  writeAlignment(alignment, folder.path() / "alignment.json");
  const StoredAlignment read = readAlignment(folder.path() / "alignment.json");
  EXPECT_THAT(read.camera_T_mri, PoseNear(alignment.camera_T_mri, 1e-9, 1e-12));
  EXPECT_EQ(read.points, 15234);
  EXPECT_EQ(read.max_mm, 1.7);
  EXPECT_EQ(read.predicted_tre_mm, alignment.predicted_tre_mm);
  EXPECT_EQ(read.predicted_tre_p95_mm, alignment.predicted_tre_p95_mm);
  EXPECT_DOUBLE_EQ(read.face_scale, 0.987);
  EXPECT_DOUBLE_EQ(read.face_scale_sigma, 0.004);
  EXPECT_EQ(read.cautions, alignment.cautions);
}

TEST(AlignmentJson, RefusesWhatCannotBeAPose) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "alignment.json";
  const std::string rest = R"(, "rms_mm": 0.3, "max_mm": 1, "inlier_fraction": 0.9, "points": 9})";
  const auto faultOf = [&](const std::string& content) -> std::string {
    writeWholeFile(path, content);
    try {
      readAlignment(path);
    } catch (const Error& fault) {
      return fault.what();
    }
    return "";
  };
  EXPECT_EQ(faultOf(R"({"camera_T_mri": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1])" + rest), "");
  EXPECT_NE(faultOf(R"({"camera_T_mri": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1])" + rest).find("mirrored"),
            std::string::npos);
  EXPECT_NE(faultOf(R"({"camera_T_mri": [1,0,0,0])" + rest).find("camera_T_mri"), std::string::npos);
  EXPECT_NE(faultOf(R"({"camera_T_mri": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})").find("rms_mm"),
            std::string::npos);
}

}  // namespace
}  // namespace facenav::casefile
