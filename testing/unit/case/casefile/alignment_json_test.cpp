#include <gtest/gtest.h>

#include <cmath>

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
  alignment.face_scale = registration::FaceScale{0.987, 0.004};
  alignment.face_size_error = 0.0021;
  alignment.cautions = {"the skin fits loosely"};
  writeAlignment(alignment, folder.path() / "alignment.json");
  const StoredAlignment read = readAlignment(folder.path() / "alignment.json");
  EXPECT_THAT(read.camera_T_mri, PoseNear(alignment.camera_T_mri, 1e-9, 1e-12));
  EXPECT_EQ(read.points, 15234);
  EXPECT_EQ(read.max_mm, 1.7);
  EXPECT_EQ(read.predicted_tre_mm, alignment.predicted_tre_mm);
  EXPECT_EQ(read.predicted_tre_p95_mm, alignment.predicted_tre_p95_mm);
  ASSERT_TRUE(read.face_scale);
  EXPECT_DOUBLE_EQ(read.face_scale->value, 0.987);
  EXPECT_DOUBLE_EQ(read.face_scale->sigma, 0.004);
  EXPECT_EQ(read.face_size_error, 0.0021);
  EXPECT_EQ(read.cautions, alignment.cautions);
}

TEST(AlignmentJson, TheMatcherIsWrittenOnlyWhereItIsNotTheDefault) {
  const TemporaryFolder folder;
  StoredAlignment alignment;
  writeAlignment(alignment, folder.path() / "default.json");
  EXPECT_EQ(readWholeFile(folder.path() / "default.json").find("matcher"), std::string::npos);
  EXPECT_FALSE(readAlignment(folder.path() / "default.json").matcher);
  alignment.matcher = "ssd";
  writeAlignment(alignment, folder.path() / "ssd.json");
  EXPECT_EQ(readAlignment(folder.path() / "ssd.json").matcher, "ssd");
}

TEST(AlignmentJson, SaysWhatItWasAlignedFromAndReadsFilesThatDoNot) {
  const TemporaryFolder folder;
  StoredAlignment alignment;
  writeAlignment(alignment, folder.path() / "older.json");
  EXPECT_FALSE(readAlignment(folder.path() / "older.json").from);
  alignment.from = "plain";
  writeAlignment(alignment, folder.path() / "plain.json");
  EXPECT_EQ(readAlignment(folder.path() / "plain.json").from, "plain");
}

/// Standard errors: a rotation of 2 mrad about Camera's x at the image of Mri's origin, and 0.3 mm along each
/// axis.
StoredAlignment withCovariance() {
  StoredAlignment alignment;
  alignment.camera_T_mri = {Eigen::Quaterniond::Identity(), {0, 0, 600}};
  alignment.uncertainty.emplace();
  alignment.uncertainty->covariance.diagonal() << 0.002 * 0.002, 0, 0, 0.09, 0.09, 0.09;
  alignment.uncertainty->freedom = 12;
  alignment.predicted_tre_mm = {{"M1 hand L", 0.42}};
  return alignment;
}

guidance::Target targetAt(const std::string& name, const Point<Mri>& cortex_point) {
  guidance::Target target;
  target.name = name;
  target.cortex_point = cortex_point;
  return target;
}

TEST(AlignmentJson, ThePredictedErrorIsKnownForRenamedAndLaterTargets) {
  const TemporaryFolder folder;
  writeAlignment(withCovariance(), folder.path() / "alignment.json");
  const StoredAlignment read = readAlignment(folder.path() / "alignment.json");
  ASSERT_TRUE(read.uncertainty);
  EXPECT_DOUBLE_EQ(read.uncertainty->freedom, 12);
  const Point<Mri> place(0, 100, 0);  // 100 mm from the axis: the rotation gives 0.2 mm
  for (const char* name : {"renamed", "M1 hand L", "made later"}) {
    const auto error_mm = read.predictedError_mm(targetAt(name, place));
    ASSERT_TRUE(error_mm) << name;
    EXPECT_NEAR(*error_mm, std::sqrt(3 * 0.09 + 0.04), 1e-9) << name;
  }
  EXPECT_NEAR(*read.predictedError_mm(targetAt("at the origin", {})), std::sqrt(3 * 0.09), 1e-9);
}

TEST(AlignmentJson, AnOlderFileSaysWhatItHasUnderTheOldNames) {
  const TemporaryFolder folder;
  StoredAlignment older = withCovariance();
  older.uncertainty.reset();
  writeAlignment(older, folder.path() / "alignment.json");
  const StoredAlignment read = readAlignment(folder.path() / "alignment.json");
  EXPECT_FALSE(read.uncertainty);
  EXPECT_EQ(read.predictedError_mm(targetAt("M1 hand L", {})), 0.42);
  EXPECT_FALSE(read.predictedError_mm(targetAt("renamed", {})));
}

TEST(AlignmentJson, KeepsTheSettingsThatDifferedAndNothingWhereNoneDid) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "alignment.json";
  StoredAlignment alignment = withCovariance();
  writeAlignment(alignment, path);
  EXPECT_EQ(readWholeFile(path).find("settings"), std::string::npos);
  alignment.settings = {{"registration.wrong_median_mm", 0.8}, {"of.another_version", 3}};
  writeAlignment(alignment, path);
  EXPECT_EQ(readAlignment(path).settings, alignment.settings);
}

TEST(AlignmentJson, RefusesACovarianceThatIsNone) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "alignment.json";
  const auto faultOf = [&](const std::string& values) -> std::string {
    writeWholeFile(path, R"({"camera_T_mri": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "rms_mm": 0.3, "max_mm": 1,
      "inlier_fraction": 0.9, "points": 9, "pose_covariance_deg_mm": [)" +
                             values + "]}");
    try {
      readAlignment(path);
    } catch (const Error& fault) {
      return fault.what();
    }
    return "";
  };
  const auto matrix = [](const char* first, const char* second) {
    return std::string(first) + ",0,0,0,0," + second +
           ", 0,1,0,0,0,0, 0,0,1,0,0,0, 0,0,0,1,0,0, 0,0,0,0,1,0, 0,0,0,0,0,1";
  };
  EXPECT_EQ(faultOf(matrix("1", "0")), "");
  for (const auto& wrong : {std::string("1,0,0"), matrix("1", "5"), matrix("-1", "0")})
    EXPECT_NE(faultOf(wrong).find("pose_covariance_deg_mm"), std::string::npos) << wrong;
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
