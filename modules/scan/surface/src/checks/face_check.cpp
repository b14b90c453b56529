#include "face_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "facenav/anatomy/face_norms.h"
#include "facenav/anatomy/nose.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::surface {
namespace {

using anatomy::FrontRelief;
using anatomy::NoseRise;

/// The front of the head, rows from the top down, and the column of its midline.
struct Front {
  static constexpr double kCell_mm = 2.5;
  FrontRelief relief;
  int midline;

  explicit Front(const TriangleMesh& scalp)
      : relief(scalp.vertices_mm, {kCell_mm, FrontRelief::FirstRow::top}), midline(midlineColumn(relief)) {}
  double at(int row, int column) const { return relief.at(row, column); }
  int rows() const { return relief.rows(); }
  int cells(double mm) const { return relief.cells(mm); }
  double side(int row, double beside_mm) const { return sides_mm(relief, midline, row, beside_mm); }
  double prominence(int row) const { return prominence_mm(relief, midline, row); }
};

/// True if `column` falls back by more than 8 mm within 5 mm below `row`, without coming forward again. An
/// eye socket also falls back, but the cheek below it comes forward by at least a third of that.
bool isLedge(const Front& front, int row, int column) {
  const double above = front.at(row, column), below = front.at(row + 2, column);
  if (above <= FrontRelief::kNone || below <= FrontRelief::kNone || above - below <= 8) return false;
  double foremost = below;
  for (int next = row + 3; next <= row + front.cells(30); ++next)
    foremost = std::max(foremost, front.at(next, column));
  return foremost < below + (above - below) / 3;
}

/// Fraction of the columns 20 to 45 mm beside the midline with a ledge between `from_row` and `to_row`, on
/// the side with fewer: defacing cuts both sides, a turned head shows the ledge of one brow.
double ledgeShare(const Front& front, int from_row, int to_row) {
  int with[2] = {0, 0};
  for (const int side : {0, 1})
    for (int c = front.cells(20); c <= front.cells(45); ++c)
      for (int row = from_row; row + 2 <= to_row; ++row)
        if (isLedge(front, row, front.midline + (side ? c : -c))) {
          ++with[side];
          break;
        }
  return double(std::min(with[0], with[1])) / (front.cells(45) - front.cells(20) + 1);
}

/// Median |left - right| 20 to 40 mm beside the midline, relative to the same on the forehead above, mm.
double unevenness(const Front& front, int root_row) {
  std::vector<double> differences;
  for (int k = front.cells(20); k <= front.cells(40); ++k) {
    const auto difference = [&](int row) {
      return front.at(row, front.midline - k) - front.at(row, front.midline + k);
    };
    const double turn = difference(std::max(0, root_row - front.cells(35)));
    for (int row = root_row - front.cells(5); row <= root_row + front.cells(35); ++row)
      if (front.at(row, front.midline - k) > FrontRelief::kNone &&
          front.at(row, front.midline + k) > FrontRelief::kNone)
        differences.push_back(std::abs(difference(row) - turn));
  }
  return upperMedian(std::move(differences));
}

/// Depth of the eyes behind the brow, mm.
double socketDepth(const Front& front, const NoseRise& nose) {
  double brow = FrontRelief::kNone, eye = -FrontRelief::kNone;
  for (int row = nose.root_row - front.cells(30); row <= nose.root_row + front.cells(5); ++row)
    brow = std::max(brow, front.side(row, 32));
  for (int row = nose.root_row - front.cells(5); row <= nose.root_row + front.cells(25); ++row) {
    const double here = front.side(row, 32);
    if (here > FrontRelief::kNone) eye = std::min(eye, here);
  }
  return brow > FrontRelief::kNone && eye < -FrontRelief::kNone ? brow - eye : 0.0;
}

/// The lowest row with skin in the middle of the face.
int lowestRow(const Front& front) {
  for (int row = front.rows() - 1; row >= 0; --row)
    if (front.prominence(row) > FrontRelief::kNone || front.side(row, 30) > FrontRelief::kNone) return row;
  return 0;
}

/// Parts of the face that the scan's edges cut.
struct Cuts {
  bool has_nose = false, has_ear = false, has_forehead = false;
};
Cuts findCuts(const TriangleMesh& scalp, const MeshNeighbours& neighbours, const volume::VoxelGrid& grid,
              const Front& front, const NoseRise& nose) {
  int at_nose = 0, at_forehead = 0, at_ear = 0;
  const double root_z = front.relief.z_mm(nose.root_row), middle_x = front.relief.x_mm(front.midline);
  for (std::size_t v = 0; v < scalp.vertices_mm.size(); ++v) {
    if (!neighbours.on_border[v]) continue;
    const Eigen::Vector3d& p = scalp.vertices_mm[v];
    const Eigen::Vector3d ijk = grid.toVoxel(Point<Mri>(p));
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d across = grid.mri_from_voxel.linear().col(axis).normalized();
      const bool is_end = ijk[axis] < 0.6 || ijk[axis] > grid.size[axis] - 1.6;
      if (!is_end) continue;
      const bool is_frontal = std::abs(across.y()) > 0.7, is_lateral = std::abs(across.x()) > 0.7;
      const bool is_middle = std::abs(p.x() - middle_x) < 22;
      if (is_frontal && is_middle && p.z() < root_z && p.z() > root_z - 60) ++at_nose;
      if (is_frontal && p.z() > root_z) ++at_forehead;
      if (is_lateral && p.z() < root_z + 30) ++at_ear;
    }
  }
  return {at_nose > 5, at_ear > 10, at_forehead > 5};
}

