#include "facenav/stereo/cloud_file.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "support/stereo_scene.h"

using namespace facenav;
using namespace facenav::stereo;
namespace support = facenav::testing;

namespace {

/// A PLY file as another program reads it: columns by name.
struct Ply {
  std::vector<std::string> names;
  std::vector<std::map<std::string, double>> rows;
  std::size_t stated = 0;
};

Ply readPly(const std::string& text) {
  Ply ply;
  std::istringstream stream(text);
  std::string line, word, type, name;
  std::getline(stream, line);
  EXPECT_EQ(line, "ply");
  std::getline(stream, line);
  EXPECT_EQ(line, "format ascii 1.0");
  while (std::getline(stream, line) && line != "end_header") {
    std::istringstream words(line);
    words >> word >> type >> name;
    if (word == "element") ply.stated = std::stoul(name);
    if (word == "property") ply.names.push_back(name);
  }
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    std::map<std::string, double> row;
    for (const auto& column : ply.names) words >> row[column];
    EXPECT_TRUE(words) << line;
    EXPECT_FALSE(words >> word) << line;
    ply.rows.push_back(row);
  }
  return ply;
}

FusedCloud sphereSeenWithDots(const cameras::StereoRig& rig) {
  const support::Scene scene(support::sphere({0, 0, 660}, 60), {});
  TaskMonitor monitor;
  FusedCloud cloud{measureFace(rig, scene.render(rig), {}, monitor), {}};
  cloud.frames.assign(cloud.face.cloud.size(), 3);
  return cloud;
}

}  // namespace

TEST(CloudFile, IsReadBackAsItWasMeasured) {
  const cameras::StereoRig rig = support::cropped(support::convergingRig());
  const FusedCloud cloud = sphereSeenWithDots(rig);
  cv::Mat left(rig.height_px, rig.width_px, CV_8U);
  for (int y = 0; y < left.rows; ++y)
    for (int x = 0; x < left.cols; ++x) left.at<std::uint8_t>(y, x) = std::uint8_t((x + 2 * y) % 256);
  const Ply ply = readPly(plyText(cloud, left));
  ASSERT_EQ(ply.stated, cloud.face.cloud.size());
  ASSERT_EQ(ply.rows.size(), cloud.face.cloud.size());
  ASSERT_GT(ply.rows.size(), 5000u);
  for (std::size_t i = 0; i < ply.rows.size(); ++i) {
    const auto& row = ply.rows[i];
    const Eigen::Vector3d p(row.at("x"), row.at("y"), row.at("z")),
        n(row.at("nx"), row.at("ny"), row.at("nz"));
    ASSERT_LT((p - cloud.face.cloud.points_mm[i]).norm(), 2e-4);
    ASSERT_NEAR(n.norm(), 1, 1e-4);
    ASSERT_LT(n.dot(p), 0) << "a normal away from the camera";
    ASSERT_NEAR(row.at("sigma_mm"), cloud.face.sigma_mm[i], 1e-4);
    ASSERT_EQ(row.at("frames"), 3);
    const int x = int(std::lround(cloud.face.left_px[i].x())),
              y = int(std::lround(cloud.face.left_px[i].y()));
    for (const char* colour : {"red", "green", "blue"}) ASSERT_EQ(row.at(colour), (x + 2 * y) % 256);
  }
}

TEST(CloudFile, AColourPictureGivesColours) {
  FusedCloud cloud;
  cloud.face.cloud.points_mm = {{0, 0, 600}};
  cloud.face.cloud.normals = {{0, 0, -1}};
  cloud.face.left_px = {{1.4f, 0.6f}};
  cloud.face.sigma_mm = {0.25f};
  cloud.frames = {1};
  cv::Mat left(3, 3, CV_8UC3, cv::Scalar(0, 0, 0));
  left.at<cv::Vec3b>(1, 1) = {10, 20, 30};  // blue, green, red
  const auto row = readPly(plyText(cloud, left)).rows.at(0);
  EXPECT_EQ(row.at("red"), 30);
  EXPECT_EQ(row.at("green"), 20);
  EXPECT_EQ(row.at("blue"), 10);
}
