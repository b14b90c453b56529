#include "facenav/stereo/calibrate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <tuple>

#include "board_pose.h"
#include "exposure_check.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "rig_adjustment.h"
#include "rig_effect.h"

namespace facenav::stereo {
namespace {

constexpr int kFewestViews = 5;
constexpr int kFolds = 5;
constexpr double kGainOfFullerModel = 0.97;  // held-out error must fall by 3 % to take a fuller model
constexpr double kUsefulCoverage = 0.5;
constexpr double kUsefulTilt_deg = 10.0;  // below it errors grow steeply (Zhang 2000, section 5.1)
// Where half the views moved, those that pass the test moved as well, by a little less.
constexpr double kLeastSimultaneous = 0.5;
constexpr double kNotedShare = 0.1;  // of moved views: more than a slip of the hand
// Both cameras together against each alone. Lens models leave some 0.05 px more together.
constexpr double kNotedByAlone = 1.6, kNotedDisagreement_px = 0.15;

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
using Indices = ViewIndices;

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

std::string text(const char* format, double a, double b = 0, double c = 0) {
  char line[400];
  std::snprintf(line, sizeof line, format, a, b, c);
  return line;
}

std::vector<Eigen::Isometry3d> boardPoses(const Task& task, const StereoRig& rig, const Indices& used) {
  std::vector<Eigen::Isometry3d> poses;
  for (const ViewFit& fit : fitViews(task, rig, used)) poses.push_back(fit.camera_T_board);
  return poses;
}

// How far the board's normal strays from its mean, rms.
double tilt_deg(const std::vector<Eigen::Isometry3d>& poses) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& pose : poses) mean += pose.linear().col(2);
  mean.normalize();
  double squares = 0;
  for (const auto& pose : poses)
    squares += std::pow(std::acos(std::clamp(mean.dot(pose.linear().col(2)), -1.0, 1.0)), 2);
  return std::sqrt(squares / double(poses.size())) * 180 / M_PI;
}

double farthestMoved_mm(const Task& task, const StereoRig& rig, const Indices& moved) {
  double farthest_mm = 0;
  for (const std::size_t i : moved)
    farthest_mm = std::max(farthest_mm, movedBetween_mm(rig, task.views[i], task.board));
  return farthest_mm;
}

std::string notTogether(const Task& task, const StereoRig& rig, const Indices& moved) {
  return text("the board moved between the two exposures in %.0f of %.0f views, by up to %.1f mm",
              double(moved.size()), double(task.views.size()), farthestMoved_mm(task, rig, moved));
}

// Too few views are left once those are gone in which the board moved: no rig, and the right reason.
void requireSimultaneous(const Task& task, const TrustedViews& trusted, const Model& model) {
  const std::size_t good = trusted.used.size() + trusted.moved.size();
  const std::size_t needed =
      std::max(std::size_t(kFewestViews), std::size_t(std::ceil(kLeastSimultaneous * double(good))));
  if (trusted.moved.empty() || trusted.used.size() >= needed) return;
  Indices enough = trusted.used;
  for (const std::size_t i : trusted.moved)
    if (enough.size() < std::size_t(kFewestViews)) enough.push_back(i);
  throw Error(notTogether(task, solve(task, enough, model).rig, trusted.moved) + ": " +
                  std::to_string(trusted.used.size()) + " are left, " + std::to_string(needed) +
                  " are needed",
              {},
              "trigger both cameras together (one may lag) or hold the board still for each pair; check that "
              "both lists name the pairs in one order and that the cameras are fixed");
}

std::vector<std::string> simultaneityWarnings(const Task& task, const TrustedViews& trusted,
                                              const Calibration& result) {
  if (trusted.moved.size() >= 2 && double(trusted.moved.size()) > kNotedShare * double(task.views.size()))
    return {notTogether(task, result.rig, trusted.moved) +
            ": the cameras are not triggered together, or one lags. Trigger both, or hold the board still"};
  if (result.rms_px > std::max(kNotedByAlone * trusted.alone_px, kNotedDisagreement_px))
    return {text(
        "both cameras together fit the views to %.2f px, each alone to %.2f px: the board may have moved "
        "between the two exposures, or a camera between the views. Trigger both cameras together, or "
        "hold the board still",
        result.rms_px, trusted.alone_px)};
  return {};
}

std::vector<std::string> warningsFor(const Task& task, const TrustedViews& trusted,
                                     const std::vector<Eigen::Isometry3d>& poses, const Calibration& result) {
  const Indices& used = trusted.used;
  std::vector<std::string> warnings = simultaneityWarnings(task, trusted, result);
  const bool is_simultaneous = warnings.empty();
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
  const double tilt = tilt_deg(poses);
  if (tilt < kUsefulTilt_deg)
    warnings.push_back(text("the board was turned by only %.0f deg: add views at more angles", tilt));
  else if (is_simultaneous && result.held_out_rms_px > 2 * result.rms_px)
    warnings.push_back("views left out fit twice as badly as those used: add views");
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

std::string reasonFor(const Task& task, const TrustedViews& trusted, const StereoRig& rig, std::size_t i) {
  const auto isIn = [i](const Indices& list) { return std::find(list.begin(), list.end(), i) != list.end(); };
  const bool is_left = isIn(trusted.bad_left), is_right = isIn(trusted.bad_right);
  if (is_left || is_right)
    return std::string("corners of the ") +
           (is_left && is_right ? "left and right"
            : is_left           ? "left"
                                : "right") +
           " image are off: blur, or a wrong corner";
  return text(
      "disagrees with the other views: the exposures were not simultaneous, the board moved %.1f mm "
      "between them",
      movedBetween_mm(rig, task.views[i], task.board));
}

std::vector<ViewReport> reportViews(const Task& task, const StereoRig& rig, const TrustedViews& trusted) {
  const Indices& used = trusted.used;
  std::vector<ViewReport> reports;
  for (std::size_t i = 0; i < task.views.size(); ++i) {
    const ViewFit fit = fitBoard(rig, task.views[i], task.board);
    ViewReport report{task.views[i].name, std::find(used.begin(), used.end(), i) != used.end(), "",
                      fit.left_rms_px, fit.right_rms_px};
    if (!report.is_used) report.reason = reasonFor(task, trusted, rig, i);
    reports.push_back(report);
  }
  return reports;
}

// The boards' mean place is where the head will be.
HeadEffect effectOf(const Task& task, const StereoRig& rig, const std::vector<Eigen::Isometry3d>& poses) {
  const Eigen::Vector3d middle(0.5 * (task.board.columns - 1) * task.board.square_mm,
                               0.5 * (task.board.rows - 1) * task.board.square_mm, 0);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& pose : poses) sum += pose * middle;
  return effectAtHead(rig, sum / double(poses.size()));
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
    const TrustedViews trusted = trustedViews(ordered, size, board, kFewestViews, [&](const Indices& some) {
      return solve(task, some, kModels[0]).rig;
    });
    requireSimultaneous(task, trusted, kModels[0]);
    const Indices& used = trusted.used;
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
    result.views = reportViews(task, result.rig, trusted);
    const auto poses = boardPoses(task, result.rig, used);
    result.at_head = effectOf(task, result.rig, poses);
    result.warnings = warningsFor(task, trusted, poses, result);
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
