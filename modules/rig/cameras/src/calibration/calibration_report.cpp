#include "calibration_report.h"

#include <algorithm>
#include <cmath>

#include "exposure_words.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"

namespace facenav::cameras {
namespace {

constexpr double kUsefulCoverage = 0.5;
constexpr double kUsefulTilt_deg = 10.0;  // below it errors grow steeply (Zhang 2000, section 5.1)
constexpr std::size_t kEnoughViews = 8;

// Fraction of the cells of a 4 x 4 grid over the image in which corners were seen.
double coverage(const BoardViews& task, const ViewIndices& used,
                const std::vector<cv::Point2f> BoardView::*side) {
  bool is_seen[16] = {};
  for (const std::size_t i : used)
    for (const auto& corner : task.views[i].*side) {
      const int x = std::clamp(int(4 * corner.x / float(task.size.width)), 0, 3);
      const int y = std::clamp(int(4 * corner.y / float(task.size.height)), 0, 3);
      is_seen[4 * y + x] = true;
    }
  return double(std::count(is_seen, is_seen + 16, true)) / 16;
}

// Rms angle between the board's normals and their mean.
double tilt_deg(const std::vector<ViewFit>& fits) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& fit : fits) mean += fit.camera_T_board.linear().col(2);
  mean.normalize();
  double squares = 0;
  for (const auto& fit : fits)
    squares += std::pow(std::acos(std::clamp(mean.dot(fit.camera_T_board.linear().col(2)), -1.0, 1.0)), 2);
  return std::sqrt(squares / double(fits.size())) * kDegPerRad;
}

std::vector<std::string> warningsFor(const BoardViews& task, const TrustedViews& trusted,
                                     const std::vector<ViewFit>& fits, const Calibration& result) {
  std::vector<std::string> warnings = simultaneityWarnings(task, trusted, result);
  const bool is_simultaneous = warnings.empty();
  const Eigen::Vector3d right_centre = result.rig.right_T_left.inverse().translation_mm();
  if (right_centre.x() < 0 && std::abs(right_centre.x()) > std::abs(right_centre.y()))
    warnings.push_back(
        "the right camera stands left of the left one: if the lists are swapped, exchange left and right");
  for (const auto& [name, side] :
       {std::pair("left", &BoardView::left), std::pair("right", &BoardView::right)})
    if (coverage(task, trusted.used, side) < kUsefulCoverage)
      warnings.push_back(std::string("the board covers less than half of the ") + name +
                         " image: distortion is a guess elsewhere, add views near the edges");
  if (trusted.used.size() < kEnoughViews)
    warnings.push_back("only " + std::to_string(trusted.used.size()) +
                       " views were used: 10 or more are better");
  const double tilt = tilt_deg(fits);
  if (tilt < kUsefulTilt_deg)
    warnings.push_back(formatted("the board was turned by only %.0f deg: add views at more angles", tilt));
  else if (is_simultaneous && result.held_out_rms_px > 2 * result.rms_px)
    warnings.push_back("views left out fit twice as badly as those used: add views");
  return warnings;
}

std::vector<ParameterError> parameterErrors(const StereoRig& rig) {
  static const char* const kCoefficients[] = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  std::vector<ParameterError> list;
  int at = 0;
  const auto add = [&](const std::string& name, double value, double unit = 1.0) {
    list.push_back({name, value * unit, std::sqrt(std::max(0.0, rig.covariance.at<double>(at, at))) * unit});
    ++at;
  };
  for (const auto& [side, camera] : {std::pair("left ", &rig.left), std::pair("right ", &rig.right)}) {
    add(std::string(side) + "fx px", camera->k(0, 0));
    add(std::string(side) + "fy px", camera->k(1, 1));
    add(std::string(side) + "cx px", camera->k(0, 2));
    add(std::string(side) + "cy px", camera->k(1, 2));
    for (int i = 0; i < int(camera->distortion.total()); ++i)
      add(side + std::string(kCoefficients[i]), camera->distortion.at<double>(i));
  }
  const Eigen::Vector3d turn = logRotation(rig.right_T_left.rotation());
  const Eigen::Vector3d t = rig.right_T_left.translation_mm();
  for (int i = 0; i < 3; ++i) add(std::string("R") + "xyz"[i] + " deg", turn[i], kDegPerRad);
  for (int i = 0; i < 3; ++i) add(std::string("T") + "xyz"[i] + " mm", t[i]);
  return list;
}

std::vector<ViewReport> reportViews(const BoardViews& task, const StereoRig& rig,
                                    const TrustedViews& trusted) {
  std::vector<ViewReport> reports;
  for (std::size_t i = 0; i < task.views.size(); ++i) {
    const ViewFit fit = fitBoard(rig, task.views[i], task.board);
    const bool is_used = std::find(trusted.used.begin(), trusted.used.end(), i) != trusted.used.end();
    reports.push_back({task.views[i].name, is_used, is_used ? "" : reasonFor(task, trusted, rig, i),
                       fit.left_rms_px, fit.right_rms_px});
  }
  return reports;
}

// The head is expected at the mean position of the boards.
HeadEffect effectOf(const BoardViews& task, const StereoRig& rig, const std::vector<ViewFit>& fits) {
  const Eigen::Vector3d middle(0.5 * (task.board.columns - 1) * task.board.square_mm,
                               0.5 * (task.board.rows - 1) * task.board.square_mm, 0);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& fit : fits) sum += fit.camera_T_board * middle;
  return effectAtHead(rig, sum / double(fits.size()));
}

}  // namespace

void report(const BoardViews& task, const TrustedViews& trusted, Calibration& result) {
  const std::vector<ViewFit> fits = fitViews(task, result.rig, trusted.used);
  result.parameters = parameterErrors(result.rig);
  result.views = reportViews(task, result.rig, trusted);
  result.at_head = effectOf(task, result.rig, fits);
  result.warnings = warningsFor(task, trusted, fits, result);
}

}  // namespace facenav::cameras