/// The row where the nose ends above the lip: the prominence has fallen to three quarters. nullopt if the
/// scan ends above it.
std::optional<int> noseBase(const Front& front, const NoseRise& nose, int last_row) {
  const double crest = front.prominence(nose.crest_row);
  for (int row = nose.crest_row + 1; row <= last_row - front.cells(5); ++row)
    if (const double here = front.prominence(row); here > FrontRelief::kNone && here < 0.75 * crest)
      return row;
  return std::nullopt;
}

/// Describes how much of the face lies above the scan's lower end.
std::string describeEnd(const Front& front, const NoseRise& nose) {
  const int last = lowestRow(front);
  const auto base = noseBase(front, nose, last);
  const std::string rest = ", points of the face below are not used";
  if (!base) return "the scan ends at mid-nose: alignment rests on forehead, brow and eyes" + rest;
  const double below_nose_mm = (last - *base) * Front::kCell_mm;
  if (below_nose_mm < 25) return "the scan ends at the upper lip" + rest;
  return below_nose_mm < 55 ? "the scan ends above the chin" + rest : "";
}

}  // namespace

FaceCheck checkFace(const TriangleMesh& scalp, const MeshNeighbours& neighbours,
                    const volume::VoxelGrid& grid) {
  constexpr double kMostLedges = 0.3;  // fitted: with the face cut away, most columns have a ledge
  FaceCheck check;
  const Front front(scalp);
  const auto nose = findNoseRise(front.relief, front.midline);
  const bool has_nose = nose && anatomy::kNoseRise.contains(nose->rise_mm);
  const int last = has_nose ? std::min(front.rows() - 1, nose->root_row + front.cells(35))
                            : front.rows() - 1 - front.cells(20);
  const bool is_ledged = ledgeShare(front, front.cells(45), last) > kMostLedges;
  const bool is_uneven = has_nose && unevenness(front, nose->root_row) > anatomy::kUnevenFace.high;
  const bool has_sockets = has_nose && socketDepth(front, *nose) > anatomy::kSocketDepth.low;
  if (is_ledged || is_uneven) {
    check.findings.push_back(
        "the face was removed below the brow (a defaced scan): there is no face to align to");
    return check;
  }
  if (!has_nose || !has_sockets) {
    check.findings.push_back(front.rows() * Front::kCell_mm < 140
                                 ? "the scan ends above the nose: there is no face to align to"
                                 : "no nose and eye sockets found (removed, blurred or shaved off?): there "
                                   "is no face to align to");
    return check;
  }
  check.has_face = true;
  if (const std::string end = describeEnd(front, *nose); !end.empty()) check.findings.push_back(end);
  const Cuts cuts = findCuts(scalp, neighbours, grid, front, *nose);
  if (cuts.has_nose) check.findings.push_back("the nose tip is cut by the scan's edge");
  if (cuts.has_forehead) check.findings.push_back("the forehead touches the scan's edge");
  check.has_cut_ear = cuts.has_ear;
  if (cuts.has_ear) check.findings.push_back("an ear is cut by the scan's edge");
  return check;
}

}  // namespace facenav::surface
