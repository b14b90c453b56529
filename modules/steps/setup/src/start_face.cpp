#include "start_face.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/health/pair_matches.h"

namespace facenav::steps {
namespace {

using health::RigState;

constexpr std::size_t kWantedPairs = 3, kMostPairs = 7, kAgreeingPairs = 2;
constexpr double kBetweenPairs_s = 0.4, kBetweenLooks_s = 1.0;  // with a face, without one
/// Number of searches for an upright face per search in any roll, which takes ten times as long.
constexpr int kLooksPerRoll = 4;
/// Rows of two pairs agree within this share of the larger. Smaller is stricter. Evidence:
/// resources/doc/evidence.md.
constexpr double kAgreeShare = 0.5;
/// Limits of a face at rest: within a thirtieth of a second, the largest delay between exposures without a
/// trigger, it moves less than the diagnosis can detect.
constexpr double kExposuresApart_s = 1.0 / 30, kAtRest_px = 0.3, kLongestBetween_s = 0.2;

/// Maps a pair's diagnosis to the state of a stored rig; pictures of two moments are unclear.
health::RigState stateOf(health::RigState diagnosed) {
  return diagnosed == health::RigState::out_of_step ? health::RigState::unclear : diagnosed;
}

cv::Mat faceOf(const cv::Mat& image, const cv::Rect& box) {
  cv::Mat grey;
  image(box & cv::Rect({}, image.size())).convertTo(grey, CV_32F);
  return grey;
}

}  // namespace

StartFace::StartFace(const cameras::StereoRig& rig, std::shared_ptr<const face::FaceDetector> detector)
    : rig_(rig), detector_(std::move(detector)) {}

bool StartFace::seesFace(const cameras::StereoFrame& frame) {
  const bool has_all_rolls = looks_++ % kLooksPerRoll == kLooksPerRoll - 1;
  const auto find = [&](const cv::Mat& image, std::optional<face::FaceLandmarks>& last) {
    if (last) last = detector_->detectNear(image, *last);
    if (!last) last = has_all_rolls ? detector_->detect(image) : detector_->detectAtRoll(image, 0.0);
    return last.has_value();
  };
  return find(frame.left, left_) && find(frame.right, right_);
}

/// Compares the frame with the one before; false if that is too long ago.
bool StartFace::isAtRest(const cameras::StereoFrame& frame) const {
  const double between_s = frame.captured - before_.captured;
  if (before_.left.size() != frame.left.size() || between_s <= 0 || between_s > kLongestBetween_s)
    return false;
  const cv::Mat before = faceOf(before_.left, left_->face), now = faceOf(frame.left, left_->face);
  if (now.rows < 8 || now.cols < 8) return false;
  return cv::norm(cv::phaseCorrelate(before, now)) * kExposuresApart_s / between_s < kAtRest_px;
}

StartFace::Pair StartFace::diagnosed(const cameras::StereoFrame& frame) const {
  const auto matches = health::matchPictures(frame.left, frame.right);
  Pair pair{health::diagnoseMatches(rig_, matches)};
  if (pair.diagnosis.isOfCameras())
    pair.diagnosis =
        health::withSkin(rig_, pair.diagnosis, health::growMatches(frame.left, frame.right, matches));
  std::vector<double> rows_px;
  for (const auto& match : matches) {
    const double row_px = cameras::epipolarResidual_px(rig_, match.left_px, match.right_px);
    if (std::isfinite(row_px)) rows_px.push_back(row_px);
  }
  if (!rows_px.empty()) pair.row_px = median(rows_px);
  return pair;
}

void StartFace::add(const cameras::StereoFrame& frame) {
  if (isDone()) return;
  if (!next_s_ || frame.captured.s >= *next_s_) {
    const bool is_seen = seesFace(frame);
    const bool is_at_rest = is_seen && isAtRest(frame);
    if (!is_seen) next_s_ = frame.captured.s + kBetweenLooks_s;
    if (is_at_rest) {
      const Pair pair = diagnosed(frame);
      if (pair.diagnosis.state != health::RigState::unclear) pairs_.push_back(pair);
      next_s_ = frame.captured.s + kBetweenPairs_s;
    }
  }
  before_ = frame;
}

bool StartFace::agree(const Pair& a, const Pair& b) {
  if (a.diagnosis.state != b.diagnosis.state) return false;
  if (!a.diagnosis.isOfCameras()) return true;
  const double less_px = std::min(a.diagnosis.residual_px, b.diagnosis.residual_px),
               more_px = std::max(a.diagnosis.residual_px, b.diagnosis.residual_px);
  return more_px - less_px < kAgreeShare * more_px && std::abs(a.row_px - b.row_px) < kAgreeShare * more_px;
}

/// Returns the largest group of pairs that agree.
std::vector<const StartFace::Pair*> StartFace::agreeing() const {
  std::vector<const Pair*> best;
  for (const auto& first : pairs_) {
    std::vector<const Pair*> group;
    for (const auto& pair : pairs_)
      if (agree(first, pair)) group.push_back(&pair);
    if (group.size() > best.size()) best = group;
  }
  return best;
}

health::RigState StartFace::state() const {
  const auto group = agreeing();
  if (group.size() < kAgreeingPairs || 2 * group.size() <= pairs_.size()) return health::RigState::unclear;
  return stateOf(group.front()->diagnosis.state);
}

bool StartFace::isDone() const {
  if (!detector_ || pairs_.size() >= kMostPairs) return true;
  return pairs_.size() >= kWantedPairs && state() != health::RigState::unclear;
}

std::string StartFace::words() const {
  const health::RigState now = state();
  if (now == health::RigState::unclear) return {};
  const auto& diagnosis = agreeing().front()->diagnosis;
  if (now == health::RigState::holds)
    return formatted(
        "the calibration holds as far as a face shows it (rows %.2f px apart); only the coil's "
        "marker shows a sideways turn, and a roll where the face is in the pictures' middle",
        diagnosis.residual_px);
  if (now == health::RigState::moved)
    return formatted(
        "the cameras have moved against each other since their calibration (rows %.1f px apart on the face)",
        diagnosis.residual_px);
  return diagnosis.verdict().finding;
}

}  // namespace facenav::steps
