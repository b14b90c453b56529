#include "camera_doubts.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/core/robust_statistics.h"
#include "facenav/monitoring/pair_fault.h"
#include "facenav/monitoring/rig_check.h"

namespace facenav::workflow {
namespace {

constexpr double kClearStatistic = 40;  // as in RigCheck: twice the monitor's own threshold
constexpr int kFineScale_px = 9;
constexpr double kDotsContrast = 1.5;  // ratio of fine detail with dots to that without; without dots it is 1

// Dense dots lie 4 to 8 px apart in 640 px, the paper's ten times as far: hardly a tile with such a dot has a
// neighbour with one.
constexpr int kTilesAcross = 40, kFewestDots = 12;
constexpr double kDense = 0.4, kDark_grey = 8.0, kDotOverSkin = 0.25;

/// One value a tile: 1 where a point is clearly brighter than the tile's middle.
cv::Mat brightPoints(const cv::Mat& image, int tile_px) {
  cv::Mat found = cv::Mat::zeros(image.rows / tile_px, image.cols / tile_px, CV_8U);
  std::vector<double> grey;
  for (int row = 0; row < found.rows; ++row)
    for (int column = 0; column < found.cols; ++column) {
      grey.clear();
      for (int y = row * tile_px; y < (row + 1) * tile_px; ++y)
        grey.insert(grey.end(), image.ptr(y) + column * tile_px, image.ptr(y) + (column + 1) * tile_px);
      const double most = *std::max_element(grey.begin(), grey.end()), middle = upperMedian(grey);
      found.at<unsigned char>(row, column) = middle > kDark_grey && most > (1.0 + kDotOverSkin) * middle;
    }
  return found;
}

/// Fine detail relative to the mean grey level.
double fineContrast(const cv::Mat& image) {
  cv::Mat grey, smooth;
  image.convertTo(grey, CV_32F);
  cv::boxFilter(grey, smooth, -1, {kFineScale_px, kFineScale_px});
  return cv::norm(grey - smooth, cv::NORM_L2) / std::max(1.0, cv::norm(grey, cv::NORM_L2));
}

/// The calibration is no longer valid: searching elsewhere for the face would not help.
class CamerasMoved : public Error {
 public:
  using Error::Error;
};

}  // namespace

bool showsDots(const capture::CapturePair& capture) {
  return fineContrast(capture.pattern.left) > kDotsContrast * fineContrast(capture.plain.left);
}

bool areDotsSparse(const capture::CapturePair& capture) {
  const int tile_px = std::max(8, capture.pattern.left.cols / kTilesAcross);
  if (capture.pattern.left.type() != CV_8U || capture.plain.left.size() != capture.pattern.left.size())
    return false;
  const cv::Mat dots = brightPoints(capture.pattern.left, tile_px),
                own = brightPoints(capture.plain.left,
                                   tile_px);  // what the face shows without dots says nothing
  int single = 0, beside = 0;
  for (int row = 0; row < dots.rows; ++row)
    for (int column = 0; column + 1 < dots.cols; ++column) {
      if (own.at<unsigned char>(row, column) || own.at<unsigned char>(row, column + 1)) continue;
      const int both = dots.at<unsigned char>(row, column) + dots.at<unsigned char>(row, column + 1);
      single += both == 1, beside += both == 2;
    }
  return single + beside > kFewestDots && beside < kDense * (single + beside);
}

std::optional<Error> errorOf(const std::function<void()>& task) {
  try {
    task();
    return std::nullopt;
  } catch (const CamerasMoved&) {
    throw;
  } catch (const monitoring::PairError&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return error;
  }
}

void requireUnmovedCameras(const cameras::StereoRig& rig, const cameras::StereoFrame& measured,
                           const cameras::StereoFrame& plain, const stereo::FaceCloud& face) {
  cameras::RigMonitor monitor(rig);
  monitor.add(monitoring::matchSurface(rig, measured, face.cloud, face.left_px));
  const auto verdict = monitor.verdict();
  if (!verdict.hasMoved()) return;
  const auto diagnosis = cameras::diagnosePair(rig, plain);
  if (diagnosis.isFault()) throw monitoring::PairError(diagnosis, "not aligned: ");
  // If plain skin disagrees a little but the whole plain pair fits, the cameras did not move.
  const bool is_clear = verdict.statistic > kClearStatistic && showsDots({measured, plain});
  if (diagnosis.fault != cameras::PairFault::none || is_clear)
    throw CamerasMoved("not aligned: " + verdict.words(), {}, "'facenav calibrate'");
}

[[noreturn]] void refuseAlignment(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  AlignedFrom from, const Error& error, bool is_measured,
                                  const std::string& matcher) {
  const auto diagnosis = cameras::diagnosePair(rig, capture.plain);
  if (diagnosis.isFault()) throw monitoring::PairError(diagnosis, "not aligned: ");
  if (from != AlignedFrom::dots || showsDots(capture)) {
    if (is_measured) throw error;
    throw NotMeasured(error.what());
  }
  std::string reason = error.what();
  const std::string prefix = "not aligned: ";
  if (reason.rfind(prefix, 0) == 0) reason.erase(0, prefix.size());
  const bool is_default = matcher == stereo::kDefaultMatcher;
  throw Error(prefix + "the capture's picture for the dots shows none, or too few (switch the projector on" +
              (is_default ? "" : ": the matcher '" + matcher + "' needs them") +
              "); without them: " + reason);
}

}  // namespace facenav::workflow
