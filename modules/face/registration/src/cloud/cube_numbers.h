#pragma once
// CubeNumbers: numbers the cubes of a grid in the order in which points first fall into them. Used to form
// patches of skin and to thin clouds evenly.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace facenav::registration {

class CubeNumbers {
 public:
  /// `most`: expected number of cubes; more are possible.
  explicit CubeNumbers(double size_mm, std::size_t most = 500);

  /// Number of the cube that contains the point; a new number for a new cube. Coordinates must be finite and
  /// within a million cubes.
  int of(const Eigen::Vector3f& p_mm);
  /// Number of the cube that contains the point; -1 for a new cube, which is not added.
  int find(const Eigen::Vector3f& p_mm) const;
  int size() const { return size_; }

 private:
  static constexpr std::uint64_t kFree = ~0ull;
  std::uint64_t keyOf(const Eigen::Vector3f& p_mm) const;
  std::size_t slotOf(std::uint64_t key) const;
  void grow(std::size_t slots);

  float per_mm_;
  int size_ = 0, shift_ = 0;
  std::vector<std::uint64_t> keys_;  // open addressing, never more than half full
  std::vector<std::int32_t> numbers_;
};

inline std::uint64_t CubeNumbers::keyOf(const Eigen::Vector3f& p_mm) const {
  const auto cell = [this](float x_mm) {
    const float x = x_mm * per_mm_;
    const int truncated = int(x);
    return std::uint64_t(std::uint32_t(truncated - int(x < float(truncated)))) & 0x1fffff;
  };
  return cell(p_mm.x()) | cell(p_mm.y()) << 21 | cell(p_mm.z()) << 42;
}

inline std::size_t CubeNumbers::slotOf(std::uint64_t key) const {
  std::size_t at = std::size_t((key * 0x9e3779b97f4a7c15ull) >> shift_);
  while (keys_[at] != kFree && keys_[at] != key) at = (at + 1) & (keys_.size() - 1);
  return at;
}

inline int CubeNumbers::of(const Eigen::Vector3f& p_mm) {
  const std::uint64_t key = keyOf(p_mm);
  std::size_t at = slotOf(key);
  if (keys_[at] == key) return numbers_[at];
  if (2 * (std::size_t(size_) + 1) > keys_.size()) {
    grow(2 * keys_.size());
    at = slotOf(key);
  }
  keys_[at] = key;
  return numbers_[at] = size_++;
}

inline int CubeNumbers::find(const Eigen::Vector3f& p_mm) const {
  const std::uint64_t key = keyOf(p_mm);
  const std::size_t at = slotOf(key);
  return keys_[at] == key ? numbers_[at] : -1;
}

}  // namespace facenav::registration
