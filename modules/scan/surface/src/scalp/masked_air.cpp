#include "masked_air.h"

#include <algorithm>
#include <array>
#include <vector>

#include "facenav/core/robust_statistics.h"
#include "facenav/volume/local_mean.h"
#include "facenav/volume/mask_morphology.h"

namespace facenav::surface {
namespace {

constexpr double kPlace_mm = 16;
constexpr double kNear_mm = 3;  // pads and haze further out have edges of their own

/// The value that more than half of the voxels outside the head have exactly.
std::optional<float> commonAir(const volume::Volume& scan, const volume::Mask& head) {
  std::vector<float> outside;
  for (std::size_t v = 0; v < scan.voxels.size(); v += 7)  // a prime: favours no axis
    if (!head.voxels[v]) outside.push_back(scan.voxels[v]);
  if (outside.empty()) return {};
  // A value that more than half of them have is the median.
  const float air = selectRank(outside, outside.size() / 2);
  const auto same = std::count(outside.begin(), outside.end(), air);
  return 2 * std::size_t(same) > outside.size() ? std::optional<float>(air) : std::nullopt;
}

/// Voxels at the head's outline that are brighter than air and share a face with air.
std::vector<std::uint8_t> besideAir(const volume::Volume& scan, float air, const volume::Mask& head) {
  const volume::Mask near = volume::dilate(head, kNear_mm);
  std::vector<std::uint8_t> beside(scan.voxels.size());
  const auto& size = scan.grid.size;
  const std::array<std::size_t, 3> stride{1, std::size_t(size[0]), std::size_t(size[0]) * size[1]};
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const std::array<int, 3> at{i, j, k};
        const std::size_t v = scan.grid.index(i, j, k);
        if (!near.voxels[v] || !(scan.voxels[v] > air)) continue;
        for (std::size_t a = 0; a < 3; ++a)
          beside[v] |= (at[a] > 0 && scan.voxels[v - stride[a]] == air) ||
                       (at[a] + 1 < size[a] && scan.voxels[v + stride[a]] == air);
      }
  return beside;
}

/// Nearly the least of the values, as a share of their mean: a few voxels inside the head may be darker than
/// the threshold. nullopt for too few of them.
std::optional<float> lowShare(const volume::Volume& scan, const std::vector<std::uint8_t>& beside) {
  std::vector<float> values;
  double sum = 0;
  for (std::size_t v = 0; v < beside.size(); ++v)
    if (beside[v]) values.push_back(scan.voxels[v]), sum += scan.voxels[v];
  if (values.size() < 100 || !(sum > 0)) return {};
  const double mean = sum / double(values.size());
  return float(selectRank(values, values.size() / 10) / mean);
}

}  // namespace

std::optional<volume::Volume> withoutMaskStep(const volume::Volume& scan, const volume::Mask& head) {
  const auto air = commonAir(scan, head);
  if (!air) return {};
  const auto beside = besideAir(scan, *air, head);
  const auto share = lowShare(scan, beside);
  if (!share) return {};
  // Uses a local mean: under shading, the threshold varies over the scan.
  volume::Volume raised{scan.grid, volume::localMean(scan.grid, scan.voxels, beside, kPlace_mm, *air),
                        scan.modality, scan.orientation_source};
  for (std::size_t v = 0; v < scan.voxels.size(); ++v)
    raised.voxels[v] = std::max(scan.voxels[v], *share * raised.voxels[v]);
  return raised;
}

}  // namespace facenav::surface
