#include "face_check.h"

#include <algorithm>
#include <cmath>

#include "face_relief.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::surface {
namespace {

int cells(double mm) { return int(std::lround(mm / FaceRelief::kCell_mm)); }

/// Mean of both sides at `mm` from the midline; kNone where one has no skin.
float side(const FaceRelief& relief, int row, double mm) {
  const float a = relief.at(row, relief.midline - cells(mm)), b = relief.at(row, relief.midline + cells(mm));
  return a > FaceRelief::kNone && b > FaceRelief::kNone ? 0.5f * (a + b) : FaceRelief::kNone;
}

/// How far the middle stands out before both sides 30 mm away; kNone where unknown.
float prominence(const FaceRelief& relief, int row) {
  float middle = FaceRelief::kNone;
  for (int c = -cells(10); c <= cells(10); ++c) middle = std::max(middle, relief.at(row, relief.midline + c));
  const float sides = side(relief, row, 30);
  return middle > FaceRelief::kNone && sides > FaceRelief::kNone ? middle - sides : FaceRelief::kNone;
}

struct Nose {
  int root_row = -1;     // where the ridge begins to rise, between the eyes
  int crest_row = -1;    // where it stands out most
  double rise_mm = 0.0;  // by how much more than the forehead does
};

/// The strongest rise of the prominence within a nose's length, below the forehead.
Nose findNose(const FaceRelief& relief) {
  Nose best;
  for (int root = cells(50); root < relief.rows; ++root) {
    const float at_root = prominence(relief, root);
    if (at_root <= FaceRelief::kNone) continue;
    for (int crest = root + cells(8); crest <= std::min(root + cells(45), relief.rows - 1); ++crest) {
      const float there = prominence(relief, crest);
      if (there > FaceRelief::kNone && there - at_root > best.rise_mm + 0.5)
        best = {root, crest, there - at_root};
    }
    // The first nose from above counts: mouth and chin stand out, too.
    if (best.rise_mm > 12 && root > best.crest_row) break;
  }
  return best;
}

/// Does `column` fall back by more than 8 mm within 5 mm below `row`, and stay back? An eye socket falls
/// back, too, but the cheek below it comes forward again by a third of that at least.
bool isLedge(const FaceRelief& relief, int row, int column) {
  const float above = relief.at(row, column), below = relief.at(row + 2, column);
  if (above <= FaceRelief::kNone || below <= FaceRelief::kNone || above - below <= 8) return false;
  float foremost = below;
  for (int next = row + 3; next <= row + cells(30); ++next)
    foremost = std::max(foremost, relief.at(next, column));
  return foremost < below + (above - below) / 3;
}

/// Share of the columns 20 to 45 mm beside the midline that have a ledge between `from_row` and `to_row`, on
/// the side with fewer: defacing cuts across both, a turned head shows the ledge of one brow.
double ledgeShare(const FaceRelief& relief, int from_row, int to_row) {
  int with[2] = {0, 0};
  for (const int side : {0, 1})
    for (int c = cells(20); c <= cells(45); ++c)
      for (int row = from_row; row + 2 <= to_row; ++row)
        if (isLedge(relief, row, relief.midline + (side ? c : -c))) {
          ++with[side];
          break;
        }
  return double(std::min(with[0], with[1])) / (cells(45) - cells(20) + 1);
}

/// Median |left - right| 20 to 40 mm beside the midline against the same on the forehead above, mm.
double unevenness(const FaceRelief& relief, int root_row) {
  std::vector<float> differences;
  for (int k = cells(20); k <= cells(40); ++k) {
    const auto difference = [&](int row) {
      return relief.at(row, relief.midline - k) - relief.at(row, relief.midline + k);
    };
    const float turn = difference(std::max(0, root_row - cells(35)));
    for (int row = root_row - cells(5); row <= root_row + cells(35); ++row)
      if (relief.at(row, relief.midline - k) > FaceRelief::kNone &&
          relief.at(row, relief.midline + k) > FaceRelief::kNone)
        differences.push_back(std::abs(difference(row) - turn));
  }
  return upperMedian(std::move(differences));
}

/// How deep the eyes lie behind the brow, mm.
double socketDepth(const FaceRelief& relief, const Nose& nose) {
  float brow = FaceRelief::kNone, eye = -FaceRelief::kNone;
  for (int row = nose.root_row - cells(30); row <= nose.root_row + cells(5); ++row)
    brow = std::max(brow, side(relief, row, 32));
  for (int row = nose.root_row - cells(5); row <= nose.root_row + cells(25); ++row) {
    const float here = side(relief, row, 32);
    if (here > FaceRelief::kNone) eye = std::min(eye, here);
  }
  return brow > FaceRelief::kNone && eye < -FaceRelief::kNone ? brow - eye : 0.0;
}

/// The lowest row with skin in the middle of the face.
int lowestRow(const FaceRelief& relief) {
  for (int row = relief.rows - 1; row >= 0; --row)
    if (prominence(relief, row) > FaceRelief::kNone || side(relief, row, 30) > FaceRelief::kNone) return row;
  return 0;
}

/// Open edges of the mesh in front of the face (the nose) and at the sides (the ears).
struct Cuts {
  bool has_nose = false, has_ear = false, has_forehead = false;
};
Cuts findCuts(const TriangleMesh& scalp, const MeshNeighbours& neighbours, const volume::VoxelGrid& grid,
              const FaceRelief& relief, const Nose& nose) {
  int at_nose = 0, at_forehead = 0, at_ear = 0;
  const double root_z = relief.z_mm(nose.root_row), middle_x = relief.x_mm(relief.midline);
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

/// The row where the nose ends above the lip: the prominence has fallen to three quarters; -1 where the scan
/// ends first.
int noseBase(const FaceRelief& relief, const Nose& nose, int last_row) {
  const float crest = prominence(relief, nose.crest_row);
  for (int row = nose.crest_row + 1; row <= last_row - cells(5); ++row)
    if (const float here = prominence(relief, row); here > FaceRelief::kNone && here < 0.75f * crest)
      return row;
  return -1;
}

/// How much of the face lies above the scan's lower end.
std::string describeEnd(const FaceRelief& relief, const Nose& nose) {
  const int last = lowestRow(relief), base = noseBase(relief, nose, last);
  const std::string rest = ", points of the face below are not used";
  if (base < 0) return "the scan ends at mid-nose: alignment rests on forehead, brow and eyes" + rest;
  const double below_nose_mm = (last - base) * FaceRelief::kCell_mm;
  if (below_nose_mm < 25) return "the scan ends at the upper lip" + rest;
  return below_nose_mm < 55 ? "the scan ends above the chin" + rest : "";
}

}  // namespace

FaceCheck checkFace(const TriangleMesh& scalp, const MeshNeighbours& neighbours,
                    const volume::VoxelGrid& grid) {
  // From heads at hand: the nose rises by 17 to 22 mm, eyes lie 11 to 17 mm behind the brow, sides differ by
  // 1 to 3 mm; a face cut away leaves ledges in most columns and sides that differ by 9 mm.
  constexpr double kLeastRise_mm = 8, kLeastSocket_mm = 2.5, kMostLedges = 0.3, kMostUneven_mm = 6;
  FaceCheck check;
  const FaceRelief relief = reliefOf(scalp);
  const Nose nose = findNose(relief);
  const bool has_nose = nose.rise_mm >= kLeastRise_mm;
  const int last =
      has_nose ? std::min(relief.rows - 1, nose.root_row + cells(35)) : relief.rows - 1 - cells(20);
  const bool is_ledged = ledgeShare(relief, cells(45), last) > kMostLedges;
  const bool is_uneven = has_nose && unevenness(relief, nose.root_row) > kMostUneven_mm;
  const bool has_sockets = has_nose && socketDepth(relief, nose) > kLeastSocket_mm;
  if (is_ledged || is_uneven) {
    check.findings.push_back(
        "the face was removed below the brow (a defaced scan): there is no face to align to");
    return check;
  }
  if (!has_nose || !has_sockets) {
    check.findings.push_back(relief.rows * FaceRelief::kCell_mm < 140
                                 ? "the scan ends above the nose: there is no face to align to"
                                 : "no nose and eye sockets found (removed, blurred or shaved off?): there "
                                   "is no face to align to");
    return check;
  }
  check.has_face = true;
  if (const std::string end = describeEnd(relief, nose); !end.empty()) check.findings.push_back(end);
  const Cuts cuts = findCuts(scalp, neighbours, grid, relief, nose);
  if (cuts.has_nose) check.findings.push_back("the nose tip is cut by the scan's edge");
  if (cuts.has_forehead) check.findings.push_back("the forehead touches the scan's edge");
  if (cuts.has_ear) check.findings.push_back("an ear is cut by the scan's edge");
  return check;
}

}  // namespace facenav::surface
