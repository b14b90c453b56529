#include "facenav/pictures/burnt_plan.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "drawn_words.h"
#include "facenav/core/error.h"

namespace facenav::pictures {
namespace {

using Eigen::Vector3d;

constexpr std::uint8_t kEdge = 1, kMark = 2;
constexpr double kFromCentre_mm = 4, kToEnd_mm = 14;  // arms of the cross: the place itself stays visible
constexpr double kMarkedHandle_mm = 60;               // drawn length of the handle
constexpr double kMarkDash_mm = 3;

/// Marks on a grid of voxels: none, black edge or white mark.
class Marks {
 public:
  explicit Marks(const volume::VoxelGrid& grid)
      : grid_(grid),
        voxel_from_mri_(grid.mri_from_voxel.inverse()),
        step_mm_(grid.spacing_mm()),
        radius_mm_(std::max(0.6, 0.6 * step_mm_.maxCoeff())),
        edge_mm_(radius_mm_ + step_mm_.maxCoeff()),
        marks_(grid.count(), 0) {}

  /// Draws a line of both ends' frame Mri; dashed lines have gaps as long as their dashes.
  void line(const Vector3d& from_mm, const Vector3d& to_mm, bool is_dashed = false) {
    const double length_mm = (to_mm - from_mm).norm(), step_mm = 0.4 * step_mm_.minCoeff();
    const int steps = std::max(1, int(std::ceil(length_mm / step_mm)));
    for (int s = 0; s <= steps; ++s) {
      const double share = double(s) / steps;
      if (is_dashed && int(share * length_mm / kMarkDash_mm) % 2 == 1) continue;
      dot(from_mm + share * (to_mm - from_mm));
    }
  }

  /// Draws words on slice `k`, their left lower corner at pixel (i, j).
  void write(const std::string& words, int k, int i, int j, double scale) {
    cv::Mat slice(grid_.size[1], grid_.size[0], CV_8U,
                  marks_.data() + grid_.index(0, 0, std::clamp(k, 0, grid_.size[2] - 1)));
    cv::Mat edge = cv::Mat::zeros(slice.size(), CV_8U), mark = edge.clone();
    drawFileWords(edge, words, {i, j}, letters(scale, kEdge, 3));
    drawFileWords(mark, words, {i, j}, letters(scale, kMark, 1));
    cv::max(slice, edge, slice);
    cv::max(slice, mark, slice);
  }
  static cv::Size sizeOf(const std::string& words, double scale) {
    return sizeOfWords(words, letters(scale, kMark, 1));
  }

  const std::vector<std::uint8_t>& values() const { return marks_; }

 private:
  static Letters letters(double scale, std::uint8_t mark, int thickness) {
    return {scale, cv::Scalar(mark), thickness, cv::FONT_HERSHEY_SIMPLEX, cv::LINE_8};
  }

  void dot(const Vector3d& p_mm) {
    const Vector3d at = voxel_from_mri_ * p_mm;
    int low[3], high[3];
    for (int a = 0; a < 3; ++a) {
      low[a] = std::max(0, int(std::ceil(at[a] - edge_mm_ / step_mm_[a])));
      high[a] = std::min(grid_.size[std::size_t(a)] - 1, int(std::floor(at[a] + edge_mm_ / step_mm_[a])));
    }
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int i = low[0]; i <= high[0]; ++i) {
          const double off_mm = (Vector3d(i, j, k) - at).cwiseProduct(step_mm_).norm();
          auto& mark = marks_[grid_.index(i, j, k)];
          if (off_mm <= edge_mm_) mark = std::max(mark, off_mm <= radius_mm_ ? kMark : kEdge);
        }
  }

  const volume::VoxelGrid& grid_;
  Eigen::Affine3d voxel_from_mri_;
  Vector3d step_mm_;
  double radius_mm_, edge_mm_;
  std::vector<std::uint8_t> marks_;
};

/// Draws six arms along the voxels' axes, so that a slice through the place shows an upright cross.
void markCross(Marks& marks, const volume::VoxelGrid& grid, const Vector3d& place_mm) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d along = grid.mri_from_voxel.linear().col(axis).normalized();
    for (const double side : {-1.0, 1.0})
      marks.line(place_mm + side * kFromCentre_mm * along, place_mm + side * kToEnd_mm * along);
  }
}

void markCoil(Marks& marks, const guidance::Target& target, const guidance::CoilPlate& plate) {
  const auto at = [&](double x, double y) {
    return (target.mri_T_target * Point<frames::Target>(x, y, 0)).mm;
  };
  const auto& outline = plate.outline_mm;
  for (std::size_t c = 0; c < outline.size(); ++c) {
    const auto& next = outline[(c + 1) % outline.size()];
    marks.line(at(outline[c].x(), outline[c].y()), at(next.x(), next.y()));
  }
  marks.line(at(0, 0), at(0, -kMarkedHandle_mm));
  const Vector3d centre_mm = at(0, 0), way_mm = target.cortex_point.mm - centre_mm;
  const double length_mm = way_mm.norm();
  if (length_mm > kFromCentre_mm)
    marks.line(centre_mm, centre_mm + (1 - kFromCentre_mm / length_mm) * way_mm, true);
}

