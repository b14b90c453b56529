#include "facenav/stereo/cloud_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "facenav/core/error.h"

namespace facenav::stereo {
namespace {

std::string headerOf(std::size_t points) {
  std::string text =
      "ply\nformat ascii 1.0\ncomment frame: Camera, mm\nelement vertex " + std::to_string(points) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    text += std::string("property float ") + name + "\n";
  for (const char* name : {"red", "green", "blue"}) text += std::string("property uchar ") + name + "\n";
  return text + "property float sigma_mm\nproperty ushort frames\nend_header\n";
}

/// The pixel's colour: blue, green, red.
cv::Vec3b colourAt(const cv::Mat& left, const Eigen::Vector2f& px) {
  const int column = std::clamp(int(std::lround(px.x())), 0, left.cols - 1);
  const int row = std::clamp(int(std::lround(px.y())), 0, left.rows - 1);
  if (left.channels() == 3) return left.at<cv::Vec3b>(row, column);
  const auto grey = left.at<std::uint8_t>(row, column);
  return {grey, grey, grey};
}

}  // namespace

std::string plyText(const FusedCloud& cloud, const cv::Mat& left) {
  FACENAV_EXPECT(left.type() == CV_8UC1 || left.type() == CV_8UC3, "an 8-bit picture, grey or colour");
  const FaceCloud& face = cloud.face;
  std::string text = headerOf(face.cloud.size());
  for (std::size_t i = 0; i < face.cloud.size(); ++i) {
    const Eigen::Vector3d &p = face.cloud.points_mm[i], &n = face.cloud.normals[i];
    const cv::Vec3b colour = colourAt(left, face.left_px[i]);
    char line[200];
    std::snprintf(line, sizeof line, "%.4f %.4f %.4f %.5f %.5f %.5f %d %d %d %.4f %d\n", p.x(), p.y(), p.z(),
                  n.x(), n.y(), n.z(), colour[2], colour[1], colour[0], double(face.sigma_mm[i]),
                  cloud.frames[i]);
    text += line;
  }
  return text;
}

}  // namespace facenav::stereo
