#include "cube_numbers.h"

namespace facenav::registration {

CubeNumbers::CubeNumbers(double size_mm, std::size_t most) : per_mm_(float(1.0 / size_mm)) {
  std::size_t slots = 64;
  while (slots < 2 * most) slots *= 2;
  grow(slots);
}

void CubeNumbers::grow(std::size_t slots) {
  const std::vector<std::uint64_t> keys = std::move(keys_);
  const std::vector<std::int32_t> numbers = std::move(numbers_);
  keys_.assign(slots, kFree);
  numbers_.resize(slots);
  for (shift_ = 64; slots > 1; slots /= 2) --shift_;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (keys[k] == kFree) continue;
    const std::size_t at = slotOf(keys[k]);
    keys_[at] = keys[k];
    numbers_[at] = numbers[k];
  }
}

}  // namespace facenav::registration
