#include "facenav/setup/board_collector.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"

namespace facenav::steps {
namespace {

constexpr double kAssumedFocal = 1.2;  // share of the picture's width; accurate enough for tilts
constexpr int kCells = 3;
constexpr int kFewestHeld = 3;
constexpr double kDark_grey = 40;     // mean of a picture too dark to find a board
constexpr double kTremble = 6.0;      // times the motion of a board at rest
constexpr double kTilt = 0.2;         // sine of the smallest significant tilt
constexpr double kSpread = 1.25;      // smallest ratio of nearest to farthest board
constexpr int kCellsThatMayMiss = 4;  // of 18: a board may not reach every corner in both pictures

const char* const kCellNames[] = {"upper left", "top",        "upper right", "left edge",  "middle",
                                  "right edge", "lower left", "bottom",      "lower right"};

std::vector<bool> cellsOf(const std::vector<cameras::BoardView>& views, bool is_left, const cv::Size& size) {
  std::vector<bool> cells(kCells * kCells, false);
  for (const auto& view : views)
    for (const auto& corner : is_left ? view.left : view.right) {
      const int x = std::clamp(int(corner.x * kCells / float(size.width)), 0, kCells - 1),
                y = std::clamp(int(corner.y * kCells / float(size.height)), 0, kCells - 1);
      cells[std::size_t(y * kCells + x)] = true;
    }
  return cells;
}

/// Largest motion of a corner present in both, px; large if they share too few.
double motion_px(const cameras::SeenCorners& a, const cameras::SeenCorners& b) {
  std::map<int, cv::Point2f> places;
  for (std::size_t i = 0; i < a.px.size(); ++i) places[a.ids[i]] = a.px[i];
  double most = 0;
  std::size_t shared = 0;
  for (std::size_t i = 0; i < b.px.size(); ++i)
    if (const auto at = places.find(b.ids[i]); at != places.end()) {
      most = std::max(most, cv::norm(at->second - b.px[i]));
      ++shared;
    }
  return 2 * shared < b.px.size() ? 1e9 : most;
}

std::string refusedWords(bool is_left, const std::string& fault) {
  return std::string(is_left ? "left" : "right") + " picture: " + fault;
}

}  // namespace

int BoardCoverage::cellsMissing() const {
  return int(std::count(left_cells.begin(), left_cells.end(), false) +
             std::count(right_cells.begin(), right_cells.end(), false));
}

int BoardCoverage::tiltsMissing() const {
  return int(!is_left_far) + int(!is_right_far) + int(!is_top_far) + int(!is_bottom_far);
}

BoardCollector::BoardCollector(const cameras::Board& board, const cv::Size& picture, const BoardRules& rules)
    : board_(board), picture_(picture), rules_(rules) {}

BoardCollector::BoardCollector(const cameras::Board& board, const cv::Size& picture)
    : BoardCollector(board, picture, settingsOf<BoardRules>()) {}

void BoardCollector::clear() {
  views_.clear();
  shapes_.clear();
  held_.clear();
  refusals_.clear();
}

BoardSight BoardCollector::seen(const cv::Mat& left, const cv::Mat& right, bool is_live) const {
  if (left.size() != picture_ || right.size() != picture_)
    throw Error(formatted("the pictures are %d x %d px in place of %d x %d", left.cols, left.rows,
                          picture_.width, picture_.height),
                "", "use pictures of one camera pair at one resolution");
  BoardSight sight;
  const auto find = is_live ? cameras::findBoardAtOnce : cameras::findBoard;
  sight.left = find(left, board_);
  sight.right = find(right, board_);
  const bool is_left = !sight.left.px.empty(), is_right = !sight.right.px.empty();
  if (!is_left && !is_right) {
    sight.state = BoardSight::State::none;
    sight.reason = cv::mean(left)[0] < kDark_grey || cv::mean(right)[0] < kDark_grey
                       ? "no board is seen: the picture is dark, more light"
                       : "no board is seen";
  } else if (is_left != is_right) {
    sight.state = BoardSight::State::one_side;
    sight.reason = is_left ? "the right camera does not see the whole board"
                           : "the left camera does not see the whole board";
  } else {
    sight.state = BoardSight::State::moving;
  }
  return sight;
}

std::string BoardCollector::fault(const cv::Mat& image, const cameras::SeenCorners& corners) const {
  const auto quality = cameras::boardQuality(image, corners, board_);
  if (quality.white_grey - quality.black_grey < rules_.least_contrast)
    return "the board is too dark: more light, or a longer exposure";
  if (quality.white_grey > rules_.most_white)
    return "the board is too bright: turn it from the lamp, or dim the tablet";
  if (quality.edge_px > rules_.most_edge_px && quality.edge_px > rules_.most_edge_share * quality.square_px)
    return "the board is blurred: hold it still, or set the focus";
  return {};
}

BoardCollector::Shape BoardCollector::shapeOf(const cameras::SeenCorners& corners) const {
  const double focal_px = kAssumedFocal * picture_.width;
  const cv::Matx33d k(focal_px, 0, 0.5 * picture_.width, 0, focal_px, 0.5 * picture_.height, 0, 0, 1);
  Shape shape;
  cv::Point2f sum;
  for (const auto& corner : corners.px) sum += corner;
  shape.middle = {sum.x / double(corners.px.size()) / picture_.width,
                  sum.y / double(corners.px.size()) / picture_.height};
  cv::Vec3d turn, shift;
  if (!cv::solvePnP(cameras::boardPoints(board_, corners.ids), corners.px, k, cv::noArray(), turn, shift))
    return shape;
  shape.size = focal_px * board_.square_mm * board_.columns / (shift[2] * picture_.width);
  cv::Matx33d rotation;
  cv::Rodrigues(turn, rotation);
  // Turns the normal towards the camera: a board is read in any orientation, and its normal must not flip.
  const double sign = rotation(2, 2) > 0 ? -1.0 : 1.0;
  shape.normal = {sign * rotation(0, 2), sign * rotation(1, 2)};
  return shape;
}

bool BoardCollector::isNew(const Shape& shape) const {
  return std::none_of(shapes_.begin(), shapes_.end(), [&](const Shape& old) {
    return cv::norm(shape.middle - old.middle) < rules_.new_place &&
           std::abs(std::log(shape.size / old.size)) < rules_.new_size &&
           cv::norm(shape.normal - old.normal) < rules_.new_tilt;
  });
}

/// True if the board is still. The newest sight is the last of held_.
bool BoardCollector::isStill(double now_s) {
  const Held& newest = held_.back();
  for (std::size_t i = held_.size(); i-- > 0;)
    if (std::max(motion_px(held_[i].left, newest.left), motion_px(held_[i].right, newest.right)) >
        rules_.still_share * picture_.width) {
      held_.erase(held_.begin(), held_.begin() + std::ptrdiff_t(i) + 1);
      break;
    }
  while (int(held_.size()) > kFewestHeld && now_s - held_[1].t_s >= rules_.still_s)
    held_.erase(held_.begin());
  return int(held_.size()) >= kFewestHeld && now_s - held_.front().t_s >= rules_.still_s;
}

bool BoardCollector::isNearlyStill() const {
  if (last_left_.px.empty()) return false;
  return motion_px(last_left_, held_.back().left) < kTremble * rules_.still_share * picture_.width;
}

void BoardCollector::judge(const cv::Mat& left, const cv::Mat& right, const std::string& name, bool is_live,
                           BoardSight& sight) {
  const std::string left_fault = fault(left, sight.left), right_fault = fault(right, sight.right);
  if (!left_fault.empty() || !right_fault.empty()) {
    sight.state = BoardSight::State::refused;
    sight.reason = left_fault.empty() ? refusedWords(false, right_fault) : refusedWords(true, left_fault);
    return;
  }
  const Shape shape = shapeOf(sight.left);
  // Accepts every view taken on request until there are enough, because no others will come.
  if (!isNew(shape) && (is_live || int(views_.size()) >= rules_.wanted_views)) {
    sight.state = BoardSight::State::known;
    sight.reason = "this view is there already: " + wish();
    return;
  }
  shapes_.push_back(shape);
  cameras::BoardView view{name, sight.left.px, sight.right.px, sight.left.ids, sight.right.ids};
  if (!board_.isCharuco()) view.left_ids.clear(), view.right_ids.clear();
  views_.push_back(std::move(view));
  sight.state = BoardSight::State::taken;
}

BoardSight BoardCollector::counted(BoardSight sight) {
  if (sight.state == BoardSight::State::refused || sight.state == BoardSight::State::one_side)
    ++refusals_[sight.reason];
  return sight;
}

BoardSight BoardCollector::add(const cameras::StereoFrame& frame) {
  BoardSight sight = seen(frame.left, frame.right, true);
  if (sight.state != BoardSight::State::moving) {
    held_.clear();
    return counted(std::move(sight));
  }
  last_left_ = held_.empty() ? cameras::SeenCorners() : held_.back().left;
  held_.push_back({frame.captured.s, sight.left, sight.right});
  if (!isStill(frame.captured.s)) {
    sight.reason = "hold the board still";
    // A blurred board at rest seems to tremble.
    if (const auto blurred = isNearlyStill() ? fault(frame.left, sight.left) : std::string();
        !blurred.empty()) {
      sight.state = BoardSight::State::refused;
      sight.reason = refusedWords(true, blurred);
    }
    return counted(std::move(sight));
  }
  judge(frame.left, frame.right, "view " + std::to_string(views_.size() + 1), true, sight);
  return counted(std::move(sight));
}

BoardSight BoardCollector::addStill(const cameras::CalibrationPair& pair) {
  BoardSight sight = seen(pair.left, pair.right, false);
  if (sight.state == BoardSight::State::moving) judge(pair.left, pair.right, pair.name, false, sight);
  return counted(std::move(sight));
}

BoardCoverage BoardCollector::coverage() const {
  BoardCoverage all;
  all.left_cells = cellsOf(views_, true, picture_);
  all.right_cells = cellsOf(views_, false, picture_);
  double nearest = 0, farthest = 1e9;
  for (const auto& shape : shapes_) {
    // The normal points to the camera: if it points left, the board's right edge is nearer.
    all.is_left_far |= shape.normal.x < -kTilt;
    all.is_right_far |= shape.normal.x > kTilt;
    all.is_top_far |= shape.normal.y < -kTilt;
    all.is_bottom_far |= shape.normal.y > kTilt;
    nearest = std::max(nearest, shape.size);
    farthest = std::min(farthest, shape.size);
  }
  if (!shapes_.empty() && farthest > 0) all.size_ratio = nearest / farthest;
  return all;
}

bool BoardCollector::isEnough() const {
  if (int(views_.size()) >= rules_.most_views) return true;
  if (int(views_.size()) < rules_.wanted_views) return false;
  const auto all = coverage();
  return all.cellsMissing() <= kCellsThatMayMiss && all.tiltsMissing() == 0 && all.size_ratio >= kSpread;
}

std::string BoardCollector::wish() const {
  if (views_.empty()) return "hold the board before both cameras, and still";
  const auto all = coverage();
  if (!all.is_left_far) return "turn the board's left edge away from the cameras";
  if (!all.is_right_far) return "turn the board's right edge away from the cameras";
  if (!all.is_top_far) return "lean the board's top edge back";
  if (!all.is_bottom_far) return "lean the board's bottom edge back";
  if (all.size_ratio < kSpread) return "bring the board nearer, then farther away";
  if (all.cellsMissing() > kCellsThatMayMiss)
    for (const bool is_left : {true, false}) {
      const auto& cells = is_left ? all.left_cells : all.right_cells;
      const auto missing = std::find(cells.begin(), cells.end(), false);
      if (missing != cells.end())
        return formatted("hold the board at the %s of the %s picture", kCellNames[missing - cells.begin()],
                         is_left ? "left" : "right");
    }
  return isEnough() ? "these views are enough" : "hold the board elsewhere, tilted otherwise, and still";
}

cameras::Calibration BoardCollector::calibrate(TaskMonitor& monitor) const {
  return cameras::calibrateCorners(views_, picture_, board_, monitor);
}

}  // namespace facenav::steps
