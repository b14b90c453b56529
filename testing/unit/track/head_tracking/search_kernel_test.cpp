// The search's inner loops against plain arithmetic, for each instruction set.

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "head/face_template.h"
#include "head/search_kernel.h"

namespace facenav::head_tracking {
namespace {

std::vector<const search::Kernel*> kernels() {
  std::vector<const search::Kernel*> all = {&search::baseKernel()};
  if (&search::kernel() != all.front()) all.push_back(&search::kernel());
  return all;
}

template <class T>
cv::Mat_<T> randomImage(int rows, int cols, double most, int seed) {
  cv::Mat_<T> image(rows, cols);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(image, cv::RNG::UNIFORM, 0, most);
  return image;
}

TEST(SearchKernel, EvenedIsTheDeviationFromTheLocalMeanInLocalStandardDeviations) {
  BlurredImage level;
  level.pixels = randomImage<std::uint16_t>(40, 53, 65280, 1);
  const cv::Mat1f evened = head_tracking::evened(level), grey = greyOf(level);
  cv::Mat1f mean, squares;
  cv::boxFilter(grey, mean, CV_32F, {11, 11});
  cv::sqrBoxFilter(grey, squares, CV_32F, {11, 11});
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x) {
      const float m = mean(y, x), least = 1.f + 0.03f * m;
      EXPECT_NEAR(evened(y, x), (grey(y, x) - m) / std::sqrt(squares(y, x) - m * m + least * least), 2e-3);
    }
}

TEST(SearchKernel, CorrelationSumsTheStencilAtEveryPlace) {
  const cv::Mat1f image = randomImage<float>(30, 70, 1.0, 2);
  const cv::Point at[3] = {{0, 0}, {5, 2}, {9, 7}};
  const float value[3] = {1.f, -0.5f, 2.f};
  const float* from[3];
  for (int i = 0; i < 3; ++i) from[i] = image[at[i].y] + at[i].x;
  for (const auto* kernel : kernels()) {
    cv::Mat1f sums(20, 48);
    search::Correlation task;
    task.from = from, task.value = value, task.count = 3, task.stride = int(image.step1());
    task.columns = sums.cols, task.rows = sums.rows, task.sums = sums.ptr<float>();
    kernel->correlate(task);
    for (int y = 0; y < sums.rows; ++y)
      for (int x = 0; x < sums.cols; ++x) {
        float expected = 0;
        for (int i = 0; i < 3; ++i) expected += value[i] * image(y + at[i].y, x + at[i].x);
        EXPECT_NEAR(sums(y, x), expected, 1e-5);
      }
  }
}

// Two points before a camera along z, on an image whose grey values form a plane.
TEST(SearchKernel, TemplateSumsAreThoseOfItsPoints) {
  using F = search::TemplateField;
  constexpr float kFocal = 100.f, kSlope_u = 0.01f, kSlope_v = -0.02f;
  cv::Mat1f image(48, 64);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) image(y, x) = kSlope_u * float(x) + kSlope_v * float(y);
  std::vector<float> block(F::count * search::kLanes, 0.f);
  const Eigen::Vector3d points[2] = {{10, 5, 500}, {-20, -15, 520}};
  const float values[2] = {0.4f, -0.3f}, weights[2] = {0.9f, 0.6f};
  for (int i = 0; i < 2; ++i) {
    const auto set = [&](int field, double v) { block[std::size_t(field * search::kLanes + i)] = float(v); };
    set(F::x, points[i].x()), set(F::y, points[i].y()), set(F::z, points[i].z()), set(F::normal_z, -1.f);
    set(F::value, values[i]), set(F::weight, weights[i]);
    set(F::d00, kFocal), set(F::d11, kFocal), set(F::u0, 32.f), set(F::v0, 24.f);
  }
  search::TemplateView view;
  view.blocks = block.data(), view.block_count = 1;
  view.image = image.ptr<float>(), view.stride = int(image.step1());
  view.width = image.cols, view.height = image.rows;
  view.camera_T_head[0] = view.camera_T_head[4] = view.camera_T_head[8] = 1.f;
  view.centre[2] = 510.f, view.least_facing = 0.2f, view.reach = 1.5f;
  Matrix6d normal = Matrix6d::Zero();
  Vector6d pull = Vector6d::Zero();
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d& p = points[i];
    const float e =
        values[i] - (kSlope_u * (kFocal * p.x() / p.z() + 32) + kSlope_v * (kFocal * p.y() / p.z() + 24));
    const double w = std::min(double(weights[i]), p.z() / p.norm()) / (1 + e * e / 2.25f);
    const Eigen::Vector3d by(kSlope_u * kFocal / p.z(), kSlope_v * kFocal / p.z(),
                             -kFocal * (kSlope_u * p.x() + kSlope_v * p.y()) / (p.z() * p.z()));
    Vector6d j;
    j << (p - Eigen::Vector3d(0, 0, 510)).cross(by), by;
    normal += w * j * j.transpose(), pull += w * e * j;
  }
  for (const auto* kernel : kernels()) {
    const auto sums = kernel->sum(view);
    EXPECT_EQ(sums.seen, 2.f);
    for (int i = 0, n = 0; i < 6; ++i) {
      EXPECT_NEAR(sums.pull[i], pull(i), 1e-4 * pull.norm()) << i;
      for (int j = i; j < 6; ++j) EXPECT_NEAR(sums.normal[n++], normal(i, j), 1e-4 * normal.norm());
    }
  }
}

}  // namespace
}  // namespace facenav::head_tracking
