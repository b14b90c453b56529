#include "coarse_search.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "search_kernel.h"

#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::head_tracking {
namespace {

constexpr double kYaws_deg[] = {0, 14, -14, 28, -28}, kNods_deg[] = {0, 13, -13}, kLeans_deg[] = {0, 17, -17};
constexpr double kScales[] = {1.0, 0.82, 1.22};    // scales of the face in the image, tried in turn
constexpr double kNearest = 0.6, kFarthest = 1.7;  // distance of the face, relative to that in the view
constexpr std::size_t kAtOnce = 20;                // views per frame
constexpr std::size_t kMostInView = 160;           // points of a view
constexpr std::size_t kMostFitted = 2;             // places per frame
constexpr double kLeastLikeness = 0.25, kLeastFitted = 0.4;
constexpr int kViewComparisons = 30,
              kTemplateComparisons = 180;  // work for one view, for one fit of the template

Eigen::Matrix3d turnAbout(const Eigen::Vector3d& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

double turnOf(const Eigen::Matrix3d& rotation) { return Eigen::AngleAxisd(rotation).angle(); }

}  // namespace

// An evened image with a border of zeros, and a copy split into four images of every second pixel along both
// axes, so that places two pixels apart are compared row by row at once.
class CoarseSearch::SearchImage {
 public:
  explicit SearchImage(const cv::Mat1f& image)
      : size_(image.size()), rim_(2 * (std::max(image.cols, image.rows) / 4)) {
    // The right border also covers the kernel's last block of columns, whose surplus results are unused.
    cv::copyMakeBorder(image, padded_, rim_, rim_ + 1, rim_, rim_ + 2 * search::kLanes, cv::BORDER_CONSTANT,
                       0.0);
    for (int p = 0; p < 4; ++p) {
      half_[p].create(padded_.rows / 2, padded_.cols / 2);
      for (int y = 0; y < half_[p].rows; ++y) {
        const float* from = padded_[2 * y + (p >> 1)] + (p & 1);
        for (int x = 0; x < half_[p].cols; ++x) half_[p](y, x) = from[2 * x];
      }
    }
  }

  /// The points of a view in whole pixels of this image, without those too far out for the border.
  struct Stencil {
    std::vector<cv::Point> at;
    std::vector<int> offset;  // offsets of the same points in the padded image
    std::vector<float> value;
    double squares = 0.0;
  };
  Stencil stencil(const std::vector<View::Point>& points, double scale) const {
    Stencil stencil;
    for (const auto& point : points) {
      const cv::Point at(int(std::lround(scale * point.from_centre.x())),
                         int(std::lround(scale * point.from_centre.y())));
      if (std::max(std::abs(at.x), std::abs(at.y)) > rim_) continue;
      stencil.at.push_back(at), stencil.value.push_back(point.value);
      stencil.offset.push_back(at.y * int(padded_.step1()) + at.x);
      stencil.squares += double(point.value) * point.value;
    }
    return stencil;
  }

  struct Match {
    double product = 0.0, then_squares = 0.0, now_squares = 0.0;
    double likeness() const { return product / std::sqrt(std::max(1e-9, then_squares * now_squares)); }
    Match operator+(const Match& other) const {
      return {product + other.product, then_squares + other.then_squares, now_squares + other.now_squares};
    }
  };

  /// Returns no match if the centre lies outside.
  Match matchAt(const Stencil& stencil, const Eigen::Vector2d& centre_px) const {
    const int x = int(std::lround(centre_px.x())), y = int(std::lround(centre_px.y()));
    if (x < 0 || y < 0 || x >= size_.width || y >= size_.height) return {};
    const float* centre = padded_[y + rim_] + x + rim_;
    float product = 0, squares = 0;
    for (std::size_t i = 0; i < stencil.offset.size(); ++i) {
      const float now = centre[stencil.offset[i]];
      product += stencil.value[i] * now, squares += now * now;
    }
    return {product, stencil.squares, squares};
  }

