#pragma once
// Grouped: items sorted by their owner, such as the neighbours of each vertex. All are stored in two arrays;
// there is no list per owner.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace facenav {
inline namespace core {

/// The items of owner o are all[first[o]] .. all[first[o + 1] - 1], in ascending order.
struct Grouped {
  std::vector<int> first, all;
};

/// Groups pairs (owner, item), owners 0 .. `owners` - 1, in linear time. Duplicate pairs are kept.
inline Grouped groupedByOwner(const std::vector<std::pair<int, int>>& pairs, std::size_t owners) {
  Grouped out{std::vector<int>(owners + 1, 0), std::vector<int>(pairs.size())};
  for (const auto& pair : pairs) ++out.first[std::size_t(pair.first) + 1];
  for (std::size_t o = 0; o < owners; ++o) out.first[o + 1] += out.first[o];
  std::vector<int> next(out.first.begin(), out.first.end() - 1);
  for (const auto& [owner, item] : pairs) out.all[std::size_t(next[std::size_t(owner)]++)] = item;
  for (std::size_t o = 0; o < owners; ++o)
    std::sort(out.all.begin() + out.first[o], out.all.begin() + out.first[o + 1]);
  return out;
}

/// Removes repeated items of each owner.
inline Grouped withoutRepetitions(const Grouped& grouped) {
  Grouped out{std::vector<int>(grouped.first.size(), 0), {}};
  out.all.reserve(grouped.all.size());
  for (std::size_t o = 0; o + 1 < grouped.first.size(); ++o) {
    std::unique_copy(grouped.all.begin() + grouped.first[o], grouped.all.begin() + grouped.first[o + 1],
                     std::back_inserter(out.all));
    out.first[o + 1] = int(out.all.size());
  }
  return out;
}

}  // namespace core
}  // namespace facenav
