#include "facenav/surface/face_landmarks.h"

#include <algorithm>
#include <cmath>

#include "facenav/anatomy/lateral_landmarks.h"
#include "facenav/anatomy/midline_profile.h"
#include "head_frame.h"
#include "scalp/scalp_outline.h"

namespace facenav::surface {
namespace {

using anatomy::MaybePoint;
using anatomy::MidlineLandmarks;
using anatomy::Side;
using anatomy::SkinRelief;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Errors of placing a landmark on a surface, mm along a typical measure: the spread of repeated placing in
/// photogrammetry and on MRI skin (0.5-1.5 mm for points on the midline and the eyes' inner corners, 2-3 mm
/// for those on smooth skin).
constexpr double kSharp_mm = 1.0, kFair_mm = 1.5, kSmooth_mm = 2.5;
/// Error of the inion, which is a bend here, and often no bump (midline_profile.h). On Colin27 it lies 18 mm
/// above the published place.
constexpr double kInion_mm = 15.0;

std::vector<Vector3d> inHead(const Eigen::Isometry3d& frame, const TriangleMesh& mesh) {
  std::vector<Vector3d> points;
  for (const auto& v : mesh.vertices_mm) points.push_back(frame * v);
  return points;
}

class LandmarkFinder {
 public:
  explicit LandmarkFinder(const ScalpSurface& scalp) : scalp_(scalp), frame_(symmetryFrame(scalp.mesh)) {
    const auto on_border = neighboursOf(scalp.mesh).on_border;
    for (std::size_t v = 0; v < on_border.size(); ++v)
      if (on_border[v]) border_mm_.push_back(scalp.mesh.vertices_mm[v]);
  }

  FaceLandmarks find() {
    MidlineLandmarks middle;
    for (int round = 0; round < 3; ++round) {  // the first outline may nod; later ones are level
      head_mm_ = inHead(frame_, scalp_.mesh);
      middle = anatomy::midlineLandmarks(anatomy::midlineProfile(head_mm_, scalp_.mesh.triangles));
      if (!middle.nasion || !middle.opisthocranion) return {};
      const Vector2d forward = middle.glabella.value_or(*middle.nasion) - *middle.opisthocranion;
      if (round < 2) frame_ = pitched(frame_, {0, forward.x(), forward.y()});
    }
    addMidline(middle);
    addEyesAndNose(middle);
    addSides(*middle.nasion);
    if (middle.glabella) measureCircumference(*middle.glabella, *middle.opisthocranion);
    const Eigen::Matrix3d axes = frame_.linear().transpose();
    found_.right = Direction<Mri>(axes.col(0));
    found_.front = Direction<Mri>(axes.col(1));
    found_.up = Direction<Mri>(axes.col(2));
    return std::move(found_);
  }

 private:
  /// True on the scan's edge, or beside a hole that it cuts into the skin.
  bool isCut(const Vector3d& p_mri_mm) const {
    constexpr double kNearPlane_mm = 2.0, kNearHole_mm = 8.0;
    return std::any_of(scalp_.field_of_view.begin(), scalp_.field_of_view.end(),
                       [&](const auto& plane) {
                         return plane.second.v.dot(p_mri_mm - plane.first.mm) > -kNearPlane_mm;
                       }) ||
           std::any_of(border_mm_.begin(), border_mm_.end(), [&](const Vector3d& q) {
             return (q - p_mri_mm).squaredNorm() < kNearHole_mm * kNearHole_mm;
           });
  }

  void add(const std::string& name, const MaybePoint& p_head_mm, double sd_mm) {
    if (!p_head_mm) return;
    const Vector3d p_mri_mm = frame_.inverse() * *p_head_mm;
    found_.points.push_back({name, Point<Mri>(p_mri_mm), sd_mm, isCut(p_mri_mm)});
  }
  static MaybePoint onMidline(const std::optional<Vector2d>& p) {
    return p ? MaybePoint(Vector3d(0, p->x(), p->y())) : std::nullopt;
  }

  void addMidline(const MidlineLandmarks& middle) {
    add("glabella", onMidline(middle.glabella), kSmooth_mm);
    add("nasion", onMidline(middle.nasion), kFair_mm);
    add("pronasale", onMidline(middle.pronasale), kSharp_mm);
    add("subnasale", onMidline(middle.subnasale), kSharp_mm);
    add("pogonion", onMidline(middle.pogonion), kSmooth_mm);
    add("opisthocranion", onMidline(middle.opisthocranion), kFair_mm);
    add("inion", onMidline(middle.inion), kInion_mm);
  }

  void addEyesAndNose(const MidlineLandmarks& middle) {
    const SkinRelief front =
        anatomy::smoothed(anatomy::reliefFrom(Side::front, head_mm_, scalp_.mesh.triangles), 1.5);
    for (const int side : {1, -1}) {
      const std::string end = side > 0 ? " R" : " L";
      const anatomy::EyeLandmarks eye = anatomy::findEye(front, *onMidline(middle.nasion), side);
      add("endocanthion" + end, eye.inner_corner, kFair_mm);
      add("lid centre" + end, eye.lid_centre, kSmooth_mm);
      if (middle.subnasale)
        add("alare" + end, anatomy::findAla(front, *onMidline(middle.subnasale), side), kSharp_mm);
    }
  }

