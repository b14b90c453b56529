#include "imported_field_checks.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/interop/check.h"
#include "facenav/interop/t1.h"
#include "facenav/surface/closest_point.h"
#include "same_image.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;

constexpr double kOnCortex_mm = 5;      // median distance of an imported field's points from the cortex
constexpr double kOffSkin_mm = 4;       // 90 % of the upper scalp: a shift of the head by as much shows there
constexpr std::size_t kChecked = 2000;  // points whose distance is measured
constexpr std::size_t kLeastChecked = 50;
constexpr double kSamePose_mm = 1, kSamePose_deg = 2, kOtherPose_mm = 10, kOtherPose_deg = 20;
constexpr double kWholeHead = 0.3;  // share of a volume's field outside the brain, if it is a whole head's

using Points = std::vector<Eigen::Vector3d>;

/// Distance from a surface that a share of the points does not exceed, mm.
double distanceOf(const Points& points_mm, const surface::TriangleMesh& mesh, double share) {
  const surface::ClosestPoint tree(mesh);
  std::vector<double> away_mm;
  const std::size_t step = std::max<std::size_t>(1, points_mm.size() / kChecked);
  for (std::size_t i = 0; i < points_mm.size(); i += step)
    away_mm.push_back(tree.nearest(Point<Mri>(points_mm[i])).distance_mm);
  const auto at = away_mm.begin() + long(share * double(away_mm.size() - 1));
  std::nth_element(away_mm.begin(), at, away_mm.end());
  return *at;
}

/// The points above the middle of the brain, where neck, face and ears do not reach.
Points upperPart(const Points& points_mm, const FieldSurfaces& surfaces) {
  double sum = 0;
  for (const auto& p : surfaces.skull_mm) sum += p.z();
  const double middle_mm = sum / double(std::max<std::size_t>(1, surfaces.skull_mm.size()));
  Points upper;
  std::copy_if(points_mm.begin(), points_mm.end(), std::back_inserter(upper),
               [&](const auto& p) { return p.z() > middle_mm; });
  return upper;
}

/// Throws Error if points of another program's skin are not on the case's one, allowing for its own steps.
std::string requireOnSkin(const casefile::CaseStore& store, const FieldSurfaces& surfaces,
                          const Points& scalp_mm, double steps_mm, const fs::path& file) {
  const Points upper = upperPart(scalp_mm, surfaces);
  if (upper.size() < kLeastChecked)
    throw Error("the field's head lies beside the case's head", file.string(),
                "import a field of this patient, in the coordinates of the case's MRI");
  const double off_mm = distanceOf(upper, store.scalp().mesh, 0.9);
  if (off_mm <= kOffSkin_mm + steps_mm)
    return formatted("90 %% of its scalp within %.1f mm of the case's skin", off_mm);
  throw Error(formatted("the field's head is not the case's: a tenth of its scalp lies more than %.1f mm off "
                        "the skin (%.1f allowed)",
                        off_mm, kOffSkin_mm + steps_mm),
              file.string(), "import a field of this patient, in the coordinates of the case's MRI");
}

/// Voxels with a field beside one without, from the outside: the outline of the head.
Points outlineOf(const volume::Volume& field) {
  Points outline;
  const auto& grid = field.grid;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j) {
      int first = -1, last = -1;
      for (int i = 0; i < grid.size[0]; ++i)
        if (field.at(i, j, k) > 0) first = first < 0 ? i : first, last = i;
      if (first > 0) outline.push_back(grid.toMri({double(first) - 0.5, double(j), double(k)}).mm);
      if (first >= 0 && last + 1 < grid.size[0])
        outline.push_back(grid.toMri({double(last) + 0.5, double(j), double(k)}).mm);
    }
  return outline;
}

/// True if the volume has a field in the whole head, not in the brain alone.
bool isWholeHead(const FieldImage& image, const FieldSurfaces& surfaces) {
  if (!surfaces.brain_mask) return true;
  const auto all = std::count_if(image.magnitude.voxels.begin(), image.magnitude.voxels.end(),
                                 [](float v) { return v > 0; });
  const auto in_brain = samplesIn(image, *surfaces.brain_mask).magnitude.size();
  return all > 0 && double(all - in_brain) > kWholeHead * double(all);
}

std::string sizeWords(const volume::VoxelGrid& grid) {
  const auto spacing = grid.spacing_mm();
  return formatted("%d x %d x %d voxels of %.2f x %.2f x %.2f mm", grid.size[0], grid.size[1], grid.size[2],
                   spacing.x(), spacing.y(), spacing.z());
}

/// Largest distance between the corners of two grids' outer faces, mm; both in one order of voxels.
double boxesApart_mm(const volume::VoxelGrid& a, const volume::VoxelGrid& b) {
  const auto cornerOf = [](const volume::VoxelGrid& grid, int corner) {
    Eigen::Vector3d ijk;
    for (int c = 0; c < 3; ++c) ijk[c] = (corner >> c & 1 ? grid.size[std::size_t(c)] : 0) - 0.5;
    return Eigen::Vector3d(grid.toMri(ijk).mm);
  };
  double apart_mm = 0;
  for (int corner = 0; corner < 8; ++corner)
    apart_mm = std::max(apart_mm, (cornerOf(a, corner) - cornerOf(b, corner)).norm());
  return apart_mm;
}

