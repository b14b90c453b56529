#pragma once
// The weights with which the samples of a patch are summed into its displacement: generalised least squares
// (Aitken 1935). Plain derivative images take every difference from the key frame for motion in proportion to
// the slope of brightness there, also shading that stays behind with the lamps while the skin turns beneath
// it (a highlight on dark or moist skin, the light on a dent). Here a difference may also be sensor noise, or
// shading: smooth over the patch and stronger where the skin is curved. What is smooth then counts for
// little, and the fine marks on the skin say how it moved. Made once for each key frame: tracking costs the
// same.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "patch_kernel.h"

namespace facenav::head_tracking {

/// Filters of patch::kSamples values, orthogonal to 1 and to `grey` (so offset and gain drop out) and of the
/// derivatives' length. `d_u`, `d_v`: derivatives of `grey` (mean taken off), per pixel of the level;
/// `noise_grey`: of the sensor; `shading_grey`: of shading within the patch, standard deviations.
std::array<std::vector<float>, 2> displacementFilters(const std::vector<float>& grey,
                                                      const std::vector<float>& d_u,
                                                      const std::vector<float>& d_v, int level,
                                                      double noise_grey, double shading_grey);

/// Patterns of a patch of the finest level, one a row, in which the sensor's noise is independent and of unit
/// variance, and light tells ever more: from grain that the blur has left to nothing but noise to the mean.
const Eigen::Matrix<float, patch::kSamples, patch::kSamples, Eigen::RowMajor>& patternsByFineness();

/// Autocorrelation of a level's blur along one axis, by lag in pixels of the level: of the sensor's noise in
/// it, for unit variance before the blur.
std::array<double, patch::kSide> noiseCorrelation(int level);

}  // namespace facenav::head_tracking
