#include "facenav/health/pair_matches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/cameras/patch_match.h"
#include "neighbourhood.h"

namespace facenav::health {
namespace {

constexpr int kFeatures = 4000, kCorners = 2500;
constexpr double kContrast = 0.008;  // of a SIFT extremum: a fifth of OpenCV's default, for skin
constexpr float kRatio = 0.9F;       // best to second best; neighbours reject the remaining outliers
constexpr std::size_t kNeighbours = 8;
// Disparity gradient of a surface slanted by 60 degrees in front of cameras 30 degrees apart: one half.
constexpr double kDisparityGradient = 0.5, kNear_px = 4.0;
constexpr double kCornerSpacing_px = 5;
constexpr int kPatch_px = 61;             // covers the coarse patch of matchPatch and its gradients
constexpr double kBackAndForth_px = 0.7;  // largest error of a match that is searched back in the left image
constexpr double kSlant_px = 0.1;         // error of a plane patch on curved skin

Eigen::Vector2d toEigen(const cv::Point2f& p) { return {p.x, p.y}; }

std::vector<PixelPair> features(const cv::Mat& left, const cv::Mat& right) {
  const cv::Ptr<cv::SIFT> sift = cv::SIFT::create(kFeatures, 3, kContrast);
  std::vector<cv::KeyPoint> at_left, at_right;
  cv::Mat left_words, right_words;
  sift->detectAndCompute(left, cv::noArray(), at_left, left_words);
  sift->detectAndCompute(right, cv::noArray(), at_right, right_words);
  if (at_left.size() < 2 || at_right.size() < 2) return {};
  const cv::BFMatcher matcher(cv::NORM_L2);
  std::vector<std::vector<cv::DMatch>> forth, back;
  matcher.knnMatch(left_words, right_words, forth, 2);
  matcher.knnMatch(right_words, left_words, back, 1);
  std::vector<PixelPair> pairs;
  for (const auto& match : forth) {
    if (match.size() < 2 || match[0].distance > kRatio * match[1].distance) continue;
    if (back[match[0].trainIdx].empty() || back[match[0].trainIdx][0].trainIdx != match[0].queryIdx) continue;
    pairs.push_back({toEigen(at_left[match[0].queryIdx].pt), toEigen(at_right[match[0].trainIdx].pt)});
  }
  return pairs;
}

/// Pairs with which at least half of their neighbours agree.
std::vector<PixelPair> coherent(const std::vector<PixelPair>& pairs) {
  std::vector<PixelPair> kept;
  for (const PixelPair& pair : pairs) {
    const auto around = nearest(pairs, pair.left_px, kNeighbours + 1, 1e9);
    std::size_t agreeing = 0;
    for (const std::size_t i : around) {
      const double apart_px = (pairs[i].left_px - pair.left_px).norm();
      agreeing += (pairs[i].shift() - pair.shift()).norm() < kNear_px + kDisparityGradient * apart_px;
    }
    if (agreeing >= kNeighbours / 2 + 1) kept.push_back(pair);  // counts itself
  }
  return kept;
}

std::optional<Correspondence> refined(const cv::Mat& left, const cv::Mat& right,
                                      const Eigen::Vector2d& left_px, const Neighbourhood& here) {
  const Eigen::Vector2d middle = Eigen::Vector2d::Constant(0.5 * (kPatch_px - 1));
  const auto forth =
      cameras::matchPatch(warped(left, left_px, here.map.inverse(), kPatch_px), right, middle, here.at);
  if (!forth) return std::nullopt;
  const auto back =
      cameras::matchPatch(warped(right, forth->right_px, here.map, kPatch_px), left, middle, left_px);
  if (!back || (back->right_px - left_px).norm() > kBackAndForth_px) return std::nullopt;
  return Correspondence{left_px, forth->right_px, std::hypot(forth->sigma_px, kSlant_px)};
}

std::vector<Correspondence> matchCorners(const cv::Mat& left, const cv::Mat& right,
                                         const std::vector<PixelPair>& seeds,
                                         const std::vector<cv::Point2f>& corners) {
  std::vector<Correspondence> found;
  for (const auto& corner : corners) {
    const Eigen::Vector2d left_px = toEigen(corner);
    const auto here = neighbourhood(seeds, left_px);
    if (!here) continue;
    if (const auto match = refined(left, right, left_px, *here)) found.push_back(*match);
  }
  return found;
}

}  // namespace

std::vector<Correspondence> matchPictures(const cv::Mat& left, const cv::Mat& right) {
  std::vector<PixelPair> seeds = coherent(coherent(features(left, right)));
  if (seeds.size() < kNeighbours) return {};
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(left, corners, kCorners, 0.002, kCornerSpacing_px, cv::noArray(), 7);
  for (const auto& match : matchCorners(left, right, seeds, corners))
    seeds.push_back({match.left_px, match.right_px});  // a match and its slant predict its neighbours
  auto matches = matchCorners(left, right, seeds, corners);
  std::vector<PixelPair> pairs;
  for (const auto& match : matches) pairs.push_back({match.left_px, match.right_px});
  const auto kept = coherent(pairs);
  std::vector<Correspondence> out;
  std::size_t next = 0;
  for (const auto& match : matches)
    if (next < kept.size() && kept[next].left_px == match.left_px) out.push_back(match), ++next;
  return out;
}

}  // namespace facenav::health
