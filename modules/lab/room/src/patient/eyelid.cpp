#include "eyelid.h"

#include <array>
#include <cmath>

#include "smooth_step.h"

namespace facenav::room {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// Sizes chosen by eye on renderings, not fitted.
constexpr double kDrawn_mm = 2.2, kDrawnReach_mm = 14.0;  // skin between lid and brow follows the lid
constexpr double kBulge_mm = 0.8, kBulgeReach_mm = 18.0;  // the lid bulges over the eye
constexpr double kSoft_mm = 0.5, kAboveRim_mm = 0.8, kLash_mm = 0.7;
constexpr float kLidAlbedo = 0.30f, kLashAlbedo = 0.12f;

/// The first of each eye's six landmarks: a corner, two above, the other corner, two below.
constexpr std::array<std::size_t, 2> kEyes{36, 42};

/// Smooth; 1 at the centre, 0 from `reach_mm` on.
double lidBump(const Eigen::Vector3d& from_mm, double reach_mm) {
  const double inside = 1.0 - from_mm.squaredNorm() / (reach_mm * reach_mm);
  return inside > 0.0 ? inside * inside : 0.0;
}

Eigen::Vector3d middleOf(const Points& l, std::size_t eye) {
  return 0.25 * (l[eye + 1] + l[eye + 2] + l[eye + 4] + l[eye + 5]);
}

/// The eye's opening seen from the front: position of a point along it (0..1 from corner to corner), height
/// of the point above the line through the corners, and heights of both rims there.
struct Opening {
  double along, up_mm, upper_mm, lower_mm;
};

Opening openingAt(const Eigen::Vector3d& p, const Points& l, std::size_t eye) {
  const Eigen::Vector2d start(l[eye].x(), l[eye].z());
  const Eigen::Vector2d across = Eigen::Vector2d(l[eye + 3].x(), l[eye + 3].z()) - start;
  Eigen::Vector2d up(-across.y(), across.x());
  if (up.y() < 0.0) up = -up;
  up.normalize();
  const auto height = [&](const Eigen::Vector3d& q) {
    return (Eigen::Vector2d(q.x(), q.z()) - start).dot(up);
  };
  const double along = (Eigen::Vector2d(p.x(), p.z()) - start).dot(across) / across.squaredNorm();
  // A parabola from corner to corner; at the landmarks, at one and two thirds, it has 8/9 of its full height.
  const double bow = 9.0 / 8.0 * 4.0 * along * (1.0 - along);
  return {along, height(p), 0.5 * bow * (height(l[eye + 1]) + height(l[eye + 2])),
          0.5 * bow * (height(l[eye + 4]) + height(l[eye + 5]))};
}

SkinPaint paintOf(double closed, const Eigen::Vector3d& p, const Points& l, std::size_t eye) {
  if ((p - middleOf(l, eye)).squaredNorm() > kBulgeReach_mm * kBulgeReach_mm) return {};
  const Opening o = openingAt(p, l, eye);
  if (!(o.along > 0.0 && o.along < 1.0)) return {};
  const double rim_mm = o.upper_mm + closed * (o.lower_mm - o.upper_mm);
  const double share = smoothStep(10.0 * closed) *
                       smoothStep((o.upper_mm + kAboveRim_mm - o.up_mm) / kAboveRim_mm) *
                       smoothStep((o.up_mm - rim_mm + kLash_mm) / kSoft_mm) *
                       smoothStep(8.0 * std::min(o.along, 1.0 - o.along));
  const double lash = 1.0 - smoothStep((std::abs(o.up_mm - rim_mm) - 0.5 * kLash_mm) / kSoft_mm);
  return {float(share), kLidAlbedo + float(lash) * (kLashAlbedo - kLidAlbedo)};
}

}  // namespace

Eigen::Vector3d lidShift_mm(double closed, const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal,
                            const Points& l) {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (const std::size_t eye : kEyes) {
    const Eigen::Vector3d lid = 0.5 * (l[eye + 1] + l[eye + 2]) + 3.0 * Eigen::Vector3d::UnitZ();
    shift -= kDrawn_mm * lidBump(p_mm - lid, kDrawnReach_mm) * Eigen::Vector3d::UnitZ();
    shift += kBulge_mm * lidBump(p_mm - middleOf(l, eye), kBulgeReach_mm) * normal;
  }
  return closed * shift;
}

SkinPaint lidPaint(double closed, const Eigen::Vector3d& p_mm, const Points& l) {
  for (const std::size_t eye : kEyes) {
    const SkinPaint paint = paintOf(closed, p_mm, l, eye);
    if (paint.share > 0.f) return paint;
  }
  return {};
}

}  // namespace facenav::room