  /// The place, to two pixels and with the centre inside the image, where the points fit best.
  Eigen::Vector2d bestPlace(const Stencil& stencil) const {
    const int columns = size_.width / 2, rows = size_.height / 2;
    cv::Mat1f sums(rows, (columns + search::kLanes - 1) / search::kLanes * search::kLanes);
    std::vector<const float*> from;
    from.reserve(stencil.at.size());
    for (const auto& at : stencil.at) {
      const int x = at.x + rim_, y = at.y + rim_;
      from.push_back(half_[2 * (y & 1) + (x & 1)][y / 2] + x / 2);
    }
    search::Correlation task;
    task.from = from.data(), task.value = stencil.value.data(), task.count = int(from.size());
    task.stride = int(half_[0].step1()), task.columns = sums.cols, task.rows = rows;
    task.sums = sums.ptr<float>();
    search::kernel().correlate(task);
    cv::Point at;
    cv::minMaxLoc(sums.colRange(0, columns), nullptr, nullptr, nullptr, &at);
    return {2.0 * at.x, 2.0 * at.y};
  }

 private:
  cv::Size size_;
  int rim_;
  cv::Mat1f padded_;
  std::array<cv::Mat1f, 4> half_;
};

CoarseSearch::CoarseSearch(const cameras::StereoRig& rig, const std::array<ImagePyramid, 2>& key,
                           FaceTemplate face)
    : face_(std::move(face)) {
  appearances_.push_back(face_.appearanceAt(rig, EvenedPair(key), Eigen::Isometry3d::Identity()));
  const Eigen::Vector3d& centre_mm = face_.centre_mm();
  for (const double lean_deg : kLeans_deg)
    for (const double nod_deg : kNods_deg)
      for (const double yaw_deg : kYaws_deg) {
        const Eigen::Matrix3d turn = turnAbout(Eigen::Vector3d::UnitZ(), lean_deg * kRadPerDeg) *
                                     turnAbout(Eigen::Vector3d::UnitY(), yaw_deg * kRadPerDeg) *
                                     turnAbout(Eigen::Vector3d::UnitX(), nod_deg * kRadPerDeg);
        const Eigen::Isometry3d motion =
            Eigen::Translation3d(centre_mm) * Eigen::Isometry3d(turn) * Eigen::Translation3d(-centre_mm);
        views_.push_back(viewAt(rig, motion, 0));
      }
  std::stable_sort(views_.begin(), views_.end(), [](const View& a, const View& b) {
    return turnOf(a.motion.linear()) < turnOf(b.motion.linear());
  });
}

CoarseSearch::View CoarseSearch::viewAt(const cameras::StereoRig& rig, const Eigen::Isometry3d& motion,
                                        std::size_t appearance) const {
  View view{motion, appearance, {}};
  for (int c = 0; c < 2; ++c) {
    const cameras::CameraModel& camera = c == 0 ? rig.left : rig.right;
    const Eigen::Isometry3d camera_T_head = c == 0 ? motion : rig.right_T_left.isometry() * motion;
    const Eigen::Vector2d centre_px = cameras::project(camera, camera_T_head * face_.centre_mm());
    const auto is_seen = face_.seenBy(camera, camera_T_head);
    const auto& grey = appearances_[appearance].grey[0][c];
    for (std::size_t i = 0; i < grey.size(); ++i) {
      if (!is_seen[i] || grey[i].weight <= 0) continue;
      const Eigen::Vector2d px = cameras::project(camera, camera_T_head * face_.points()[i].mm);
      view.points[c].push_back({((px - centre_px) / double(kCoarsestStep)).cast<float>(), grey[i].value});
    }
    auto& points = view.points[c];
    const std::size_t every = points.size() / kMostInView + 1;
    for (std::size_t i = 0; i * every < points.size(); ++i) points[i] = points[i * every];
    points.resize((points.size() + every - 1) / every);
  }
  return view;
}

void CoarseSearch::add(const cameras::StereoRig& rig, const std::array<ImagePyramid, 2>& now,
                       const Eigen::Isometry3d& motion) {
  appearances_.push_back(face_.appearanceAt(rig, EvenedPair(now), motion));
  views_.insert(views_.begin(), viewAt(rig, motion, appearances_.size() - 1));
}

std::size_t CoarseSearch::likeliest(const Eigen::Isometry3d& motion) const {
  const auto apart = [&](const View& view) {
    return turnOf(view.motion.linear().transpose() * motion.linear());
  };
  return std::min_element(views_.begin(), views_.end(),
                          [&](const View& a, const View& b) { return apart(a) < apart(b); })
      ->appearance;
}

std::optional<CoarseSearch::Candidate> CoarseSearch::locate(const cameras::StereoRig& rig,
                                                            const std::array<SearchImage, 2>& images,
                                                            const View& view, double scale) const {
  if (std::min(view.points[0].size(), view.points[1].size()) < FaceTemplate::kFewestPoints)
    return std::nullopt;
  const auto in_left = images[0].stencil(view.points[0], scale),
             in_right = images[1].stencil(view.points[1], scale);
  const Eigen::Vector2d left_px = images[0].bestPlace(in_left);
  const auto left = images[0].matchAt(in_left, left_px);
  if (left.likeness() < kLeastLikeness) return std::nullopt;
  const Eigen::Vector3d then_mm = view.motion * face_.centre_mm();
  const Eigen::Vector3d ray =
      cameras::undistort(rig.left, double(kCoarsestStep) * left_px).homogeneous().normalized();
  Candidate best;
  // Steps of distance that move the face by about a pixel of this level in the right image.
  const double step =
      double(kCoarsestStep) * then_mm.norm() / (rig.right.k(0, 0) * rig.right_T_left.translation_mm().norm());
  for (double distance = kNearest; distance < kFarthest; distance *= 1.0 + step * distance) {
    const Eigen::Vector3d centre_mm = distance * then_mm.norm() * ray;
    const Eigen::Vector3d right_mm = rig.right_T_left.isometry() * centre_mm;
    if (right_mm.z() < 1) continue;
    const auto both =
        left + images[1].matchAt(in_right, cameras::project(rig.right, right_mm) / double(kCoarsestStep));
    if (both.likeness() <= best.likeness) continue;
    best.likeness = both.likeness();
    best.motion.linear() = rotationBetween(then_mm, ray) * view.motion.linear();
    best.motion.translation() = centre_mm - best.motion.linear() * face_.centre_mm();
  }
  best.appearance = view.appearance;
  return best.likeness > kLeastLikeness ? std::optional(best) : std::nullopt;
}

std::vector<CoarseSearch::Candidate> CoarseSearch::likelyPlaces(const cameras::StereoRig& rig,
                                                                const EvenedPair& now, std::size_t first,
                                                                std::size_t end, double scale) const {
  const std::array<SearchImage, 2> images = {SearchImage(now.image[0][0]), SearchImage(now.image[0][1])};
  std::vector<Candidate> found;
  for (std::size_t k = first; k < end; ++k)
    if (const auto there = locate(rig, images, views_[k], scale)) found.push_back(*there);
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.likeness > b.likeness; });
  if (found.size() > kMostFitted) found.resize(kMostFitted);
  return found;
}

