#include "expression.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "eyelid.h"
#include "smooth_step.h"

namespace facenav::room {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// These sizes were chosen by eye on renderings, guided by photographs of grimacing faces (mouth corners 5-10
// mm, brows 1-3 mm); they are not fitted.
constexpr double kTongueJaw_mm = 9.0, kTongueAside_mm = 11.0, kMouthAside_mm = 5.0;
constexpr float kTongueAlbedo = 0.34f, kTeethAlbedo = 0.62f, kLipAlbedo = 0.28f;

/// One side of the face: its landmarks, and the direction away from the midline.
struct Side {
  std::size_t corner, ala, lower_lid;
  double out;  // sign along Mri x
};

std::array<Side, 2> sides(const Points& l) {
  const double right = l[48].x() > l[54].x() ? 1.0 : -1.0;
  return {{{48, 31, 41, right}, {54, 35, 46, -right}}};
}

double bump(const Eigen::Vector3d& from_mm, double reach_mm) {
  return std::exp(-from_mm.squaredNorm() / (2.0 * reach_mm * reach_mm));
}

/// Bump of a lip: wide along the mouth, low in height.
double lipBump(const Eigen::Vector3d& from_mm) {
  return bump(from_mm.cwiseQuotient(Eigen::Vector3d(18.0, 14.0, 6.5)), 1.0);
}

Eigen::Vector3d smile(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, const Points& l) {
  Eigen::Vector3d shift = lipBump(p - l[51]) * Eigen::Vector3d(0.0, -1.5, 1.5) +
                          lipBump(p - l[57]) * Eigen::Vector3d(0.0, -2.0, -0.5);
  for (const Side& side : sides(l)) {
    const Eigen::Vector3d apple = 0.5 * (l[side.corner] + l[side.lower_lid]);
    const double cheek = bump(p - apple, 13.0);
    shift += bump(p - l[side.corner], 12.0) * Eigen::Vector3d(6.0 * side.out, -3.0, 4.5);
    shift += cheek * (3.0 * normal + Eigen::Vector3d(0.0, 0.0, 2.0));
    shift += bump(p - l[side.ala], 7.0) * Eigen::Vector3d(1.5 * side.out, 0.0, 1.0);
    shift.z() += 1.5 * bump(p - l[side.lower_lid], 7.0);
  }
  return shift;
}

Eigen::Vector3d tongue(const Eigen::Vector3d& p, const Points& l, double aside) {
  const Eigen::Vector3d tip = l[57] + aside * kTongueAside_mm * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d from = (p - tip).cwiseQuotient(Eigen::Vector3d(12.0, 14.0, 9.0));
  return bump(from, 1.0) * Eigen::Vector3d(0.0, 9.0, -3.0) +
         lipBump(p - l[51]) * Eigen::Vector3d(0.0, 0.5, 1.0) +
         (lipBump(p - l[51]) + lipBump(p - l[57])) * Eigen::Vector3d(kMouthAside_mm * aside, 0.0, 0.0);
}

Eigen::Vector3d lipsIn(const Eigen::Vector3d& p, const Points& l) {
  Eigen::Vector3d shift = lipBump(p - l[51]) * Eigen::Vector3d(0.0, -6.0, -3.0) +
                          lipBump(p - l[57]) * Eigen::Vector3d(0.0, -6.5, 3.0) +
                          bump(p - 0.5 * (l[8] + l[57]), 11.0) * Eigen::Vector3d(0.0, 1.5, 2.5);
  for (const Side& side : sides(l))
    shift += bump(p - l[side.corner], 11.0) * Eigen::Vector3d(-2.0 * side.out, -1.0, -1.0);
  return shift;
}

Eigen::Vector3d cheeks(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, const Points& l) {
  Eigen::Vector3d shift = (lipBump(p - l[51]) + lipBump(p - l[57])) * Eigen::Vector3d(0.0, 2.5, 0.0);
  for (const Side& side : sides(l)) {
    const Eigen::Vector3d pouch = l[side.corner] + Eigen::Vector3d(17.0 * side.out, -12.0, 3.0);
    shift += 8.0 * bump(p - pouch, 15.0) * normal;
    shift.x() -= 3.0 * side.out * bump(p - l[side.corner], 10.0);
  }
  return shift;
}

/// The frontal muscle pulls brows and forehead skin up, less towards the hairline, and folds the forehead
/// horizontally.
Eigen::Vector3d brows(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, const Points& l) {
  const double brow_z = 0.5 * (l[19].z() + l[24].z()), lid_z = 0.5 * (l[38].z() + l[43].z());
  const double aside = std::abs(p.x() - l[27].x()), above = p.z() - brow_z;
  const double temples = 1.0 - smoothStep((aside - 38.0) / 18.0);
  const double behind = 1.0 - smoothStep((l[27].y() - 35.0 - p.y()) / 25.0);
  const double rise = smoothStep((p.z() - lid_z) / std::max(4.0, brow_z - lid_z));
  const double fade = std::exp(-std::pow(std::max(0.0, above) / 32.0, 2));
  const double folded = smoothStep((above - 6.0) / 8.0) * (1.0 - smoothStep((above - 30.0) / 12.0));
  return temples * behind *
         (3.2 * rise * fade * Eigen::Vector3d::UnitZ() +
          0.3 * folded * std::sin(2.0 * M_PI * above / 8.0) * normal);
}

/// 0 at the bridge of the nose, 1 away from it.
double awayFromBridge(const Eigen::Vector3d& p, const Points& l) {
  double away = 1.0;
  for (const std::size_t point : {27, 28, 29}) away *= 1.0 - bump(p - l[point], 9.0);
  return away;
}

}  // namespace

