#include "modes/training_sources.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "facenav/core/error.h"
#include "facenav/surface/closest_point.h"
#include "model/shell_surface.h"

namespace facenav::efield {
namespace {

using Eigen::Vector3d;

// Off the scalp. The far end of a flat coil's wing lies some 50 mm off a round head.
constexpr double kLeastOff_mm = 10.0, kMoreOff_mm = 50.0;
constexpr double kPatchRadius_mm = 18.0;
constexpr double kTilt = 0.3;  // tangent of a patch's largest tilt against the scalp, about
constexpr int kPatch = 7;      // dipoles of a patch: its middle and a ring

/// Writes a patch of dipoles along `moment` about `middle`.
void writePatch(const Vector3d& middle, const Vector3d& moment, Eigen::Index first, DipoleArray& dipoles) {
  const Vector3d x = moment.unitOrthogonal(), y = moment.cross(x);
  for (int i = 0; i < kPatch; ++i) {
    const double turn = i * M_PI / 3, radius_mm = i == 0 ? 0.0 : kPatchRadius_mm;
    const Vector3d place = middle + radius_mm * (std::cos(turn) * x + std::sin(turn) * y);
    dipoles.positions_mm.col(first + i) = place.cast<float>();
    dipoles.moments.col(first + i) = moment.cast<float>();
  }
}

/// True if all dipoles of the patch lie off the skin: a nose, an ear or a hollow neck may reach into it.
bool isOutside(const surface::ClosestPoint& scalp, const DipoleArray& dipoles, Eigen::Index first) {
  constexpr double kLeast_mm = 0.7 * kLeastOff_mm;
  for (int i = 0; i < kPatch; ++i) {
    const auto place = scalp.nearest(Point<Mri>(dipoles.positions_mm.col(first + i).cast<double>()));
    if (!place.is_outside || place.distance_mm < kLeast_mm) return false;
  }
  return true;
}

/// Draws a place on triangles, evenly by area.
class ScalpPlaces {
 public:
  ScalpPlaces(const ShellMesh& scalp, double lowest_z_mm) : scalp_(scalp) {
    for (Eigen::Index t = 0; t < scalp.triangles.cols(); ++t) {
      const Eigen::Matrix3d corners = cornersOf(t);
      if (corners.row(2).mean() < lowest_z_mm) continue;
      triangles_.push_back(t);
      areas_.push_back(areas_.back() +
                       (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).norm());
    }
    FACENAV_EXPECT(!triangles_.empty(), "a scalp above the brain's lower end");
  }
  struct Place {
    Vector3d at, normal;
  };
  /// `which`, `s`, `t`: random numbers 0 .. 1.
  Place draw(double which, double s, double t) const {
    const auto place = std::upper_bound(areas_.begin() + 1, areas_.end() - 1, which * areas_.back());
    const Eigen::Matrix3d c = cornersOf(triangles_[std::size_t(place - areas_.begin()) - 1]);
    const Vector3d along = c.col(1) - c.col(0), across = c.col(2) - c.col(0);
    if (s + t > 1) s = 1 - s, t = 1 - t;
    return {c.col(0) + s * along + t * across, along.cross(across).normalized()};
  }

 private:
  Eigen::Matrix3d cornersOf(Eigen::Index t) const {
    Eigen::Matrix3d corners;
    for (int c = 0; c < 3; ++c) corners.col(c) = scalp_.vertices_mm.col(scalp_.triangles(c, t));
    return corners;
  }

  const ShellMesh& scalp_;
  std::vector<Eigen::Index> triangles_;
  std::vector<double> areas_{0.0};  // sums
};

}  // namespace

SourceArray trainingSources(const ShellMesh& scalp, double lowest_z_mm, int count, unsigned seed) {
  const ScalpPlaces places(scalp, lowest_z_mm);
  std::mt19937 random(seed);
  const auto uniform = [&random] { return double(random() >> 8) / double(1 << 24); };
  SourceArray sources;
  sources.dipoles_each = kPatch;
  sources.dipoles.positions_mm.resize(3, kPatch * count);
  sources.dipoles.moments.resize(3, kPatch * count);
  const surface::ClosestPoint surface(triangleMesh(scalp));
  for (int i = 0, tries = 0; i < count; ++tries) {
    FACENAV_EXPECT(tries < 100 * count, "room for a coil outside the head");
    const double which = uniform(), s = uniform(), t = uniform();
    const auto place = places.draw(which, s, t);
    const double off_mm = kLeastOff_mm + kMoreOff_mm * std::pow(uniform(), 1.5);
    const double z = 2 * uniform() - 1, turn = 2 * M_PI * uniform(), r = std::sqrt(1 - z * z);
    const Vector3d tilt = kTilt * Vector3d(r * std::cos(turn), r * std::sin(turn), z);
    writePatch(place.at + off_mm * place.normal, (place.normal + tilt).normalized(), kPatch * i,
               sources.dipoles);
    if (isOutside(surface, sources.dipoles, kPatch * i)) ++i;
  }
  return sources;
}

}  // namespace facenav::efield
