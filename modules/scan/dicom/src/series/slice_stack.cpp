#include "slice_stack.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/rotation.h"

namespace facenav::dicom {
namespace {

constexpr double kSamePlace_mm = 0.01;
constexpr double kSpacingTolerance = 0.02;  // relative; scanners write positions with 2 to 7 decimals
constexpr double kSpacingTolerance_mm = 0.005;
constexpr double kLargestShear_rad = 0.1 * kRadPerDeg;
constexpr double kLargestSideStep_mm = 0.1;
constexpr double kFarOffPlace_mm = 0.05;  // least distance of a slice from its place that counts as an error
constexpr double kLargestDrift = 0.1;     // share of the spacing: distance of a slice from the even grid

using Axes = Eigen::Matrix<double, 3, 2>;

std::string millimetres(double value) { return formatted("%.4g mm", value); }

/// The fault in a single image's position, if any.
std::optional<StackFault> placeFault(const ImagePlace& place, const std::filesystem::path& file) {
  const auto fault = [&](const std::string& what) { return StackFault{what, file, "choose another series"}; };
  if (!place.unreadable.empty()) return fault(place.unreadable);
  if (!place.position_lps_mm) return fault("has no Image Position (Patient)");
  if (!place.axes_lps) return fault("has no Image Orientation (Patient)");
  if (!place.spacing_mm) return fault("has no Pixel Spacing");
  const Axes& axes = *place.axes_lps;
  if (!(std::abs(axes.col(0).norm() - 1) < 1e-2 && std::abs(axes.col(1).norm() - 1) < 1e-2 &&
        std::abs(axes.col(0).dot(axes.col(1))) < 1e-3))
    return fault("Image Orientation (Patient) is not two unit vectors at right angles");
  const Eigen::Vector2d& spacing = *place.spacing_mm;
  if (!(spacing.minCoeff() >= 0.01 && spacing.maxCoeff() <= 50))
    return fault("Pixel Spacing of " + millimetres(spacing.minCoeff()) + " is impossible");
  if (!(place.position_lps_mm->cwiseAbs().maxCoeff() < 1e5))
    return fault("Image Position (Patient) is impossible");
  return std::nullopt;
}

std::optional<StackFault> differenceFault(const SliceHeader& first, const SliceHeader& other,
                                          const ImagePlace& a, const ImagePlace& b) {
  const auto fault = [&](const std::string& what) {
    return StackFault{what + " than the other images of the series", other.file, "separate the series"};
  };
  if (first.voxels.rows != other.voxels.rows || first.voxels.columns != other.voxels.columns)
    return fault("has another matrix");
  if (!isSameOrientation(a, b)) return fault("has another orientation");
  if ((*a.spacing_mm - *b.spacing_mm).cwiseAbs().maxCoeff() > 1e-3 * a.spacing_mm->maxCoeff())
    return fault("has another Pixel Spacing");
  return std::nullopt;
}

struct Placed {
  ImageRef image;
  Eigen::Vector3d position_mm;
  double along_mm;
};

class Stacker {
 public:
  Stacker(const std::vector<SliceHeader>& headers, const std::vector<ImageRef>& images) : headers_(headers) {
    for (const ImageRef image : images) slices_.push_back({image, Eigen::Vector3d::Zero(), 0.0});
  }

  SliceStack stack() {
    SliceStack result;
    result.fault = checkEach();
    if (result.fault) return result;
    sortAlongNormal();
    dropCoincident(result);
    for (const Placed& slice : slices_) result.order.push_back(slice.image);
    if (slices_.size() < 2)
      result.fault = StackFault{"holds a single slice", fileOf(slices_[0]),
                                "choose a series with many slices", SeriesProblem::single_slice};
    if (!result.fault) result.fault = spacingFault();
    if (!result.fault) result.fault = lineFault();
    if (!result.fault) {
      result.note = chooseStep();
      result.grid = grid();
    }
    return result;
  }

 private:
  const std::filesystem::path& fileOf(const Placed& slice) const { return headers_[slice.image.header].file; }
  std::string nameOf(const Placed& slice) const { return fileOf(slice).filename().string(); }

  std::optional<StackFault> checkEach() {
    if (slices_.empty())
      return StackFault{"holds no image", {}, "choose another series", SeriesProblem::no_volume};
    const SliceHeader& first_header = headers_[slices_[0].image.header];
    const ImagePlace& first = placeOf(headers_, slices_[0].image);
    for (Placed& slice : slices_) {
      const ImagePlace& place = placeOf(headers_, slice.image);
      const SliceHeader& header = headers_[slice.image.header];
      if (auto fault = placeFault(place, header.file)) return fault;
      if (auto fault = differenceFault(first_header, header, first, place)) return fault;
      slice.position_mm = *place.position_lps_mm;
    }
    row_ = first.axes_lps->col(0).normalized();
    column_ = first.axes_lps->col(1).normalized();
    normal_ = row_.cross(column_).normalized();
    spacing_mm_ = *first.spacing_mm;
    return std::nullopt;
  }

  void sortAlongNormal() {
    for (Placed& slice : slices_) slice.along_mm = normal_.dot(slice.position_mm);
    std::stable_sort(slices_.begin(), slices_.end(),
                     [](const Placed& a, const Placed& b) { return a.along_mm < b.along_mm; });
  }

  void dropCoincident(SliceStack& result) {
    std::vector<Placed> kept;
    for (const Placed& slice : slices_) {
      if (!kept.empty() && slice.along_mm - kept.back().along_mm < kSamePlace_mm)
        result.coincident.push_back({kept.back().image, slice.image});
      else
        kept.push_back(slice);
    }
    slices_ = std::move(kept);
  }

