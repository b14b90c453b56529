#include "facenav/stereo/calibrate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "board_pose.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "rig_adjustment.h"

namespace facenav::stereo {
namespace {

constexpr int kFewestViews = 5;
constexpr int kFolds = 5;
constexpr double kWorstByMedian = 2.5;       // a view this many times worse than the median view disagrees
constexpr double kNeverBad_px = 0.15;        // below this no view is called bad, however good the others are
constexpr double kGainOfFullerModel = 0.97;  // held-out error must fall by 3 % to take a fuller model
constexpr double kUsefulCoverage = 0.5;

struct Model {
  const char* name;
  int coefficients;
};
const Model kModels[] = {{"k1 k2 p1 p2", 4}, {"k1 k2 p1 p2 k3", 5}, {"rational (k1..k6 p1 p2)", 8}};

struct Task {
  const std::vector<BoardView>& views;
  cv::Size size;
  Board board;
};
using Indices = std::vector<std::size_t>;

RigFit solve(const Task& task, const Indices& used, const Model& model) {
  std::vector<const BoardView*> views;
  for (const std::size_t i : used) views.push_back(&task.views[i]);
  return adjustRig(views, task.size, task.board, model.coefficients);
}

std::vector<ViewFit> fitViews(const Task& task, const StereoRig& rig, const Indices& indices) {
  std::vector<ViewFit> fits;
  for (const std::size_t i : indices) fits.push_back(fitBoard(rig, task.views[i], task.board));
  return fits;
}

double rmsOf(const std::vector<ViewFit>& fits) {
  double squares = 0;
  for (const auto& fit : fits) squares += fit.rms_px() * fit.rms_px();
  return std::sqrt(squares / double(std::max<std::size_t>(1, fits.size())));
}

double medianRms(const std::vector<ViewFit>& fits) {
  std::vector<double> all;
  for (const auto& fit : fits) all.push_back(fit.rms_px());
  std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(all.size() / 2), all.end());
  return all[all.size() / 2];
}

// Drops the worst view and solves again until all agree. Never below kFewestViews: then what is left is all
// there is.
Indices agreeingViews(const Task& task, const Model& model) {
  Indices used(task.views.size());
  std::iota(used.begin(), used.end(), std::size_t{0});
  while (int(used.size()) > kFewestViews) {
    const auto fits = fitViews(task, solve(task, used, model).rig, used);
    const auto worst = std::max_element(fits.begin(), fits.end(),
                                        [](const auto& a, const auto& b) { return a.rms_px() < b.rms_px(); });
    if (worst->rms_px() < std::max(kNeverBad_px, kWorstByMedian * medianRms(fits))) break;
    used.erase(used.begin() + (worst - fits.begin()));
  }
  return used;
}

double heldOutRms(const Task& task, const Indices& used, const Model& model) {
  const std::size_t folds = std::min<std::size_t>(kFolds, used.size());
  std::vector<ViewFit> held_out;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    Indices kept, left_out;
    for (std::size_t i = 0; i < used.size(); ++i) (i % folds == fold ? left_out : kept).push_back(used[i]);
    for (const auto& fit : fitViews(task, solve(task, kept, model).rig, left_out)) held_out.push_back(fit);
  }
  return rmsOf(held_out);
}

// Share of a 4 x 4 grid over the image in which corners were seen.
double coverage(const Task& task, const Indices& used, const std::vector<cv::Point2f> BoardView::*side) {
  bool is_seen[16] = {};
  for (const std::size_t i : used)
    for (const auto& corner : task.views[i].*side) {
      const int x = std::clamp(int(4 * corner.x / float(task.size.width)), 0, 3);
      const int y = std::clamp(int(4 * corner.y / float(task.size.height)), 0, 3);
      is_seen[4 * y + x] = true;
    }
  return double(std::count(is_seen, is_seen + 16, true)) / 16;
}

std::vector<std::string> warningsFor(const Task& task, const Indices& used, const Calibration& result) {
  std::vector<std::string> warnings;
  const Eigen::Vector3d right_centre = result.rig.right_T_left.inverse().translation_mm();
  if (right_centre.x() < 0 && std::abs(right_centre.x()) > std::abs(right_centre.y()))
    warnings.push_back("the right camera stands left of the left one: are both lists swapped?");
  for (const auto& [name, side] :
       {std::pair("left", &BoardView::left), std::pair("right", &BoardView::right)})
    if (coverage(task, used, side) < kUsefulCoverage)
      warnings.push_back(std::string("the board covers less than half of the ") + name +
                         " image: distortion is a guess elsewhere, add views near the edges");
  if (used.size() < 8)
    warnings.push_back("only " + std::to_string(used.size()) + " views were used: 10 or more are better");
  if (result.held_out_rms_px > 2 * result.rms_px)
    warnings.push_back("views left out fit twice as badly as those used: add views at more angles");
  return warnings;
}

// Both shots of a view must name the corners in one order; boards whose colours do not tell it are turned
// here.
std::vector<BoardView> withOneOrder(std::vector<BoardView> views) {
  for (auto& view : views) {
    if (!view.left_ids.empty()) continue;
    const cv::Point2f left = view.left.back() - view.left.front(),
                      right = view.right.back() - view.right.front();
    if (left.dot(right) < 0) std::reverse(view.right.begin(), view.right.end());
  }
  return views;
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
  for (int i = 0; i < 3; ++i) add(std::string("R") + "xyz"[i] + " deg", turn[i], 180 / M_PI);
  for (int i = 0; i < 3; ++i) add(std::string("T") + "xyz"[i] + " mm", t[i]);
  return list;
}

