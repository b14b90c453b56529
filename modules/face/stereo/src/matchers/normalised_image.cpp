#include "normalised_image.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "facenav/core/parallel_for.h"
#include "kernels/block_kernel.h"

namespace facenav::stereo {
namespace {

constexpr int kCell = block::kBlock;  // statistics are computed for cells of 4 x 4 pixels
constexpr int kWindow_cells = 5;      // window centred on each cell
constexpr float kNoise_grey = 2.0f;   // contrast below this is noise and is not stretched
constexpr float kLevels_per_sigma = 9.0f;

struct Statistics {
  cv::Mat mean, scale;  // per cell: level = (grey - mean) * scale
};

Statistics statisticsOf(const cv::Mat& image, const block::Kernel& kernel) {
  const cv::Size cells((image.cols + kCell - 1) / kCell, (image.rows + kCell - 1) / kCell);
  cv::Mat whole = image;
  if (image.cols % kCell || image.rows % kCell)
    cv::copyMakeBorder(image, whole, 0, cells.height * kCell - image.rows, 0,
                       cells.width * kCell - image.cols, cv::BORDER_REPLICATE);
  cv::Mat sum(cells, CV_32F, cv::Scalar(0)), square(cells, CV_32F, cv::Scalar(0));
  std::vector<float> columns(2 * std::size_t(whole.cols));
  for (int cell = 0; cell < cells.height; ++cell)
    kernel.cell_sums(whole.ptr<float>(cell * kCell), int(whole.step1()), whole.cols, columns.data(),
                     sum.ptr<float>(cell), square.ptr<float>(cell));
  const cv::Size window(kWindow_cells, kWindow_cells);
  cv::boxFilter(sum, sum, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
  cv::boxFilter(square, square, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
  Statistics statistics{sum / (kCell * kCell), square / (kCell * kCell)};
  for (int i = 0; i < int(statistics.mean.total()); ++i) {
    const float mean = statistics.mean.ptr<float>()[i];
    float& scale = statistics.scale.ptr<float>()[i];
    scale = kLevels_per_sigma / (std::sqrt(std::max(scale - mean * mean, 0.0f)) + kNoise_grey);
  }
  return statistics;
}

}  // namespace

cv::Mat normalisedImage(const cv::Mat& image, const cv::Mat& mask, int invalid, int rows, int columns,
                        int margin, bool is_mirrored) {
  cv::Mat levels(rows, columns, CV_8U, cv::Scalar(invalid));
  const block::Kernel& kernel = block::kernel();
  const Statistics statistics = statisticsOf(image, kernel);
  const int cells = statistics.mean.cols;
  parallelRanges(0, image.rows, [&](int begin, int end) {
    std::vector<float> offset(std::size_t(cells) * kCell), scale(offset.size());
    std::vector<std::uint8_t> row(image.cols);
    int last_cell = -1;
    for (int y = begin; y < end; ++y) {
      if (y / kCell != last_cell) {
        last_cell = y / kCell;
        const float *m = statistics.mean.ptr<float>(last_cell), *s = statistics.scale.ptr<float>(last_cell);
        for (int i = 0; i < cells; ++i)
          for (int k = 0; k < kCell; ++k) {
            scale[kCell * i + k] = s[i];
            offset[kCell * i + k] = float(kNormalisedMiddle) + 0.5f - m[i] * s[i];
          }
      }
      kernel.levels(image.ptr<float>(y), mask.ptr<std::uint8_t>(y), scale.data(), offset.data(), image.cols,
                    kNormalisedHighest, invalid, row.data());
      std::uint8_t* out = levels.ptr<std::uint8_t>(y) + margin;
      if (is_mirrored)
        std::reverse_copy(row.begin(), row.end(), out);
      else
        std::copy(row.begin(), row.end(), out);
    }
  });
  return levels;
}

}  // namespace facenav::stereo