/// How the grid of a field's volume lies to that of the case's T1.
enum class GridMatch { same, same_box, other };
GridMatch matchOf(const volume::VoxelGrid& theirs, const volume::VoxelGrid& ours) {
  const auto a = interop::canonical(theirs), b = interop::canonical(ours);
  if (a.matches(b)) return GridMatch::same;
  const double voxel_mm = std::max(a.spacing_mm().maxCoeff(), b.spacing_mm().maxCoeff());
  return boxesApart_mm(a, b) <= voxel_mm ? GridMatch::same_box : GridMatch::other;
}

std::string inWords(GridMatch match) {
  if (match == GridMatch::same) return "its grid is that of the case's T1";
  return match == GridMatch::same_box ? "it covers the case's T1 with voxels of another size"
                                      : "its grid is not that of the case's T1";
}

std::string requireSameT1(const casefile::CaseStore& store, const FieldSurfaces& surfaces,
                          const FieldImage& image, const fs::path& file) {
  const auto ours = interop::readT1(store.folder() / "mri.nii.gz").grid;
  const auto& theirs = image.magnitude.grid;
  const GridMatch match = matchOf(theirs, ours);
  const bool has_skin = isWholeHead(image, surfaces);
  if (match != GridMatch::other && !has_skin) return inWords(match);
  if (!has_skin)
    throw Error("the field's T1 is not the case's: it has " + sizeWords(theirs) + ", the case's T1 " +
                    sizeWords(ours) + ", or another place",
                file.string(), "import the field that was computed from the case's T1");
  const std::string skin =
      requireOnSkin(store, surfaces, outlineOf(image.magnitude), 0.5 * theirs.spacing_mm().maxCoeff(), file);
  return inWords(match) + ", " + skin;
}

std::string requireNamedT1(const casefile::CaseStore& store, const fs::path& t1) {
  const auto ours = interop::readT1(store.folder() / "mri.nii.gz"), theirs = interop::readT1(t1);
  requireSameImage(store, theirs, ours);
  if (!interop::canonical(theirs.grid).matches(interop::canonical(ours.grid)))
    throw Error("the T1 of the field is not the case's: it has " + sizeWords(theirs.grid) +
                    ", the case's T1 " + sizeWords(ours.grid) + ", or another place",
                t1.string(), "import the field that was computed from the case's T1");
  return "the named T1 is the case's";
}

}  // namespace

double requireOnCortex(const Eigen::Matrix3Xd& points_mm, const surface::TriangleMesh& cortex,
                       const fs::path& file) {
  Points points;
  for (Eigen::Index i = 0; i < points_mm.cols(); ++i) points.emplace_back(points_mm.col(i));
  const double median_mm = points.empty() ? 0 : distanceOf(points, cortex, 0.5);
  if (points.empty() || !(median_mm <= kOnCortex_mm))
    throw Error(formatted("the field lies on another cortex: half of its points are more than %.0f mm away",
                          median_mm),
                file.string(), "import a field of this patient, in the coordinates of the case's MRI");
  return median_mm;
}

std::vector<std::string> checkedAgainst(const casefile::CaseStore& store, const FieldSurfaces& surfaces,
                                        const OtherField& other, const FieldImport& order) {
  std::vector<std::string> findings;
  if (!order.t1.empty()) findings.push_back(requireNamedT1(store, order.t1));
  if (other.image) {
    findings.push_back(requireSameT1(store, surfaces, *other.image, order.file));
  } else if (!other.samples.scalp_mm.empty()) {
    findings.push_back(requireOnSkin(store, surfaces, other.samples.scalp_mm, 0, order.file));
  } else {
    const double off_mm = requireOnCortex(other.samples.grey.points_mm, surfaces.cortex, order.file);
    findings.push_back(
        formatted("it has no scalp to check; half of its points within %.1f mm of the cortex", off_mm));
  }
  return findings;
}

std::vector<std::string> poseNotes(const guidance::Target& target, const fs::path& file) {
  const auto beside = poseBeside(file);
  if (!beside) return {"no file beside it tells the coil's pose: it is taken to be the target's"};
  const auto pose = interop::soundPose(*beside, nullptr);
  const auto error = poseError(pose, target.mri_T_target.reframe<Mri, Coil>());
  const double deg = error.rotation_rad * kDegPerRad;
  if (error.translation_mm > kOtherPose_mm || deg > kOtherPose_deg)
    throw Error(formatted("the field was computed for another pose: its coil stood %.1f mm and %.0f degrees "
                          "off that of '",
                          error.translation_mm, deg) +
                    target.name + "'",
                file.string(), "name the target that it was computed for");
  const std::string difference =
      formatted("its coil stood %.1f mm and %.1f degrees off the target's pose", error.translation_mm, deg);
  const bool is_same = error.translation_mm <= kSamePose_mm && deg <= kSamePose_deg;
  return {is_same ? difference : difference + ": the field is that of its own pose"};
}

}  // namespace facenav::steps
