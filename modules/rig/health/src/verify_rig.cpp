#include "facenav/health/verify_rig.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "check_place.h"
#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/rotation.h"
#include "facenav/health/rig_lengths.h"

namespace facenav::health {
namespace {

// Rms of a camera's own picture of a board, in units of the calibration's rms: above this it is of another
// lens.
constexpr double kOtherLensTimesRms = 3.0;
constexpr double kGrossRows_px = 5.0;          // the monitor of small motions does not explain these
constexpr double kLeastPictureShare = 0.0003;  // relative standard error of a length by the pictures
constexpr double kGrossLength = 0.1;           // relative: exchanged sides, not a knock
// Relative change of scale that shows another focal length; a baseline 3 mm longer changes it by 0.5 %.
constexpr double kOtherScale = 0.01;
constexpr double kOtherDistance =
    0.08;  // relative: less does not tell a turn from a wrong size of the squares
// Spread of the lengths' ratios, as a share of how far they are off. Computed for the rig of the tests, whose
// right camera turns by 0.1 to 1 deg, and a tilted board at 560 to 660 mm: 7 %; for a wrong size: 0.
constexpr double kEvenShare = 0.02, kUnevenShare = 0.04;
constexpr double kSwappedBetter = 0.2;  // residuals decrease to this share when the sides are exchanged

double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value;
  return values.empty() ? 0.0 : sum / double(values.size());
}

double spreadOf(const std::vector<double>& values) {
  const double mean = meanOf(values);
  double squares = 0;
  for (double value : values) squares += (value - mean) * (value - mean);
  return values.empty() ? 0.0 : std::sqrt(squares / double(values.size()));
}

/// What explains lengths that are off. A wrong size of the squares changes all of them by one factor; a
/// camera that turned sideways changes them by more the farther the board is, and the more it is tilted.
enum class LengthsShow { either, size, turn };

LengthsShow whatLengthsShow(const std::vector<double>& ratios, const std::vector<double>& distances_mm) {
  const auto [nearest, farthest] = std::minmax_element(distances_mm.begin(), distances_mm.end());
  if (ratios.size() < 2 || *farthest < (1 + kOtherDistance) * *nearest) return LengthsShow::either;
  const double spread = spreadOf(ratios), off = std::abs(meanOf(ratios) - 1);
  if (spread < kEvenShare * off) return LengthsShow::size;
  return spread > kUnevenShare * off && spread > kSignificant * kLeastPictureShare ? LengthsShow::turn
                                                                                   : LengthsShow::either;
}

double medianRow(const cameras::StereoRig& rig, const std::vector<Correspondence>& points, bool is_swapped) {
  std::vector<double> rows_px;
  for (const auto& point : points) {
    const double row_px = is_swapped ? cameras::epipolarResidual_px(rig, point.right_px, point.left_px)
                                     : cameras::epipolarResidual_px(rig, point.left_px, point.right_px);
    if (std::isfinite(row_px)) rows_px.push_back(std::abs(row_px));
  }
  // Points behind the cameras have no row. Rays that do not meet are the largest contradiction.
  return rows_px.size() * 2 < points.size() ? 1e3 : upperMedian(std::move(rows_px));
}

}  // namespace

struct RigVerifier::Implementation {
  Implementation(const cameras::StereoRig& calibrated, std::optional<cameras::Board> known_board,
                 SquareFinder marker_finder)
      : rig(calibrated),
        board(std::move(known_board)),
        findMarker(std::move(marker_finder)),
        monitor(rig),
        rows(rig) {}

  cameras::StereoRig rig;
  std::optional<cameras::Board> board;
  SquareFinder findMarker;
  RigMonitor monitor, rows;  // rows: without the lengths
  RigVerification found;
  std::vector<Correspondence> points;
  std::vector<double> board_ratios, marker_ratios, left_squares, right_squares, turns_deg, shifts_mm, scales;
  std::vector<double> ratio_errors, exchanged_errors, board_distances_mm;
  double calibration_sigma = 0, marker_mm = 0, marker_print_mm = 0;
  std::optional<CheckPlace> first_board, first_marker;
  CheckMotion newest;  // from the first of its kind

  void follow(std::optional<CheckPlace>& first, const CheckPlace& now);

