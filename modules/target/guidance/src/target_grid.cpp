#include "facenav/guidance/target_grid.h"

#include <Eigen/Geometry>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/guidance/coil_plate.h"
#include "plate_geometry.h"

namespace facenav::guidance {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class GridLayer {
 public:
  GridLayer(const surface::ScalpPaths& paths, const surface::TriangleMesh& mesh, const GridSpec& grid)
      : paths_(paths), mesh_(mesh), grid_(grid) {}

  std::vector<GridPoint> lay(const Vector3d& seed_mm, const Matrix3d& axes) const {
    const GridPoint seed = at(seed_mm, -axes.col(2), axes.col(1));
    std::vector<GridPoint> points;
    for (int row = 1; row <= grid_.rows; ++row) {
      const GridPoint middle = moved(seed, seed.forward, (0.5 * (grid_.rows + 1) - row) * grid_.spacing_mm);
      for (int column = 1; column <= grid_.columns; ++column) {
        GridPoint point =
            moved(middle, left(middle), (0.5 * (grid_.columns + 1) - column) * grid_.spacing_mm);
        point.row = row;
        point.column = column;
        points.push_back(point);
      }
    }
    return points;
  }

 private:
  static Vector3d left(const GridPoint& p) { return p.outwards.cross(p.forward); }  // the coil's x

  /// Projects a point onto the surface. The result's normal is the mean one there; `outwards` gives its side.
  GridPoint at(const Vector3d& p_mm, const Vector3d& outwards, const Vector3d& forward) const {
    GridPoint point;
    point.place_mm = paths_.onSkin(p_mm).point.mm;
    Matrix3d axes;
    axes.col(2) = -outwards.normalized();
    axes.col(0) = axes.col(2).unitOrthogonal();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    point.outwards = normalRound(mesh_, axes, point.place_mm, 0.0, settingsOf<PlateRest>().patch_mm)
                         .value_or(Vector3d(outwards));
    point.forward = (forward - forward.dot(point.outwards) * point.outwards).normalized();
    return point;
  }

  /// Returns the point at the end of a tape of this length (< 0: backwards), with the handle's direction
  /// transported along.
  GridPoint moved(const GridPoint& from, const Vector3d& ahead, double length_mm) const {
    if (std::abs(length_mm) < 1e-9) return from;
    const double sign = length_mm > 0 ? 1.0 : -1.0;
    const auto tape = paths_.straight(from.place_mm, sign * ahead, from.outwards, std::abs(length_mm));
    const Vector3d before = sign * ahead, after = tape.direction(tape.length_mm());
    const Eigen::Quaterniond bend = rotationBetween(before, after);
    return at(tape.points_mm().back(), bend * from.outwards, bend * from.forward);
  }

  const surface::ScalpPaths& paths_;
  const surface::TriangleMesh& mesh_;
  const GridSpec& grid_;
};

}  // namespace

void requireSensible(const GridSpec& grid) {
  constexpr int kMost = 15;
  constexpr double kNearest_mm = 1, kFurthest_mm = 30;
  if (grid.rows < 1 || grid.columns < 1 || grid.rows > kMost || grid.columns > kMost ||
      grid.rows * grid.columns < 2)
    throw Error(formatted("a grid of %d x %d cannot be made", grid.rows, grid.columns), {},
                "give 1 to 15 rows and columns, and two places at least");
  if (!(grid.spacing_mm >= kNearest_mm && grid.spacing_mm <= kFurthest_mm))
    throw Error(formatted("a spacing of %g mm cannot be used", grid.spacing_mm), {}, "give 1 to 30 mm");
}

std::vector<GridPoint> gridRound(const surface::ScalpPaths& paths, const surface::TriangleMesh& mesh,
                                 const Vector3d& seed_mm, const Matrix3d& axes, const GridSpec& grid) {
  requireSensible(grid);
  return GridLayer(paths, mesh, grid).lay(seed_mm, axes);
}

}  // namespace facenav::guidance
