#include "resample.h"

#include <cmath>
#include <vector>

#include "facenav/core/parallel_for.h"
#include "kernels/resample_kernel.h"

namespace facenav::stereo {
namespace {

using namespace resample;

constexpr double kPoles[] = {-0.430575347099973, -0.0430962882032647};

double quinticSpline(double x) {
  x = std::abs(x);
  const double x2 = x * x, x3 = x2 * x, x4 = x3 * x, x5 = x4 * x;
  if (x < 1) return (66 - 60 * x2 + 30 * x4 - 10 * x5) / 120;
  if (x < 2) return (51 + 75 * x - 210 * x2 + 150 * x3 - 45 * x4 + 5 * x5) / 120;
  return x < 3 ? std::pow(3 - x, 5) / 120 : 0.0;
}

const std::vector<float>& weightTable() {
  static const std::vector<float> table = [] {
    std::vector<float> weights(std::size_t(kSteps + 1) * kLanes, 0.0f);
    for (int i = 0; i <= kSteps; ++i)
      for (int k = 0; k < kTaps; ++k)
        weights[std::size_t(i) * kLanes + k] = float(quinticSpline(double(i) / kSteps - (k - 2)));
    return weights;
  }();
  return table;
}

// Coefficients with kBorder more pixels on each side (mirrored).
cv::Mat coefficientsOf(const cv::Mat& image, const Kernel& kernel) {
  double gain = 1;
  for (const double pole : kPoles) gain *= (1 - pole) * (1 - 1 / pole);
  cv::Mat upright, turned;
  image.convertTo(upright, CV_32F, gain * gain);
  const auto filter = [&](cv::Mat& m) {
    for (const double pole : kPoles)
      kernel.filter_columns(m.ptr<float>(), int(m.step1()), m.cols, m.rows, float(pole));
  };
  filter(upright);
  cv::transpose(upright, turned);
  filter(turned);
  cv::transpose(turned, upright);
  cv::copyMakeBorder(upright, turned, kBorder, kBorder, kBorder, kBorder + kLanes - kTaps,
                     cv::BORDER_REFLECT_101);
  return turned;
}

}  // namespace

cv::Mat resampled(const cv::Mat& image, const cv::Mat& places) {
  const Kernel& kernel = resample::kernel();
  const cv::Mat coefficients = coefficientsOf(image, kernel);
  const float* first = coefficients.ptr<float>(kBorder) + kBorder;
  cv::Mat out(places.size(), CV_32F);
  parallelRanges(0, places.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      kernel.row(first, int(coefficients.step1()), image.cols, image.rows, weightTable().data(),
                 places.ptr<float>(y), places.cols, out.ptr<float>(y));
  });
  return out;
}

}  // namespace facenav::stereo