CoarseSearch::Places CoarseSearch::find(const cameras::StereoRig& rig, const EvenedPair& now,
                                        const std::optional<Eigen::Isometry3d>& expected, int turn) const {
  Places places;
  std::vector<Candidate> found;
  if (!views_.empty() && !(expected && turn == 0)) {
    const std::size_t turns = (views_.size() + kAtOnce - 1) / kAtOnce,
                      first = std::size_t(turn) % turns * kAtOnce,
                      end = std::min(first + kAtOnce, views_.size());
    found = likelyPlaces(rig, now, first, end, kScales[(std::size_t(turn) / turns) % std::size(kScales)]);
    places.comparisons += kViewComparisons * int(end - first);
  }
  if (!views_.empty() && expected) found.push_back({likeliest(*expected), *expected, 0.0});
  std::vector<FaceTemplate::Fit> fits;
  for (const auto& candidate : found) {
    const auto fit = face_.fit(rig, appearances_[candidate.appearance], now, candidate.motion);
    if (fit.likeness > kLeastFitted) fits.push_back(fit);
  }
  places.comparisons += kTemplateComparisons * int(found.size());
  std::stable_sort(fits.begin(), fits.end(),
                   [](const auto& a, const auto& b) { return a.likeness > b.likeness; });
  for (const auto& fit : fits) places.starts.push_back(fit.motion);
  return places;
}

}  // namespace facenav::head_tracking