std::vector<ViewReport> reportViews(const Task& task, const StereoRig& rig, const Indices& used) {
  std::vector<ViewReport> reports;
  for (std::size_t i = 0; i < task.views.size(); ++i) {
    const ViewFit fit = fitBoard(rig, task.views[i], task.board);
    ViewReport report{task.views[i].name, std::find(used.begin(), used.end(), i) != used.end(), "",
                      fit.left_rms_px, fit.right_rms_px};
    if (!report.is_used) report.reason = "disagrees with the other views";
    reports.push_back(report);
  }
  return reports;
}

}  // namespace

int Calibration::usedViews() const {
  return int(std::count_if(views.begin(), views.end(), [](const auto& view) { return view.is_used; }));
}

Calibration calibrateCorners(const std::vector<BoardView>& views, const cv::Size& size, const Board& board,
                             TaskMonitor& monitor) {
  if (int(views.size()) < kFewestViews)
    throw Error("the whole board was found in only " + std::to_string(views.size()) + " pairs, " +
                    std::to_string(kFewestViews) + " are needed",
                {}, "check --board (inner corners), light and focus, or take more pairs");
  const bool is_order_visible = (board.columns + board.rows) % 2 == 1;
  const std::vector<BoardView> ordered = is_order_visible ? views : withOneOrder(views);
  const Task task{ordered, size, board};
  try {
    monitor.report("calibrate", 0.0);
    const Indices used = agreeingViews(task, kModels[0]);
    Calibration result;
    const Model* chosen = nullptr;
    for (const Model& model : kModels) {
      monitor.report("cross-validate", double(&model - kModels) / double(std::size(kModels)));
      ModelReport report{model.name, rmsOf(fitViews(task, solve(task, used, model).rig, used)),
                         heldOutRms(task, used, model)};
      result.models.push_back(report);
      if (chosen && !(report.held_out_rms_px < kGainOfFullerModel * result.held_out_rms_px)) continue;
      chosen = &model;
      result.held_out_rms_px = report.held_out_rms_px;
    }
    result.model = chosen->name;
    const RigFit fit = solve(task, used, *chosen);
    result.rig = fit.rig;
    result.focal_sigma_px = fit.focal_sigma_px;
    result.baseline_sigma_mm = fit.baseline_sigma_mm;
    result.rms_px = rmsOf(fitViews(task, result.rig, used));
    result.rig.rms_px = result.rms_px;
    result.parameters = parameterErrors(result.rig);
    result.views = reportViews(task, result.rig, used);
    result.warnings = warningsFor(task, used, result);
    return result;
  } catch (const cv::Exception& exception) {
    throw Error("the views do not determine the cameras (" + exception.err + ")", {},
                "take pairs of the board at different angles and distances");
  }
}

namespace {

/// A chessboard's corners come without numbers, so that boards of one colour order can be turned.
std::pair<std::vector<cv::Point2f>, std::vector<int>> found(const cv::Mat& image, const Board& board) {
  SeenCorners seen = findBoard(image, board);
  if (!board.isCharuco()) seen.ids.clear();
  return {seen.px, seen.ids};
}

}  // namespace

Calibration calibrate(const std::vector<CalibrationPair>& pairs, const Board& board, TaskMonitor& monitor) {
  if (pairs.empty()) throw Error("there are no image pairs to calibrate from");
  const cv::Size size = pairs.front().left.size();
  std::vector<BoardView> views;
  std::vector<ViewReport> without_board;
  std::vector<std::size_t> place;  // of each view among the pairs
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const CalibrationPair& pair = pairs[i];
    monitor.report("find boards", double(i) / double(pairs.size()));
    for (const cv::Mat& image : {pair.left, pair.right})
      if (image.size() != size)
        throw Error("image sizes differ: " + std::to_string(image.cols) + " x " + std::to_string(image.rows) +
                        " beside " + std::to_string(size.width) + " x " + std::to_string(size.height),
                    pair.name, "use images of one camera pair at one resolution");
    BoardView view{pair.name, {}, {}, {}, {}};
    std::tie(view.left, view.left_ids) = found(pair.left, board);
    if (!view.left.empty()) std::tie(view.right, view.right_ids) = found(pair.right, board);
    const bool is_found = !view.left.empty() && !view.right.empty();
    if (is_found) {
      place.push_back(i);
      views.push_back(std::move(view));
    } else {
      const std::string side = view.left.empty() ? "left" : "right";
      without_board.push_back({pair.name, false, "board not found in the " + side + " image", 0, 0});
      place.push_back(i);
    }
  }
  Calibration result = calibrateCorners(views, size, board, monitor);
  // Back into the order given.
  std::vector<ViewReport> in_order;
  std::size_t next = 0, missing = 0;
  for (const CalibrationPair& pair : pairs) {
    const bool is_missing = missing < without_board.size() && without_board[missing].name == pair.name;
    in_order.push_back(is_missing ? without_board[missing++] : result.views[next++]);
  }
  result.views = std::move(in_order);
  return result;
}

}  // namespace facenav::stereo
