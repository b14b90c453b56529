#pragma once
// MshReader: parses a gmsh file of format 2.2, text or binary, as gmsh and SimNIBS write it. All counts are
// read from the file, none is assumed; a section need not end its line before its $End. Private to efield.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace facenav::efield {

/// Things by their ids, which a file may give in any order.
template <class T>
class ById {
 public:
  void add(int id, const T& thing) {
    is_sorted_ = is_sorted_ && (things_.empty() || things_.back().first < id);
    things_.emplace_back(id, thing);
  }
  /// Must be called after the last add().
  void sort() {
    const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
    if (!is_sorted_) std::stable_sort(things_.begin(), things_.end(), before);
    is_sorted_ = true;
  }
  /// Null: there is none.
  const T* find(int id) const {
    if (things_.empty()) return nullptr;
    const long guess = long(id) - things_.front().first;  // usual ids leave no gaps
    if (guess >= 0 && guess < long(things_.size()) && things_[std::size_t(guess)].first == id)
      return &things_[std::size_t(guess)].second;
    const auto at = std::lower_bound(things_.begin(), things_.end(), id,
                                     [](const auto& thing, int wanted) { return thing.first < wanted; });
    return at != things_.end() && at->first == id ? &at->second : nullptr;
  }
  const std::vector<std::pair<int, T>>& all() const { return things_; }
  bool empty() const { return things_.empty(); }

 private:
  std::vector<std::pair<int, T>> things_;
  bool is_sorted_ = true;
};

/// A triangle or a tetrahedron.
struct MshElement {
  int tag = 0, corners = 0;    // 3 or 4
  std::array<int, 4> nodes{};  // ids
};

/// Holds one block of data, on nodes or elements.
struct MshData {
  int components = 0;
  ById<Eigen::Vector3d> values;
};

struct Msh {
  ById<Eigen::Vector3d> nodes;
  ById<MshElement> elements;  // triangles and tetrahedra; others are left out
  std::map<std::string, MshData> on_nodes, on_elements;
};

/// Reads nodes, elements, and the data of these names with 1 or 3 components. Throws Error naming the file
/// and what is damaged.
Msh readMsh(const std::filesystem::path& path, const std::vector<std::string>& data_names);

}  // namespace facenav::efield