  std::optional<StackFault> spacingFault() {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < slices_.size(); ++i)
      gaps.push_back(slices_[i].along_mm - slices_[i - 1].along_mm);
    const double usual_mm = upperMedian(gaps);
    if (usual_mm > 50)
      return StackFault{"slices lie " + millimetres(usual_mm) + " apart", fileOf(slices_[1]), ""};
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (std::abs(gaps[i] - usual_mm) <= kSpacingTolerance * usual_mm + kSpacingTolerance_mm) continue;
      const double missing = gaps[i] / usual_mm - 1;
      const bool is_missing = missing > 0.5 && std::abs(missing - std::round(missing)) < 0.1;
      const std::string between = nameOf(slices_[i]) + " and " + nameOf(slices_[i + 1]);
      const std::string what = is_missing ? formatted("%ld %s missing between ", std::lround(missing),
                                                      missing < 1.5 ? "slice is" : "slices are") +
                                                between
                                          : "unequal slice spacing: " + millimetres(gaps[i]) + " between " +
                                                between + ", " + millimetres(usual_mm) + " elsewhere";
      return StackFault{what, fileOf(slices_[i + 1]),
                        is_missing ? "copy the whole series again" : "choose another series",
                        is_missing ? SeriesProblem::damaged : SeriesProblem::geometry};
    }
    return std::nullopt;
  }

  std::optional<StackFault> lineFault() {
    const Placed &first = slices_.front(), &last = slices_.back();
    first_mm_ = first.position_mm;
    step_mm_ = (last.position_mm - first.position_mm) / double(slices_.size() - 1);
    const double shear_rad = std::atan2(step_mm_.cross(normal_).norm(), step_mm_.dot(normal_));
    if (shear_rad > kLargestShear_rad) {
      return StackFault{formatted("slices are sheared by %.3g degrees (gantry tilt)", shear_rad * kDegPerRad),
                        fileOf(first), "resample the series or scan without tilt"};
    }
    for (std::size_t i = 0; i < slices_.size(); ++i) {
      const Eigen::Vector3d off_mm = slices_[i].position_mm - first.position_mm - double(i) * step_mm_;
      const double along_mm = std::abs(normal_.dot(off_mm)),
                   aside_mm = (off_mm - normal_ * normal_.dot(off_mm)).norm();
      if (along_mm > std::max(kFarOffPlace_mm, kLargestDrift * step_mm_.norm()))
        return StackFault{
            "unequal slice spacing: slice lies " + millimetres(along_mm) + " off its place in an even stack",
            fileOf(slices_[i]), "choose another series"};
      if (aside_mm > kLargestSideStep_mm)
        return StackFault{"slice lies " + millimetres(aside_mm) + " beside the others", fileOf(slices_[i]),
                          "choose another series"};
    }
    return std::nullopt;
  }

  /// The step that dcm2niix takes for even slices: the gap between the two slices acquired first, in 32 bits,
  /// along the normal. It differs from the mean gap by micrometres, and puts voxels where dcm2niix puts them.
  /// If rounded positions would make this misplace a slice, the mean gap is used.
  std::string chooseStep() {
    const auto number = [&](const Placed& slice) { return headers_[slice.image.header].instance_number; };
    const bool is_backwards = number(slices_.front()) > number(slices_.back());
    const std::size_t last = slices_.size() - 1, anchor = is_backwards ? last : 0;
    const Eigen::Vector3f a = slices_[anchor].position_mm.cast<float>();
    const Eigen::Vector3f b = slices_[is_backwards ? last - 1 : 1].position_mm.cast<float>();
    const Eigen::Vector3d step_mm = normal_ * double((b - a).norm());
    const Eigen::Vector3d first_mm = slices_[anchor].position_mm - double(anchor) * step_mm;
    double worst_mm = 0;
    for (std::size_t i = 0; i <= last; ++i)
      worst_mm = std::max(worst_mm, (first_mm + double(i) * step_mm - slices_[i].position_mm).norm());
    if (worst_mm > kFarOffPlace_mm)
      return "slice positions are rounded; the mean spacing is used (dcm2niix continues the first gap, up "
             "to " +
             millimetres(worst_mm) + " off)";
    step_mm_ = step_mm;
    first_mm_ = first_mm;
    return {};
  }

  volume::VoxelGrid grid() const {
    const VoxelFormat& voxels = headers_[slices_[0].image.header].voxels;
    volume::VoxelGrid grid;
    grid.size = {voxels.columns, voxels.rows, int(slices_.size())};
    const Eigen::DiagonalMatrix<double, 3> ras_from_lps(-1, -1, 1);  // the only place where LPS becomes RAS
    Eigen::Matrix3d steps;
    steps << row_ * spacing_mm_[0], column_ * spacing_mm_[1], step_mm_;
    grid.mri_from_voxel.linear() = ras_from_lps * steps;
    grid.mri_from_voxel.translation() = ras_from_lps * first_mm_;
    return grid;
  }

  const std::vector<SliceHeader>& headers_;
  std::vector<Placed> slices_;
  Eigen::Vector3d row_, column_, normal_, step_mm_, first_mm_;
  Eigen::Vector2d spacing_mm_;
};

}  // namespace

const ImagePlace& placeOf(const std::vector<SliceHeader>& headers, ImageRef image) {
  return headers[std::size_t(image.header)].images[std::size_t(image.frame)];
}

bool isSameOrientation(const ImagePlace& a, const ImagePlace& b) {
  if (!a.axes_lps || !b.axes_lps) return !a.axes_lps && !b.axes_lps;
  return (*a.axes_lps - *b.axes_lps).cwiseAbs().maxCoeff() < 1e-3;
}

SliceStack stackSlices(const std::vector<SliceHeader>& headers, const std::vector<ImageRef>& images) {
  return Stacker(headers, images).stack();
}

}  // namespace facenav::dicom
