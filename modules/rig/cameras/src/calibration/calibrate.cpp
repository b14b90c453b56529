#include "facenav/cameras/calibrate.h"

#include <algorithm>
#include <opencv2/core/utility.hpp>

#include "calibration_report.h"
#include "exposure_words.h"
#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "lens_choice.h"

namespace facenav::cameras {
namespace {

constexpr std::size_t kFewestViews = 5;
constexpr double kApartSigmas = 5;  // of the baseline, in its standard errors

// Turns boards so that both images of a view have their corners in one order; needed where the board's
// colours do not define it.
std::vector<BoardView> withOneOrder(std::vector<BoardView> views) {
  for (auto& view : views) {
    if (!view.left_ids.empty()) continue;
    const cv::Point2f left = view.left.back() - view.left.front(),
                      right = view.right.back() - view.right.front();
    if (left.dot(right) < 0) std::reverse(view.right.begin(), view.right.end());
  }
  return views;
}

void requireViews(std::size_t found, std::size_t pairs) {
  if (found >= kFewestViews) return;
  const std::string needed = std::to_string(kFewestViews) + " are needed";
  if (found == 0 && pairs > 0)
    throw Error(
        "the whole board was found in none of the " + std::to_string(pairs) + " pairs, " + needed, {},
        "check the board's size first: it counts inner corners, one less than squares; then light and "
        "focus");
  throw Error("the whole board was found in only " + std::to_string(found) + " of " + std::to_string(pairs) +
                  " pairs, " + needed,
              {}, "take more pairs with the whole board in both pictures, sharp and well lit");
}

/// Throws Error if both cameras stand in one place: both lists hold pictures of the same camera.
void requireTwoPlaces(const Calibration& result) {
  if (result.rig.baseline_mm() > kApartSigmas * result.baseline_sigma_mm) return;
  throw Error("the two cameras stand in one place: left and right are pictures of the same camera", {},
              "give the pictures of two cameras");
}

Calibration calibrated(const BoardViews& task, TaskMonitor& monitor) {
  monitor.report("calibrate", 0.0);
  const TrustedViews trusted =
      trustedViews(task.views, task.size, task.board, kFewestViews,
                   [&](const ViewIndices& some) { return solve(task, some, usualLens()).rig; });
  requireSimultaneous(task, trusted);
  const LensChoice lens = chooseLens(task, trusted.used, monitor);
  const RigFit fit = solve(task, trusted.used, lens.taken);
  Calibration result;
  result.models = lens.tried;
  result.model = lens.taken.name;
  result.held_out_rms_px = lens.held_out_rms_px;
  result.rig = fit.rig;
  result.focal_sigma_px = fit.focal_sigma_px;
  result.baseline_sigma_mm = fit.baseline_sigma_mm;
  requireTwoPlaces(result);
  result.rms_px = rmsOf(fitViews(task, result.rig, trusted.used));
  result.rig.rms_px = result.rms_px;
  report(task, trusted, result);
  return result;
}

void requireOneSize(const std::vector<CalibrationPair>& pairs) {
  if (pairs.empty()) throw Error("there are no image pairs to calibrate from");
  const cv::Size size = pairs.front().left.size();
  for (const CalibrationPair& pair : pairs)
    for (const cv::Mat& image : {pair.left, pair.right})
      if (image.size() != size)
        throw Error("image sizes differ: " + std::to_string(image.cols) + " x " + std::to_string(image.rows) +
                        " beside " + std::to_string(size.width) + " x " + std::to_string(size.height),
                    pair.name, "use images of one camera pair at one resolution");
}

BoardView foundIn(const CalibrationPair& pair, const Board& board) {
  SeenCorners left = findBoard(pair.left, board);
  SeenCorners right = left.px.empty() ? SeenCorners() : findBoard(pair.right, board);
  // A chessboard's corners have no numbers here, so that withOneOrder() can turn them.
  if (!board.isCharuco()) left.ids.clear(), right.ids.clear();
  return {pair.name, left.px, right.px, left.ids, right.ids};
}

bool isFound(const BoardView& view) { return !view.left.empty() && !view.right.empty(); }

// Finds the boards of a few pairs at a time on all cores, so that the caller's thread can report progress and
// see a cancel.
std::vector<BoardView> findBoards(const std::vector<CalibrationPair>& pairs, const Board& board,
                                  TaskMonitor& monitor) {
  constexpr int kAtATime = 8;
  std::vector<BoardView> views(pairs.size());
  for (int first = 0; first < int(pairs.size()); first += kAtATime) {
    monitor.report("find boards", double(first) / double(pairs.size()));
    parallelRanges(first, std::min(first + kAtATime, int(pairs.size())), [&](int begin, int end) {
      for (int i = begin; i < end; ++i) views[std::size_t(i)] = foundIn(pairs[std::size_t(i)], board);
    });
  }
  return views;
}

// Adds reports of pairs without a board, so that all pairs appear in the order given.
std::vector<ViewReport> withMissing(const std::vector<BoardView>& all, const std::vector<ViewReport>& found) {
  std::vector<ViewReport> reports;
  std::size_t next = 0;
  for (const BoardView& view : all) {
    const std::string side = view.left.empty() ? "left" : "right";
    if (isFound(view))
      reports.push_back(found[next++]);
    else
      reports.push_back(
          {view.name, false, "board not found in the " + side + " image", std::nullopt, std::nullopt});
  }
  return reports;
}

}  // namespace

int Calibration::usedViews() const {
  return int(std::count_if(views.begin(), views.end(), [](const auto& view) { return view.is_used; }));
}

Calibration calibrateCorners(const std::vector<BoardView>& views, const cv::Size& size, const Board& board,
                             TaskMonitor& monitor) {
  requireViews(views.size(), views.size());
  const bool is_order_visible = (board.columns + board.rows) % 2 == 1;
  const std::vector<BoardView> ordered = is_order_visible ? views : withOneOrder(views);
  try {
    return calibrated({ordered, size, board}, monitor);
  } catch (const cv::Exception& exception) {
    throw Error("the views do not determine the cameras (" + exception.err + ")", {},
                "take pairs of the board at different angles and distances");
  }
}

Calibration calibrate(const std::vector<CalibrationPair>& pairs, const Board& board, TaskMonitor& monitor) {
  requireOneSize(pairs);
  const std::vector<BoardView> all = findBoards(pairs, board, monitor);
  std::vector<BoardView> views;
  std::copy_if(all.begin(), all.end(), std::back_inserter(views), isFound);
  requireViews(views.size(), all.size());
  Calibration result = calibrateCorners(views, pairs.front().left.size(), board, monitor);
  result.views = withMissing(all, result.views);
  return result;
}

}  // namespace facenav::cameras