void requireInside(const volume::VoxelGrid& grid, const guidance::Target& target) {
  const Vector3d at = grid.toVoxel(target.cortex_point);
  if (!grid.contains(int(std::lround(at[0])), int(std::lround(at[1])), int(std::lround(at[2]))))
    throw Error("the cortex point of '" + target.name + "' lies outside the MRI");
}

/// The voxels whose centres lie within `radius_mm` of a place; the one that holds it at least.
volume::Mask ballAt(const volume::VoxelGrid& grid, const Point<Mri>& place, double radius_mm) {
  volume::Mask ball{grid, std::vector<std::uint8_t>(grid.count(), 0)};
  const Vector3d at = grid.toVoxel(place), reach = radius_mm * grid.spacing_mm().cwiseInverse();
  int low[3], high[3], nearest[3];
  for (int a = 0; a < 3; ++a) {
    low[a] = std::max(0, int(std::ceil(at[a] - reach[a])));
    high[a] = std::min(grid.size[std::size_t(a)] - 1, int(std::floor(at[a] + reach[a])));
    nearest[a] = int(std::lround(at[a]));
  }
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i)
        ball.voxels[grid.index(i, j, k)] = (grid.toMri(Vector3d(i, j, k)).mm - place.mm).norm() <= radius_mm;
  ball.voxels[grid.index(nearest[0], nearest[1], nearest[2])] = 1;
  return ball;
}

/// Largest scale up to `most` in which the words fit into the width.
double scaleFor(const std::string& words, int width_px, double most) {
  const int needed_px = std::max(1, Marks::sizeOf(words, 1.0).width);
  return std::clamp(double(width_px) / needed_px, 0.2, most);
}

/// Writes the name beside the cross, on the slices that cut its arms across.
void markName(Marks& marks, const volume::VoxelGrid& grid, const guidance::Target& target) {
  const Vector3d at = grid.toVoxel(target.cortex_point), step_mm = grid.spacing_mm();
  const std::string& name = target.name;
  const double most = 0.4 * std::max(1.0, grid.size[0] / 256.0);
  const double scale = scaleFor(name, grid.size[0] / 2, most);
  const cv::Size size = Marks::sizeOf(name, scale);
  const double arm_px = (kToEnd_mm + 2) / step_mm[0];
  const bool is_right = at[0] + arm_px + size.width < grid.size[0];
  const int i = std::clamp(int(is_right ? at[0] + arm_px : at[0] - arm_px - size.width), 0, grid.size[0] - 1);
  const int j = std::clamp(int(at[1]) - 2, size.height + 1, std::max(size.height + 1, grid.size[1] - 2));
  const int reach = std::max(1, int(kFromCentre_mm / step_mm[2]));
  for (int k = int(std::lround(at[2])) - reach; k <= int(std::lround(at[2])) + reach; ++k)
    if (k >= 0 && k < grid.size[2]) marks.write(name, k, i, j, scale);
}

void markNotice(Marks& marks, const volume::VoxelGrid& grid) {
  const std::string notice = "FaceNav plan - NOT FOR DIAGNOSIS";
  const double scale = scaleFor(notice, grid.size[0] - 8, 0.4 * std::max(1.0, grid.size[0] / 256.0));
  for (int k = 0; k < grid.size[2]; ++k) marks.write(notice, k, 4, grid.size[1] - 5, scale);
}

}  // namespace

BurntPlan burnPlan(const volume::Volume& mri, const std::vector<guidance::Target>& targets,
                   const guidance::CoilPlate& plate) {
  Marks marks(mri.grid);
  for (const auto& target : targets) {
    requireInside(mri.grid, target);
    markCoil(marks, target, plate);
    markCross(marks, mri.grid, target.cortex_point.mm);
  }
  for (const auto& target : targets) markName(marks, mri.grid, target);
  markNotice(marks, mri.grid);
  BurntPlan burnt{mri, std::floor(percentile(mri, 0.01)), std::ceil(percentile(mri, 0.995))};
  burnt.white = std::max(burnt.white, burnt.black + 1);
  for (std::size_t v = 0; v < burnt.volume.voxels.size(); ++v)
    if (const auto mark = marks.values()[v]; mark != 0)
      burnt.volume.voxels[v] = mark == kMark ? burnt.white : burnt.black;
  return burnt;
}

std::vector<PlanMask> planMasks(const volume::VoxelGrid& grid, const std::vector<guidance::Target>& targets,
                                const guidance::CoilPlate& plate) {
  constexpr double kBall_mm = 5;
  std::vector<PlanMask> masks;
  for (const auto& target : targets) {
    requireInside(grid, target);
    masks.push_back({target.name, ballAt(grid, target.cortex_point, kBall_mm), false});
    Marks marks(grid);
    markCoil(marks, target, plate);
    volume::Mask coil{grid, std::vector<std::uint8_t>(grid.count(), 0)};
    for (std::size_t v = 0; v < coil.voxels.size(); ++v) coil.voxels[v] = marks.values()[v] == kMark;
    masks.push_back({"coil of " + target.name, std::move(coil), true});
  }
  return masks;
}

}  // namespace facenav::pictures