double jawOf_mm(const Expression& expression) { return kTongueJaw_mm * expression.tongue; }

Eigen::Vector3d expressionShift_mm(const Expression& expression, const Eigen::Vector3d& p_mm,
                                   const Eigen::Vector3d& normal, const Points& l) {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  if (expression.smile != 0.0) shift += expression.smile * smile(p_mm, normal, l);
  if (expression.tongue != 0.0) shift += expression.tongue * tongue(p_mm, l, expression.aside);
  if (expression.lips_in != 0.0) shift += expression.lips_in * lipsIn(p_mm, l);
  if (expression.cheeks != 0.0) shift += expression.cheeks * cheeks(p_mm, normal, l);
  if (expression.brows != 0.0) shift += expression.brows * brows(p_mm, normal, l);
  if (expression.blink != 0.0) shift += lidShift_mm(expression.blink, p_mm, normal, l);
  return awayFromBridge(p_mm, l) * shift;
}

SkinPaint mouthPaint(const Expression& expression, const Eigen::Vector3d& p_mm, const Points& l) {
  const double closed = std::max(expression.lips_in, expression.cheeks);
  const double shown = std::clamp(std::max({expression.tongue, expression.smile, closed}), 0.0, 1.0);
  if (shown == 0.0) return {};
  const bool is_tongue = expression.tongue == shown;
  Eigen::Vector3d middle = 0.5 * (l[66] + (is_tongue ? l[57] : l[62]));
  if (is_tongue) middle.x() += kTongueAside_mm * expression.aside;
  const double half_width = (is_tongue ? 0.28 : 0.40) * std::abs(l[48].x() - l[54].x());
  const double aside = (p_mm.x() - middle.x()) / half_width,
               up = (p_mm.z() - middle.z()) / (is_tongue ? 5.0 : 3.0);
  const bool is_front = p_mm.y() > middle.y() - 25.0;
  const double share = is_front ? shown * (1.0 - smoothStep(3.0 * (std::hypot(aside, up) - 0.8))) : 0.0;
  return {float(share), is_tongue ? kTongueAlbedo : expression.smile == shown ? kTeethAlbedo : kLipAlbedo};
}

}  // namespace facenav::room
