#include "facenav/pictures/projected_guide.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "facenav/guidance/handle.h"
#include "facenav/pictures/aligned_skin.h"
#include "skin_depth.h"
#include "skin_under.h"
#include "to_rgb.h"

namespace facenav::pictures {
namespace {

const cv::Scalar kGuideWhite(255, 255, 255), kGuideBlue(90, 185, 255), kGuideOrange(255, 150, 20);  // R, G, B
constexpr double kLine_mm = 2.0, kThin_mm = 1.2, kStep_mm = 2.0, kHandle_mm = 110, kArrow_mm = 34;
constexpr double kLit_mm = 6.0;  // skin this far behind the first skin on the ray is still lit
constexpr int kLitStep_px = 2, kShift = 4;

using Line = std::vector<Eigen::Vector2d>;  // in the target's plane, mm

Line circle(double radius_mm) {
  Line line;
  const int steps = std::max(24, int(2 * M_PI * radius_mm / kStep_mm));
  for (int i = 0; i <= steps; ++i) {
    const double angle = 2 * M_PI * i / steps;
    line.emplace_back(radius_mm * std::cos(angle), radius_mm * std::sin(angle));
  }
  return line;
}

/// Returns points along a line, no farther apart than kStep_mm, so that it follows the skin.
Line fine(const Line& corners) {
  Line line;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Eigen::Vector2d way = corners[i + 1] - corners[i];
    const int steps = std::max(1, int(std::ceil(way.norm() / kStep_mm)));
    for (int k = 0; k < steps; ++k) line.push_back(corners[i] + way * (double(k) / steps));
  }
  if (!corners.empty()) line.push_back(corners.back());
  return line;
}

Line closed(const std::vector<Eigen::Vector2d>& outline) {
  Line line = outline;
  if (!line.empty()) line.push_back(line.front());
  return fine(line);
}

bool isSame(const guidance::Target& a, const guidance::Target& b) {
  return a.mri_T_target.matrix() == b.mri_T_target.matrix() && a.lift_mm == b.lift_mm &&
         a.scalp_point.mm == b.scalp_point.mm;
}

}  // namespace

struct ProjectedGuide::Implementation {
  cameras::ProjectorModel projector;
  AlignedSkin skin;
  guidance::CoilPlate plate;
  std::optional<guidance::Target> target;  // target of `under`
  std::optional<SkinUnder> under;
  double ring_lit = 0;

  /// State of one frame's picture while it is drawn.
  struct Canvas {
    cv::Mat image;
    Eigen::Isometry3d projector_T_target;
    const SkinDepth& depth;
    double hair_mm, px_per_mm;
  };
  std::optional<Eigen::Vector2d> lit(const Canvas& canvas, const Eigen::Vector2d& p_mm) const;
  double litShare(const Canvas& canvas, const Line& line) const;
  void stroke(Canvas& canvas, const Line& line, const cv::Scalar& colour, double width_mm) const;
  void drawArrow(Canvas& canvas, const Eigen::Vector2d& coil_mm, double ring_mm) const;
  void drawPlace(Canvas& canvas, bool is_on_target) const;
  void drawWay(Canvas& canvas, const guidance::GuidanceState& state) const;
};

/// Projector pixel of a point of the target's plane, placed on the head. Nothing where there is no head, or
/// where something else blocks the projector's light.
std::optional<Eigen::Vector2d> ProjectedGuide::Implementation::lit(const Canvas& canvas,
                                                                   const Eigen::Vector2d& p_mm) const {
  const auto depth_mm = under->depth_mm(p_mm.x(), p_mm.y());
  if (!depth_mm) return std::nullopt;
  const Eigen::Vector3d p =
      canvas.projector_T_target * Eigen::Vector3d(p_mm.x(), p_mm.y(), *depth_mm - canvas.hair_mm);
  if (p.z() < 50) return std::nullopt;
  const Eigen::Vector2d px = cameras::project(projector.lens, p);
  if (!(px.cwiseAbs().maxCoeff() < 20000) || !canvas.depth.isOpen(px, p.z(), kLit_mm + canvas.hair_mm))
    return std::nullopt;
  return px;
}

double ProjectedGuide::Implementation::litShare(const Canvas& canvas, const Line& line) const {
  const auto count = std::count_if(line.begin(), line.end(), [&](const auto& p_mm) {
    const auto px = lit(canvas, p_mm);
    return px && px->x() >= 0 && px->y() >= 0 && px->x() < projector.width_px &&
           px->y() < projector.height_px;
  });
  return double(count) / double(line.size());
}

