#pragma once
// The weights that turn the samples of a patch into its displacement: generalised least squares (Aitken
// 1935). Plain derivative images explain every difference from the key frame by motion, also shading that
// stays with the lamps while the skin turns (a highlight on dark or moist skin, the light on a dent). Here a
// difference may also be sensor noise or shading: smooth over the patch, and stronger where the skin is
// curved. Smooth differences then have little weight, and the fine marks on the skin determine the motion.
// Computed once per key frame, so tracking costs the same.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "patch_kernel.h"

namespace facenav::head_tracking {

/// Distance over which fine shading is correlated, pixels of the level.
constexpr double kFineShading_px = 2.0;

/// Filters of patch::kSamples values, orthogonal to 1 and to `grey` (so offset and gain drop out), with the
/// length of the derivatives. `d_u`, `d_v`: derivatives of `grey` (mean subtracted), per pixel of the level.
/// `noise_grey`: standard deviation of the sensor's noise; `shading_grey`: of shading within the patch.
std::array<std::vector<float>, 2> displacementFilters(const std::vector<float>& grey,
                                                      const std::vector<float>& d_u,
                                                      const std::vector<float>& d_v, int level,
                                                      double noise_grey, double shading_grey);

/// Patterns of a patch of the finest level, one per row. The sensor's noise in them is independent with unit
/// variance, and the share of light grows with the row: from fine grain, mostly noise after the blur, to the
/// mean.
const Eigen::Matrix<float, patch::kSamples, patch::kSamples, Eigen::RowMajor>& patternsByFineness();

/// Autocorrelation of the sensor's noise in a level along one axis, by lag in pixels of the level; caused by
/// the blur. Unit variance before the blur.
std::array<double, patch::kSide> noiseCorrelation(int level);

}  // namespace facenav::head_tracking