  void addBoard(const cameras::StereoFrame& frame);
  void addMarker(const cameras::StereoFrame& frame);
  std::vector<MeasuredLength> lengths() const;
  RigState judge(const RigVerification& all, const RigEstimate& verdict) const;
  std::optional<SquareDoubt> squareDoubt(const RigVerification& all) const;
  void addRatio(double ratio, double exchanged_ratio);
  bool isSwapped(const RigVerification& all) const;
  bool isOtherLens(double rms_px) const {
    return rms_px > std::max(kOtherLensRms_px, kOtherLensTimesRms * rig.rms_px.value_or(0.2));
  }
};

void RigVerifier::Implementation::follow(std::optional<CheckPlace>& first, const CheckPlace& now) {
  if (!first) first = now;
  newest = motionBetween(*first, now);
  found.motion.moved_mm = std::max(found.motion.moved_mm, newest.moved_mm);
  found.motion.turned_deg = std::max(found.motion.turned_deg, newest.turned_deg);
}

void RigVerifier::Implementation::addBoard(const cameras::StereoFrame& frame) {
  const auto pair = findBoardPair(frame.left, frame.right, *board);
  if (!pair) return;
  ++found.board_frames;
  const auto matches = correspondences(*pair);
  monitor.add(matches);
  rows.add(matches);
  points.insert(points.end(), matches.begin(), matches.end());
  if (const auto square = squareOf(*pair, *board, rig)) monitor.add(*square);
  board_ratios.push_back(lengthRatio(*pair, rig));
  addRatio(board_ratios.back(), lengthRatio(exchanged(*pair), rig));
  if (calibration_sigma == 0) calibration_sigma = calibrationSigma(*pair, rig);
  const SingleView left = fitBoard(rig.left, pair->left_px, pair->board_mm),
                   right = fitBoard(rig.right, pair->right_px, pair->board_mm);
  follow(first_board, placeOf(left, *board));
  board_distances_mm.push_back(left.camera_T_board.translation().z());
  left_squares.push_back(left.rms_px * left.rms_px);
  right_squares.push_back(right.rms_px * right.rms_px);
  scales.push_back(scaleChange(left, right, rig));
  const Eigen::Isometry3d motion =
      right.camera_T_board * left.camera_T_board.inverse() * rig.right_T_left.isometry().inverse();
  turns_deg.push_back(rotationAngle(motion.linear()) * kDegPerRad);
  const Eigen::Vector3d centre_mm =
      (right.camera_T_board * left.camera_T_board.inverse()).inverse().translation();
  shifts_mm.push_back((centre_mm - rig.right_T_left.inverse().translation_mm()).norm());
}

void RigVerifier::Implementation::addMarker(const cameras::StereoFrame& frame) {
  const auto observation = findMarker(frame);
  if (!observation) return;
  ++found.marker_frames;
  std::vector<Correspondence> corners;
  for (std::size_t i = 0; i < 4; ++i)
    corners.push_back({observation->left_px[i], observation->right_px[i], observation->sigma_px});
  monitor.add(corners);
  rows.add(corners);
  points.insert(points.end(), corners.begin(), corners.end());
  monitor.add(*observation);
  follow(first_marker, placeOf(*observation, rig));
  marker_ratios.push_back(lengthRatio(*observation, rig));
  addRatio(marker_ratios.back(), lengthRatio(exchanged(*observation), rig));
  marker_mm = observation->size_mm;
  marker_print_mm = std::hypot(observation->print_sigma_mm, observation->size_sigma_mm);
  if (calibration_sigma == 0) calibration_sigma = calibrationSigma(*observation, rig);
}

std::vector<MeasuredLength> RigVerifier::Implementation::lengths() const {
  std::vector<MeasuredLength> all;
  if (!board_ratios.empty()) {
    const double true_mm = (std::max(board->columns, board->rows) - 1) * board->square_mm;
    all.push_back({"board", true_mm, true_mm * meanOf(board_ratios),
                   true_mm * std::hypot(calibration_sigma, std::hypot(kBoardPrint, kLeastPictureShare))});
  }
  if (!marker_ratios.empty())
    all.push_back({"marker", marker_mm, marker_mm * meanOf(marker_ratios),
                   std::hypot(marker_mm * calibration_sigma, marker_print_mm)});
  return all;
}

