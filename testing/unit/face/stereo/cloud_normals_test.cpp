#include "cloud/cloud_normals.h"

#include <gtest/gtest.h>

#include <limits>

#include "analytic_scene.h"

namespace facenav::stereo {
namespace {

Rectification camera() {
  Rectification r;
  r.f_px = 800, r.baseline_mm = 120, r.cx_left_px = 70, r.cx_right_px = 64, r.cy_px = 55, r.disparities = 200;
  return r;
}

/// Disparities of a plane in space, through `point_mm` (rectified frame).
DisparityMap planeInSpace(const Rectification& r, const cv::Size& size, const Eigen::Vector3d& point_mm,
                          const Eigen::Vector3d& normal) {
  DisparityMap map;
  map.disparity_px.create(size, CV_32F);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const Eigen::Vector3d ray((x - r.cx_left_px) / r.f_px, (y - r.cy_px) / r.f_px, 1);
      const double z_mm = normal.dot(point_mm) / normal.dot(ray);
      map.disparity_px.at<float>(y, x) = float(r.f_px * r.baseline_mm / z_mm + r.offset_px());
    }
  return map;
}

double offAt_deg(const cv::Mat& normals, int y, int x, const Eigen::Vector3d& truth) {
  const cv::Vec3f n = normals.at<cv::Vec3f>(y, x);
  const Eigen::Vector3d found(n[0], n[1], n[2]);
  return std::atan2(found.cross(truth).norm(), found.dot(truth)) * 180 / M_PI;
}

TEST(CloudNormals, OfAPlaneAreThePlanesTowardsTheCamera) {
  const Rectification r = camera();
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0.5, 0.2, -1), Eigen::Vector3d(-0.9, 0.4, -1)}) {
    const Eigen::Vector3d normal = direction.normalized();
    const cv::Mat normals = diskNormals(r, planeInSpace(r, {140, 110}, {0, 0, 600}, normal));
    for (int y = 0; y < normals.rows; y += 9)
      for (int x = 0; x < normals.cols; x += 7) EXPECT_LT(offAt_deg(normals, y, x, normal), 0.1);
  }
}

TEST(CloudNormals, OfTwoSurfacesAreEachItsOwn) {
  const Rectification r = camera();
  const Eigen::Vector3d near_normal = Eigen::Vector3d(0.3, 0, -1).normalized(),
                        far_normal = Eigen::Vector3d(-0.3, 0.2, -1).normalized();
  DisparityMap map = planeInSpace(r, {140, 110}, {0, 0, 500}, near_normal);
  const DisparityMap far = planeInSpace(r, {140, 110}, {0, 0, 800}, far_normal);
  const cv::Rect right(70, 0, 70, 110);
  far.disparity_px(right).copyTo(map.disparity_px(right));
  const cv::Mat normals = diskNormals(r, map);
  for (int y = 10; y < 100; y += 5) {
    EXPECT_LT(offAt_deg(normals, y, 69, near_normal), 0.2) << "the last column of the near one";
    EXPECT_LT(offAt_deg(normals, y, 70, far_normal), 0.2);
  }
}

TEST(CloudNormals, AreNoneWhereTooFewDisparitiesAre) {
  const Rectification r = camera();
  DisparityMap map = planeInSpace(r, {60, 60}, {0, 0, 600}, {0, 0, -1});
  const float none = std::numeric_limits<float>::quiet_NaN();
  map.disparity_px(cv::Rect(20, 20, 15, 15)).setTo(none);
  map.disparity_px(cv::Rect(26, 26, 4, 4)).setTo(160 + r.offset_px());  // an island of 16 < 20
  const cv::Mat normals = diskNormals(r, map);
  EXPECT_TRUE(std::isnan(normals.at<cv::Vec3f>(22, 22)[0])) << "no disparity there";
  EXPECT_TRUE(std::isnan(normals.at<cv::Vec3f>(27, 27)[0])) << "an island";
  EXPECT_FALSE(std::isnan(normals.at<cv::Vec3f>(10, 10)[0]));
  EXPECT_FALSE(std::isnan(normals.at<cv::Vec3f>(0, 0)[0])) << "a quarter of the disk is enough";
}

}  // namespace
}  // namespace facenav::stereo
