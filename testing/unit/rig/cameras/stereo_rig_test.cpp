#include "facenav/cameras/stereo_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/persistence.hpp>
#include <regex>

#include "facenav/cameras/projector_model.h"
#include "facenav/cameras/reduced_pair.h"
#include "facenav/cameras/rig_file.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/matchers.h"
#include "support/stereo_rigs.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::cameras;
using facenav::testing::EigenNear;
namespace rigs = facenav::testing;

namespace {

std::vector<StereoRig> allRigs() {
  return {rigs::convergingRig(), rigs::verticalRig(), rigs::rolledRig(), rigs::fullyDistortedRig()};
}

std::string messageOfReading(const std::string& content) {
  rigs::TemporaryFolder folder;
  std::ofstream(folder.path() / "stereo.yml") << content;
  try {
    readRig(folder.path() / "stereo.yml");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string goodRigText() {
  rigs::TemporaryFolder folder;
  writeRig(rigs::convergingRig(), folder.path() / "stereo.yml");
  return readWholeFile(folder.path() / "stereo.yml");
}

// Removes the key's whole entry (up to the next key at the start of a line).
std::string without(const std::string& text, const std::string& key) {
  return std::regex_replace(text, std::regex("(^|\n)" + key + ":[^\n]*(\n [^\n]*)*"), "$1");
}

}  // namespace

TEST(StereoRig, SurvivesWritingAndReading) {
  for (StereoRig rig : allRigs()) {
    rig.rms_px = 0.125;
    rigs::TemporaryFolder folder;
    writeRig(rig, folder.path() / "stereo.yml");
    const StereoRig read = readRig(folder.path() / "stereo.yml");
    EXPECT_EQ(read.width_px, 640);
    EXPECT_EQ(read.height_px, 480);
    EXPECT_LT(cv::norm(cv::Mat(read.left.k), cv::Mat(rig.left.k)), 1e-12);
    EXPECT_LT(cv::norm(read.right.distortion, rig.right.distortion), 1e-15);
    EXPECT_THAT(read.right_T_left, rigs::PoseNear(rig.right_T_left, 1e-9, 1e-9));
    EXPECT_NEAR(*read.rms_px, 0.125, 1e-12);
  }
}

TEST(StereoRig, RowTimesAndErrorsMakeNoOtherCalibrationButLensesAndPlacesDo) {
  for (const StereoRig& rig : allRigs()) {
    StereoRig same = rig;
    same.left.row_time_s = 20e-6;
    same.rms_px = 0.9;
    same.covariance.release();
    EXPECT_TRUE(isSameCalibration(rig, same));
    StereoRig other = rig;
    other.right.k(0, 0) += 0.1;
    EXPECT_FALSE(isSameCalibration(rig, other));
    other = rig;
    other.left.distortion = cv::Mat::ones(1, 8, CV_64F);
    EXPECT_FALSE(isSameCalibration(rig, other));
    other = rig;
    other.right_T_left = RigidTransform<RightCamera, Camera>(rig.right_T_left.quaternion(),
                                                             rig.right_T_left.translation_mm() * 1.001);
    EXPECT_FALSE(isSameCalibration(rig, other));
    other = rig;
    other.width_px += 1;
    EXPECT_FALSE(isSameCalibration(rig, other));
  }
}

TEST(StereoRig, ProjectsAsOpenCvDoes) {
  for (const StereoRig& rig : allRigs())
    for (const CameraModel& camera : {rig.left, rig.right})
      for (const cv::Point3d p :
           {cv::Point3d(10, -20, 600), cv::Point3d(-170, 120, 500), cv::Point3d(200, 150, 700)}) {
        std::vector<cv::Point2d> expected;
        cv::projectPoints(std::vector<cv::Point3d>{p}, cv::Vec3d(), cv::Vec3d(), camera.k, camera.distortion,
                          expected);
        EXPECT_THAT(project(camera, {p.x, p.y, p.z}),
                    EigenNear(Eigen::Vector2d(expected[0].x, expected[0].y), 1e-9));
      }
}

TEST(StereoRig, ProjectionDerivativeIsThatOfDifferences) {
  for (const StereoRig& rig : allRigs())
    for (const CameraModel& camera : {rig.left, rig.right}) {
      const Eigen::Vector3d p(140, -110, 560);
      Eigen::Matrix<double, 2, 3> analytic, numeric;
      EXPECT_THAT(project(camera, p, analytic), EigenNear(project(camera, p), 1e-12));
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d step = 1e-3 * Eigen::Vector3d::Unit(axis);
        numeric.col(axis) = (project(camera, p + step) - project(camera, p - step)) / 2e-3;
      }
      EXPECT_LT((analytic - numeric).cwiseAbs().maxCoeff(), 1e-7);
    }
}

TEST(StereoRig, UndistortInvertsProjectionOverTheWholeImage) {
  for (const StereoRig& rig : allRigs())
    for (const CameraModel& camera : {rig.left, rig.right})
      for (double y = 0; y < 480; y += 53)
        for (double x = 0; x < 640; x += 71)
          EXPECT_THAT(project(camera, undistort(camera, {x, y}).homogeneous()),
                      EigenNear(Eigen::Vector2d(x, y), 1e-7));
}

TEST(StereoRig, NamesEachMissingKey) {
  const std::string text = goodRigText();
  for (const std::string key : {"image_width", "image_height", "K1", "D1", "K2", "D2", "R", "T"}) {
    const std::string message = messageOfReading(without(text, key));
    EXPECT_NE(message.find("'" + key + "'"), std::string::npos) << message;
    EXPECT_NE(message.find("stereo.yml"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(StereoRig, RefusesTranslationInMetres) {
  StereoRig rig = rigs::convergingRig();
  rig.right_T_left = {rig.right_T_left.quaternion(), rig.right_T_left.translation_mm() * 1e-3};
  rigs::TemporaryFolder folder;
  writeRig(rig, folder.path() / "m.yml");
  EXPECT_NE(messageOfReading(readWholeFile(folder.path() / "m.yml")).find("metres"), std::string::npos);
}

TEST(StereoRig, RefusesWhatIsNoRig) {
  const std::string text = goodRigText();
  const auto replaced = [&](const std::string& key, const std::string& entry) {
    return without(text, key) + "\n" + key + ": " + entry + "\n";
  };
  const auto matrix = [](int rows, int cols, const std::string& values) {
    return "!!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(cols) +
           "\n   dt: d\n   data: [ " + values + " ]";
  };
  EXPECT_NE(messageOfReading(replaced("R", matrix(3, 3, "-1.,0.,0.,0.,1.,0.,0.,0.,1."))).find("'R'"),
            std::string::npos);
  EXPECT_NE(messageOfReading(replaced("R", matrix(3, 3, "1.1,0.,0.,0.,1.,0.,0.,0.,1."))).find("'R'"),
            std::string::npos);
  EXPECT_NE(messageOfReading(replaced("T", matrix(3, 1, "0.,0.,0."))).find("'T'"), std::string::npos);
  EXPECT_NE(messageOfReading(replaced("T", matrix(2, 1, "100.,0."))).find("'T'"), std::string::npos);
  EXPECT_NE(messageOfReading(replaced("T", "120")).find("'T'"), std::string::npos);
  EXPECT_NE(messageOfReading(replaced("T", matrix(3, 1, "120., .Nan, 0."))).find("'T'"), std::string::npos);
  EXPECT_NE(messageOfReading(replaced("K1", matrix(3, 3, "0.,0.,0.,0.,1.,0.,0.,0.,1."))).find("'K1'"),
            std::string::npos);
  EXPECT_NE(messageOfReading(replaced("K2", matrix(3, 3, "800.,0.,0.,9.,800.,0.,0.,0.,1."))).find("'K2'"),
            std::string::npos);
  EXPECT_NE(messageOfReading(replaced("D1", matrix(1, 6, "0.,0.,0.,0.,0.,0."))).find("'D1'"),
            std::string::npos);
  EXPECT_NE(messageOfReading(replaced("image_width", "0")).find("'image_width'"), std::string::npos);
  EXPECT_NE(messageOfReading(replaced("image_width", "\"wide\"")).find("'image_width'"), std::string::npos);
}

static ProjectorModel someProjector() {
  ProjectorModel projector;
  projector.width_px = 1024, projector.height_px = 768;
  projector.lens.k = cv::Matx33d(1400, 0, 511.5, 0, 1402, 380, 0, 0, 1);
  projector.lens.distortion = (cv::Mat_<double>(1, 5) << 0.01, -0.02, 0, 0.001, 0);
  projector.projector_T_camera = {Eigen::Quaterniond(0.99, 0.1, -0.05, 0.02), {5, -70, 20}};
  return projector;
}

TEST(ProjectorModel, RoundTrips) {
  const rigs::TemporaryFolder folder;
  const auto path = folder.path() / "projector.yml";
  const auto written = someProjector();
  writeProjector(written, path);
  const auto read = readProjector(path);
  EXPECT_EQ(read.width_px, 1024);
  EXPECT_EQ(read.lens.k, written.lens.k);
  EXPECT_EQ(cv::norm(read.lens.distortion, written.lens.distortion), 0);
  EXPECT_LT((read.projector_T_camera.matrix() - written.projector_T_camera.matrix()).norm(), 1e-9);
}

TEST(ProjectorModel, AFaultNamesFileAndKey) {
  const rigs::TemporaryFolder folder;
  const auto path = folder.path() / "projector.yml";
  writeProjector(someProjector(), path);
  const std::string whole = readWholeFile(path);
  const auto faultWith = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    writeWholeFile(path, text);
    try {
      readProjector(path);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(faultWith("image_width", "image_w").find("key 'image_width' is missing"), std::string::npos);
  EXPECT_NE(faultWith("K:", "L:").find("key 'K' is missing"), std::string::npos);
  EXPECT_NE(faultWith("K:", "L:").find("projector.yml"), std::string::npos);
  auto metres = someProjector();
  metres.projector_T_camera = {Eigen::Quaterniond::Identity(), {0.005, -0.07, 0.02}};
  writeProjector(metres, path);
  EXPECT_THROW(readProjector(path), Error);
}

TEST(StereoRig, KeepsTheRowTimesOfARollingShutter) {
  StereoRig rig = rigs::convergingRig();
  rig.left.row_time_s = 41.5e-6, rig.right.row_time_s = -30e-6;
  rigs::TemporaryFolder folder;
  writeRig(rig, folder.path() / "stereo.yml");
  const StereoRig read = readRig(folder.path() / "stereo.yml");
  EXPECT_NEAR(read.left.row_time_s, 41.5e-6, 1e-15);
  EXPECT_NEAR(read.right.row_time_s, -30e-6, 1e-15);
  EXPECT_NEAR(reduced(read, 2).left.row_time_s, 83e-6, 1e-15);
  EXPECT_EQ(goodRigText().find("row_time"),
            std::string::npos);  // all rows at once: as older versions wrote it
}

TEST(StereoRig, RefusesARowTimeThatIsNotInMicroseconds) {
  const std::string message = messageOfReading(goodRigText() + "row_time1_us: 20000.\n");
  EXPECT_THAT(message, ::testing::HasSubstr("row_time1_us"));
  EXPECT_THAT(message, ::testing::HasSubstr("9600 ms"));
  EXPECT_THAT(messageOfReading(goodRigText() + "row_time2_us: .Nan\n"), ::testing::HasSubstr("row_time2_us"));
}

TEST(StereoRig, DamagedFileIsAnErrorNotACrash) {
  const std::string text = goodRigText();
  EXPECT_NE(messageOfReading("").find("YAML"), std::string::npos);
  EXPECT_NE(messageOfReading("%YAML:1.0\n---\n- 1\n- 2\n").find("stereo.yml"), std::string::npos);
  EXPECT_NE(messageOfReading(std::string("\x89PNG\r\n\x1a\n\0\0\0", 11)).find("stereo.yml"),
            std::string::npos);
  // A cut before "E" loses a required key. Later cuts lose optional keys only, and the rig must then be the
  // same.
  const std::size_t optional_from = text.find("\nE:");
  for (std::size_t length = 0; length < optional_from - 40; length += 37)
    EXPECT_NE(messageOfReading(text.substr(0, length)).find("stereo.yml"), std::string::npos) << length;
  EXPECT_THROW(readRig("/nonexistent/stereo.yml"), Error);
}

TEST(StereoRig, ReadsEveryDistortionLength) {
  for (int n : {0, 4, 5, 8, 12, 14}) {
    StereoRig rig = rigs::convergingRig();
    cv::Mat d(1, n, CV_64F);
    for (int i = 0; i < n; ++i) d.at<double>(i) = 0.001 * (i + 1);
    rig.left.distortion = d;
    rigs::TemporaryFolder folder;
    writeRig(rig, folder.path() / "s.yml");
    const StereoRig read = readRig(folder.path() / "s.yml");
    EXPECT_THAT(project(read.left, {50, 60, 500}), EigenNear(project(rig.left, {50, 60, 500}), 1e-9));
  }
}

TEST(StereoRig, NotesAndTheEffectAtTheHeadAreWritten) {
  rigs::TemporaryFolder folder;
  const auto file = folder.path() / "stereo.yml";
  const HeadEffect effect{560.5, 0.31, 0.12, 0.07, 0.05, 0.011};
  writeRig(rigs::convergingRig(), file, {"9x6, 25 mm", 14, "2026-01-02T03:04:05Z", effect});
  const cv::FileStorage yaml(file.string(), cv::FileStorage::READ);
  EXPECT_EQ(std::string(yaml["board"]), "9x6, 25 mm");
  EXPECT_EQ(int(yaml["views"]), 14);
  EXPECT_EQ(std::string(yaml["created"]), "2026-01-02T03:04:05Z");
  EXPECT_DOUBLE_EQ(double(yaml["effect_distance_mm"]), 560.5);
  EXPECT_DOUBLE_EQ(double(yaml["effect_point_mm"]), 0.31);
  EXPECT_DOUBLE_EQ(double(yaml["effect_depth_mm"]), 0.12);
  EXPECT_DOUBLE_EQ(double(yaml["effect_length_mm"]), 0.07);
  EXPECT_DOUBLE_EQ(double(yaml["effect_motion_mm"]), 0.05);
  EXPECT_DOUBLE_EQ(double(yaml["effect_motion_deg"]), 0.011);
  EXPECT_EQ(readRig(file).width_px, 640);  // unknown keys are no error
}

TEST(StereoRig, AFileWithoutNotesIsReadAsWell) {
  rigs::TemporaryFolder folder;
  const auto file = folder.path() / "stereo.yml";
  writeRig(rigs::convergingRig(), file);
  EXPECT_EQ(readWholeFile(file).find("effect"), std::string::npos);
  const cv::FileStorage yaml(file.string(), cv::FileStorage::READ);
  for (const char* key : {"board", "views", "created"}) EXPECT_TRUE(yaml[key].empty()) << key;
  EXPECT_NEAR(readRig(file).baseline_mm(), rigs::convergingRig().baseline_mm(), 1e-9);
}
