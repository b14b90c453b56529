#include "prior/scan_prior.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <mutex>

#include "brain_start.h"

namespace facenav::segmentation {
namespace {

using volume::Volume;

/// Checksum of the bits of all voxels. Two scans with one grid and one sum are considered the same.
std::uint64_t checksum(const std::vector<float>& voxels) {
  constexpr std::uint64_t kPrime = 0x100000001b3;  // FNV-1a
  std::array<std::uint64_t, 4> sums{1, 2, 3, 4};   // independent: no step waits for the one before
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    std::uint32_t bits;
    std::memcpy(&bits, &voxels[v], sizeof bits);
    sums[v % 4] = (sums[v % 4] ^ bits) * kPrime;
  }
  std::uint64_t all = 0;
  for (const std::uint64_t sum : sums) all = (all ^ sum) * kPrime;
  return all;
}

struct ScanKey {
  const PriorNetwork* network = nullptr;
  volume::VoxelGrid grid;
  std::uint64_t sum = 0;
  bool operator==(const ScanKey& other) const {
    return network == other.network && sum == other.sum && grid.size == other.grid.size &&
           grid.mri_from_voxel.matrix() == other.grid.mri_from_voxel.matrix();
  }
};

/// The scan of the last request.
struct LastScan {
  std::mutex mutex;  // held while the network runs: a request for the same scan waits for the result
  ScanKey key;
  std::weak_ptr<const ScanPrior> found;
};

LastScan& lastScan() {
  static LastScan last;
  return last;
}

}  // namespace

std::shared_ptr<const ScanPrior> scanPrior(const PriorNetwork& network, const Volume& scan) {
  const ScanKey key{&network, scan.grid, checksum(scan.voxels)};
  LastScan& last = lastScan();
  const std::lock_guard<std::mutex> lock(last.mutex);
  if (last.key == key)
    if (auto found = last.found.lock()) return found;
  auto found = std::make_shared<ScanPrior>();
  found->working = workingVolume(scan, 1.0);
  found->prior = findBrainPrior(network, found->working);
  last.key = key, last.found = found;
  return found;
}

}  // namespace facenav::segmentation