/// Says whether the size given for the squares explains the board's length: not where rows or a marker of
/// known size contradict the calibration, too.
std::optional<SquareDoubt> RigVerifier::Implementation::squareDoubt(const RigVerification& all) const {
  if (board_ratios.empty() || all.row_error_px > kGrossRows_px || rows.estimate().hasMoved())
    return std::nullopt;
  for (const auto& length : all.lengths)
    if (length.contradicts() != (length.what == "board")) return std::nullopt;
  const auto shown = whatLengthsShow(board_ratios, board_distances_mm);
  if (shown == LengthsShow::turn) return std::nullopt;
  return SquareDoubt{board->square_mm, board->square_mm * meanOf(board_ratios), shown == LengthsShow::size};
}

void RigVerifier::Implementation::addRatio(double ratio, double exchanged_ratio) {
  ratio_errors.push_back(std::abs(ratio - 1));
  exchanged_errors.push_back(std::abs(exchanged_ratio - 1));
}

/// True if rows or lengths are far off, and fit when the sides are exchanged.
bool RigVerifier::Implementation::isSwapped(const RigVerification& all) const {
  const bool rows_say =
      all.row_error_px > kGrossRows_px && medianRow(rig, points, true) < kSwappedBetter * all.row_error_px;
  const double error = upperMedian(ratio_errors), exchanged_error = upperMedian(exchanged_errors);
  return rows_say || (error > kGrossLength && exchanged_error < kSwappedBetter * error);
}

RigState RigVerifier::Implementation::judge(const RigVerification& all, const RigEstimate& verdict) const {
  if (points.empty()) return RigState::unclear;
  if (isSwapped(all)) return RigState::swapped;
  if (isOtherLens(all.left_lens_px) || isOtherLens(all.right_lens_px) ||
      std::abs(all.scale_change) > kOtherScale)
    return RigState::other_cameras;
  const bool is_length_wrong = std::any_of(all.lengths.begin(), all.lengths.end(),
                                           [](const auto& length) { return length.contradicts(); });
  if (all.row_error_px > kGrossRows_px || verdict.hasMoved() || is_length_wrong) return RigState::moved;
  return verdict.state == RigState::unclear ? RigState::unclear : RigState::holds;
}

RigVerifier::RigVerifier(const cameras::StereoRig& rig, std::optional<cameras::Board> board,
                         SquareFinder find_marker)
    : implementation_(std::make_unique<Implementation>(rig, std::move(board), std::move(find_marker))) {}

RigVerifier::~RigVerifier() = default;

void RigVerifier::add(const cameras::StereoFrame& frame) {
  Implementation& self = *implementation_;
  if (frame.left.cols != self.rig.width_px || frame.left.rows != self.rig.height_px ||
      frame.right.size() != frame.left.size())
    throw Error("the pictures are " + std::to_string(frame.left.cols) + " x " +
                    std::to_string(frame.left.rows) + " px, the rig's " + std::to_string(self.rig.width_px) +
                    " x " + std::to_string(self.rig.height_px),
                "frame " + std::to_string(frame.number),
                "use pictures of the rig's own cameras in their calibrated size");
  ++self.found.frames;
  if (self.board) self.addBoard(frame);
  if (self.findMarker) self.addMarker(frame);
}

CheckMotion RigVerifier::motion() const { return implementation_->newest; }

RigVerification RigVerifier::result() const {
  const Implementation& self = *implementation_;
  RigVerification all = self.found;
  const RigEstimate verdict = self.monitor.estimate();
  all.lengths = self.lengths();
  all.row_error_px = self.points.empty() ? 0.0 : medianRow(self.rig, self.points, false);
  all.left_lens_px = std::sqrt(meanOf(self.left_squares));
  all.right_lens_px = std::sqrt(meanOf(self.right_squares));
  all.scale_change = upperMedian(self.scales);
  all.state = self.judge(all, verdict);
  if (all.state != RigState::moved) return all;
  all.square_doubt = self.squareDoubt(all);
  // Large motions come from the board's poses; small ones from the monitor, which uses only what the rows
  // determine.
  const bool is_gross = all.row_error_px > kGrossRows_px && !self.turns_deg.empty();
  all.turn_deg = is_gross ? upperMedian(self.turns_deg) : verdict.turn_rad.norm() * kDegPerRad;
  all.shift_mm = is_gross ? upperMedian(self.shifts_mm) : 0.0;
  all.point_error_mm = verdict.displaced_mm;
  return all;
}

}  // namespace facenav::health