void ProjectedGuide::Implementation::stroke(Canvas& canvas, const Line& line, const cv::Scalar& colour,
                                            double width_mm) const {
  const int width_px = std::max(1, int(std::lround(width_mm * canvas.px_per_mm)));
  std::optional<cv::Point> last;
  for (const auto& p_mm : line) {
    const auto px = lit(canvas, p_mm);
    std::optional<cv::Point> now;
    if (px)
      now = cv::Point(int(std::lround(px->x() * (1 << kShift))), int(std::lround(px->y() * (1 << kShift))));
    if (last && now) cv::line(canvas.image, *last, *now, colour, width_px, cv::LINE_AA, kShift);
    last = now;
  }
}

/// Draws an arrow outside the ring, on the coil's side, that points at the target.
void ProjectedGuide::Implementation::drawArrow(Canvas& canvas, const Eigen::Vector2d& coil_mm,
                                               double ring_mm) const {
  const Eigen::Vector2d back = coil_mm.normalized(), aside(-back.y(), back.x());
  const Eigen::Vector2d tip = back * (ring_mm + 5), tail = tip + back * kArrow_mm;
  stroke(canvas, fine({tail, tip}), kGuideOrange, 1.5 * kLine_mm);
  for (const double side : {-1.0, 1.0})
    stroke(canvas, fine({tip, tip + 12 * back + side * 9 * aside}), kGuideOrange, 1.5 * kLine_mm);
}

/// Draws outline and handle of the coil's planned position, and the ring round the target.
void ProjectedGuide::Implementation::drawPlace(Canvas& canvas, bool is_on_target) const {
  const cv::Scalar colour = is_on_target ? kGuideBlue : kGuideWhite;
  stroke(canvas, closed(plate.outline_mm), colour, kThin_mm);
  double back_mm = 0;
  for (const auto& corner : plate.outline_mm) back_mm = std::min(back_mm, corner.y());
  stroke(canvas, fine({{0, back_mm}, {0, -kHandle_mm}}), colour, kThin_mm);
  stroke(canvas, circle(kRing_mm), colour, is_on_target ? 2 * kLine_mm : kLine_mm);
}

void ProjectedGuide::Implementation::drawWay(Canvas& canvas, const guidance::GuidanceState& state) const {
  const auto& values = *state.values;
  if (state.state == guidance::State::on_target) return;
  const double ring_mm = std::min(kWidestRing_mm, kRing_mm + kOpening_per_mm * values.distance_mm);
  stroke(canvas, circle(ring_mm), kGuideOrange, kLine_mm);
  if (values.lateral_in_target_mm.norm() > 1.0) drawArrow(canvas, values.lateral_in_target_mm, ring_mm);
}

ProjectedGuide::ProjectedGuide(const cameras::ProjectorModel& projector, const surface::TriangleMesh& scalp,
                               const guidance::CoilPlate& plate)
    : implementation_(std::make_unique<Implementation>(
          Implementation{projector, makeAlignedSkin(scalp, {}), plate, {}, {}, 0})) {}
ProjectedGuide::~ProjectedGuide() = default;
ProjectedGuide::ProjectedGuide(ProjectedGuide&&) noexcept = default;

double ProjectedGuide::ringLit() const { return implementation_->ring_lit; }

const cameras::ProjectorModel& ProjectedGuide::projector() const { return implementation_->projector; }

RgbImage ProjectedGuide::black() const {
  return RgbImage(implementation_->projector.width_px, implementation_->projector.height_px);
}

RgbImage ProjectedGuide::draw(const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri,
                              const guidance::Target& target, const guidance::GuidanceState& state) {
  auto& all = *implementation_;
  all.ring_lit = 0;
  if (!camera_T_mri) return black();
  if (!all.target || !isSame(*all.target, target)) {
    all.target = target;
    all.under.emplace(all.skin.mesh, target.mri_T_target.inverse().isometry());
  }
  const auto projector_T_mri = (all.projector.projector_T_camera * *camera_T_mri).isometry();
  const cv::Size size(all.projector.width_px, all.projector.height_px);
  const SkinDepth depth(all.skin.mesh, projector_T_mri, all.projector.lens, size, kLitStep_px);
  const Eigen::Vector3d middle = projector_T_mri * target.scalp_point.mm;
  if (middle.z() < 50) return black();
  Implementation::Canvas canvas{
      cv::Mat::zeros(size, CV_8UC3), projector_T_mri * target.mri_T_target.isometry(), depth,
      std::max(0.0, guidance::hairGap_mm(target)), all.projector.lens.k(0, 0) / middle.z()};
  all.ring_lit = all.litShare(canvas, circle(kRing_mm));
  all.drawPlace(canvas, state.values && state.state == guidance::State::on_target);
  if (state.values) all.drawWay(canvas, state);
  return toRgb(canvas.image);
}

}  // namespace facenav::pictures