  /// Adds tragi, and the widest points of face (in front of the ears, below the eyes) and head (above the
  /// ears).
  void addSides(const Vector2d& nasion) {
    const SkinRelief right = anatomy::reliefFrom(Side::right, head_mm_, scalp_.mesh.triangles);
    const SkinRelief left = anatomy::reliefFrom(Side::left, head_mm_, scalp_.mesh.triangles);
    const Vector3d root(0, nasion.x(), nasion.y());
    addTragi(anatomy::findTragus(right, root, 1), anatomy::findTragus(left, root, -1));
    addWidest("zygion", right, left, {nasion.x() - 68, nasion.x() - 35}, {nasion.y() - 50, nasion.y() - 5});
    addWidest("euryon", right, left, {nasion.x() - 150, nasion.x() - 40}, {nasion.y() + 40, nasion.y() + 95});
  }

  /// Adds both tragi or none: only symmetry distinguishes an ear from a headrest or a hair band. An ear cut
  /// by the scan's edge shows false hollows.
  void addTragi(const MaybePoint& right, const MaybePoint& left) {
    constexpr double kSkew_mm = 12;
    if (!right || !left || (right->tail<2>() - left->tail<2>()).norm() > kSkew_mm) return;
    for (const auto& p : {*right, *left})
      if (isCut(frame_.inverse() * p)) return;
    add("tragion R", right, kSmooth_mm);
    add("tragion L", left, kSmooth_mm);
  }

  void addWidest(const std::string& name, const SkinRelief& right, const SkinRelief& left,
                 const Vector2d& y_range_mm, const Vector2d& z_range_mm) {
    double widest_mm = 0;
    MaybePoint a, b;
    for (double z = z_range_mm[0]; z <= z_range_mm[1]; z += 1)
      for (double y = y_range_mm[0]; y <= y_range_mm[1]; y += 1) {
        const auto r = right.at(y, z), l = left.at(y, z);
        if (!r || !l || *r + *l <= widest_mm) continue;
        widest_mm = *r + *l;
        a = Vector3d(*r, y, z);
        b = Vector3d(-*l, y, z);
      }
    add(name + " R", a, kSharp_mm);
    add(name + " L", b, kSharp_mm);
  }

  /// Length of the convex hull of the skin's cut with the plane through both points and the head's x axis.
  void measureCircumference(const Vector2d& front, const Vector2d& back) {
    const Vector2d along = (front - back).normalized(), up(-along.y(), along.x());
    std::vector<Vector2d> points;
    for (const auto& t : scalp_.mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        const Vector3d &p = head_mm_[std::size_t(t[k])], &q = head_mm_[std::size_t(t[(k + 1) % 3])];
        const double a = up.dot(p.tail<2>() - back), b = up.dot(q.tail<2>() - back);
        if ((a < 0) == (b < 0)) continue;
        const Vector3d cut = p + (q - p) * (a / (a - b));
        points.push_back({cut.x(), along.dot(cut.tail<2>() - back)});
        found_.is_circumference_cut |= isCut(frame_.inverse() * cut);
      }
    found_.circumference_mm = hullPerimeter(std::move(points));
  }

  static std::optional<double> hullPerimeter(std::vector<Vector2d> points) {  // Andrew's monotone chain
    if (points.size() < 3) return std::nullopt;
    std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
      return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    double perimeter_mm = 0;
    for (int half = 0; half < 2; ++half) {
      std::vector<Vector2d> hull;
      for (const Vector2d& p : points) {
        while (hull.size() > 1) {
          const Vector2d u = hull.back() - hull[hull.size() - 2], v = p - hull.back();
          if (u.x() * v.y() - u.y() * v.x() > 0) break;
          hull.pop_back();
        }
        hull.push_back(p);
      }
      for (std::size_t i = 1; i < hull.size(); ++i) perimeter_mm += (hull[i] - hull[i - 1]).norm();
      std::reverse(points.begin(), points.end());
    }
    return perimeter_mm;
  }

  const ScalpSurface& scalp_;
  Eigen::Isometry3d frame_;
  std::vector<Vector3d> head_mm_, border_mm_;
  FaceLandmarks found_;
};

}  // namespace

std::optional<FaceLandmark> FaceLandmarks::find(const std::string& name) const {
  for (const auto& landmark : points)
    if (landmark.name == name) return landmark;
  return std::nullopt;
}

FaceLandmarks findFaceLandmarks(const ScalpSurface& scalp) {
  if (scalp.mesh.triangles.empty()) return {};
  return LandmarkFinder(scalp).find();
}

}  // namespace facenav::surface
