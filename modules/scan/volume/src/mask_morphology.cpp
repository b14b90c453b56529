#include "facenav/volume/mask_morphology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "ball_dilation.h"
#include "facenav/volume/for_slices.h"

namespace facenav::volume {
namespace {

constexpr float kFar = 1e9f;

/// Lower envelope of parabolas along one line (Felzenszwalb and Huttenlocher 2012), mm squared.
struct LineTransform {
  explicit LineTransform(int longest) : f(longest), corner(longest), from(longest), start(longest + 1) {}
  std::vector<float> f;
  std::vector<int> corner;
  std::vector<float> from, start;

  /// Transforms a line of `n` values. `w`: the squared step in mm^2.
  void run(float* line, std::size_t stride, int n, float w) {
    float highest = 0;
    for (int i = 0; i < n; ++i) f[i] = line[i * stride], highest = std::max(highest, f[i]);
    if (highest == 0) return;  // the whole line lies in the target
    int k = -1;
    for (int q = 0; q < n; ++q) {
      if (f[q] >= kFar) continue;
      float s = -kFar;
      while (k >= 0) {
        const int v = corner[k];
        s = ((f[q] + w * float(q) * q) - (f[v] + w * float(v) * v)) / (2.f * w * (q - v));
        if (s > start[k]) break;
        --k;
      }
      ++k;
      corner[k] = q;
      start[k] = k == 0 ? -kFar : s;
    }
    if (k < 0) return;
    for (int q = 0, c = 0; q < n; ++q) {
      while (c < k && start[c + 1] < q) ++c;
      const float d = float(q - corner[c]);
      line[q * stride] = w * d * d + f[corner[c]];
    }
  }
};

/// Squared distance along one line to the nearest voxel of the target.
void nearestAlong(const std::uint8_t* mask, bool target, int n, float w, float* line) {
  const auto sweep = [&](int from, int end, int step, auto&& keep) {
    int steps = -1;  // steps since the last voxel of the target
    for (int i = from; i != end; i += step) {
      steps = (mask[i] != 0) == target ? 0 : steps < 0 ? -1 : steps + 1;
      keep(line[i], steps < 0 ? kFar : w * float(steps) * float(steps));
    }
  };
  sweep(0, n, 1, [](float& value, float here) { value = here; });
  sweep(n - 1, -1, -1, [](float& value, float here) { value = std::min(value, here); });
}

/// Transforms all lines of `n` values (distance `stride`) that start at `first` + 0 .. `lines` - 1.
/// Neighbouring lines are done in blocks, so that each cache line is used completely.
void runLines(std::vector<float>& d, std::size_t first, int lines, std::size_t stride, int n, float w,
              LineTransform& line) {
  constexpr int kBlock = 16;
  std::vector<float> block(std::size_t(n) * kBlock);
  for (int start = 0; start < lines; start += kBlock) {
    const int width = std::min(kBlock, lines - start);
    for (int q = 0; q < n; ++q)
      std::copy_n(&d[first + start + q * stride], width, &block[std::size_t(q) * kBlock]);
    for (int l = 0; l < width; ++l) line.run(&block[l], kBlock, n, w);
    for (int q = 0; q < n; ++q)
      std::copy_n(&block[std::size_t(q) * kBlock], width, &d[first + start + q * stride]);
  }
}

std::vector<float> squaredDistance(const Mask& mask, std::uint8_t target) {
  const auto& n = mask.grid.size;
  std::vector<float> d(mask.voxels.size());
  const int longest = *std::max_element(n.begin(), n.end());
  const Eigen::Array3f w = mask.grid.spacing_mm().array().square().cast<float>();
  forSlices(n[2], [&](int k) {
    LineTransform line(longest);
    for (int j = 0; j < n[1]; ++j) {
      const std::size_t row = mask.grid.index(0, j, k);
      nearestAlong(&mask.voxels[row], target != 0, n[0], w[0], &d[row]);
    }
    runLines(d, mask.grid.index(0, 0, k), n[0], n[0], n[1], w[1], line);
  });
  forSlices(n[1], [&](int j) {
    LineTransform line(longest);
    runLines(d, mask.grid.index(0, j, 0), n[0], std::size_t(n[0]) * n[1], n[2], w[2], line);
  });
  return d;
}

/// Squared radius, slightly enlarged so that a voxel at exactly the radius is included despite rounding.
float squaredRadius(double radius_mm) { return float(radius_mm * radius_mm * (1 + 1e-5)); }

constexpr int kWindow = 24;  // largest radius in voxels; for larger balls the envelope is faster

Mask keep(const Mask& mask, const std::vector<float>& value, bool (*rule)(float, float), float limit) {
  Mask out{mask.grid, std::vector<std::uint8_t>(mask.voxels.size())};
  for (std::size_t i = 0; i < out.voxels.size(); ++i) out.voxels[i] = rule(value[i], limit);
  return out;
}

/// Calls visit(neighbour index) for the 6-neighbours of voxel `at` inside the grid.
template <class Visit>
void neighbours(const VoxelGrid& grid, std::size_t at, Visit&& visit) {
  const auto& n = grid.size;
  const std::size_t row = n[0], slab = std::size_t(n[0]) * n[1];
  const int i = int(at % row), j = int(at / row % n[1]), k = int(at / slab);
  if (i > 0) visit(at - 1);
  if (i + 1 < n[0]) visit(at + 1);
  if (j > 0) visit(at - row);
  if (j + 1 < n[1]) visit(at + row);
  if (k > 0) visit(at - slab);
  if (k + 1 < n[2]) visit(at + slab);
}

/// The 6-connected components, built from runs of voxels along i that touch in neighbouring rows.
class Parts {
 public:
  explicit Parts(const Mask& mask) : first_of_row_(std::size_t(mask.grid.size[1]) * mask.grid.size[2] + 1) {
    const auto& n = mask.grid.size;
    std::size_t line = 0;
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j, ++line) {
        first_of_row_[line] = runs_.size();
        addRuns(&mask.voxels[mask.grid.index(0, j, k)], mask.grid.index(0, j, k), n[0]);
        first_of_row_[line + 1] = runs_.size();
        if (j > 0) join(line - 1, line, std::size_t(n[0]));
        if (k > 0) join(line - std::size_t(n[1]), line, std::size_t(n[0]) * std::size_t(n[1]));
      }
    size_.resize(runs_.size());
    for (std::size_t r = 0; r < runs_.size(); ++r) size_[root(r)] += runs_[r].count;
  }

  /// The components that `choose(part, voxels)` accepts. `part` is the number of the component's root run.
  template <class Choose>
  Mask chosen(const VoxelGrid& grid, Choose&& choose) {
    Mask out{grid, std::vector<std::uint8_t>(grid.count())};
    for (std::size_t r = 0; r < runs_.size(); ++r)
      if (choose(root(r), size_[root(r)]))
        std::fill_n(out.voxels.begin() + std::ptrdiff_t(runs_[r].first), runs_[r].count, std::uint8_t(1));
    return out;
  }
  /// The first component with the most voxels.
  std::size_t largest() const {
    return std::size_t(std::max_element(size_.begin(), size_.end()) - size_.begin());
  }

 private:
  struct Run {
    std::size_t first, count, up;  // up: index of the run towards the part's root
  };

  void addRuns(const std::uint8_t* row, std::size_t first, int count) {
    for (int i = 0; i < count;) {
      const int from = i;
      while (i < count && row[i]) ++i;
      if (i > from)
        runs_.push_back({first + std::size_t(from), std::size_t(i - from), runs_.size()});
      else
        ++i;
    }
  }
  void join(std::size_t line, std::size_t next, std::size_t shift) {
    std::size_t a = first_of_row_[line], b = first_of_row_[next];
    while (a < first_of_row_[line + 1] && b < first_of_row_[next + 1]) {
      const std::size_t a_first = runs_[a].first + shift, a_end = a_first + runs_[a].count;
      const std::size_t b_first = runs_[b].first, b_end = b_first + runs_[b].count;
      if (a_first < b_end && b_first < a_end)
        runs_[std::max(root(a), root(b))].up = std::min(root(a), root(b));
      a_end < b_end ? ++a : ++b;
    }
  }
  std::size_t root(std::size_t r) {
    while (runs_[r].up != r) r = runs_[r].up = runs_[runs_[r].up].up;
    return r;
  }

  std::vector<Run> runs_;
  std::vector<std::size_t> first_of_row_, size_;
};

/// Flood fill of the background, by runs along i. A run is filled completely; then its four neighbouring rows
/// are examined.
class BackgroundFlood {
 public:
  explicit BackgroundFlood(const Mask& mask)
      : mask_(mask),
        row_(std::size_t(mask.grid.size[0])),
        out_{mask.grid, std::vector<std::uint8_t>(mask.voxels.size(), 1)} {}

  /// Starts from the background voxels among `from` .. `to` of one row.
  void reach(std::size_t from, std::size_t to) {
    for (std::size_t v = from; v <= to; ++v)
      if (isOpen(v)) reachRun(v);
  }
  /// All voxels outside the flooded background. May be called only once.
  Mask unreached() {
    const auto& n = mask_.grid.size;
    const std::size_t slab = row_ * std::size_t(n[1]);
    while (!front_.empty()) {
      const auto [from, to] = front_.back();
      front_.pop_back();
      const int j = int(from / row_ % std::size_t(n[1])), k = int(from / slab);
      if (j > 0) reach(from - row_, to - row_);
      if (j + 1 < n[1]) reach(from + row_, to + row_);
      if (k > 0) reach(from - slab, to - slab);
      if (k + 1 < n[2]) reach(from + slab, to + slab);
    }
    return std::move(out_);
  }

 private:
  bool isOpen(std::size_t v) const { return !mask_.voxels[v] && out_.voxels[v]; }
  void reachRun(std::size_t v) {
    const std::size_t first = v / row_ * row_, last = first + row_ - 1;
    std::size_t from = v, to = v;
    while (from > first && isOpen(from - 1)) --from;
    while (to < last && isOpen(to + 1)) ++to;
    std::fill(out_.voxels.begin() + std::ptrdiff_t(from), out_.voxels.begin() + std::ptrdiff_t(to) + 1,
              std::uint8_t(0));
    front_.emplace_back(std::uint32_t(from), std::uint32_t(to));
  }

  const Mask& mask_;
  std::size_t row_;
  Mask out_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> front_;
};

}  // namespace

std::vector<float> distanceTo(const Mask& mask) {
  auto d = squaredDistance(mask, 1);
  for (float& v : d) v = std::sqrt(v);
  return d;
}

std::vector<float> depthWithin(const Mask& mask) {
  auto d = squaredDistance(mask, 0);
  for (float& v : d) v = std::sqrt(v);
  return d;
}

Mask dilate(const Mask& mask, double radius_mm) {
  const float limit = squaredRadius(radius_mm);
  if (radius_mm / mask.grid.spacing_mm().minCoeff() <= kWindow)
    return {mask.grid, withinBall(mask, true, limit)};
  return keep(
      mask, squaredDistance(mask, 1), [](float d, float r) { return d <= r; }, limit);
}

Mask erode(const Mask& mask, double radius_mm) {
  const float limit = squaredRadius(radius_mm);
  if (radius_mm / mask.grid.spacing_mm().minCoeff() > kWindow)
    return keep(
        mask, squaredDistance(mask, 0), [](float d, float r) { return d > r; }, limit);
  Mask out{mask.grid, withinBall(mask, false, limit)};
  for (auto& voxel : out.voxels) voxel ^= 1;
  return out;
}

Mask close(const Mask& mask, double radius_mm) { return erode(dilate(mask, radius_mm), radius_mm); }
Mask open(const Mask& mask, double radius_mm) { return dilate(erode(mask, radius_mm), radius_mm); }

Mask largestPart(const Mask& mask) {
  Parts parts(mask);
  const std::size_t largest = parts.largest();
  return parts.chosen(mask.grid, [&](std::size_t part, std::size_t) { return part == largest; });
}

Mask withoutSpecks(const Mask& mask, std::size_t voxels) {
  Parts parts(mask);
  return parts.chosen(mask.grid, [&](std::size_t, std::size_t size) { return size >= voxels; });
}

Mask fillHolesFrom(const Mask& mask, const std::vector<std::size_t>& outside) {
  BackgroundFlood flood(mask);
  for (const std::size_t v : outside) flood.reach(v, v);
  return flood.unreached();
}

Mask fillHoles(const Mask& mask) {
  BackgroundFlood flood(mask);
  const auto& n = mask.grid.size;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j) {
      const std::size_t first = mask.grid.index(0, j, k), last = first + std::size_t(n[0]) - 1;
      if (j == 0 || k == 0 || j == n[1] - 1 || k == n[2] - 1)
        flood.reach(first, last);
      else
        flood.reach(first, first), flood.reach(last, last);
    }
  return flood.unreached();
}

Mask surfaceVoxels(const Mask& mask) {
  Mask out{mask.grid, std::vector<std::uint8_t>(mask.voxels.size())};
  for (std::size_t v = 0; v < out.voxels.size(); ++v) {
    if (!mask.voxels[v]) continue;
    int inner = 0;
    neighbours(mask.grid, v, [&](std::size_t next) { inner += mask.voxels[next] != 0; });
    out.voxels[v] = inner < 6;
  }
  return out;
}

Mask intersection(const Mask& a, const Mask& b) {
  Mask out = a;
  for (std::size_t i = 0; i < out.voxels.size(); ++i) out.voxels[i] = a.voxels[i] & b.voxels[i];
  return out;
}

Mask unionOf(const Mask& a, const Mask& b) {
  Mask out = a;
  for (std::size_t i = 0; i < out.voxels.size(); ++i) out.voxels[i] = a.voxels[i] | b.voxels[i];
  return out;
}

Mask grow(const Mask& seed, const Mask& all, int steps) {
  Mask out = intersection(seed, all);
  std::vector<std::uint32_t> front, next_front;
  for (std::size_t i = 0; i < out.voxels.size(); ++i)
    if (out.voxels[i]) front.push_back(std::uint32_t(i));
  for (int s = 0; s < steps && !front.empty(); ++s) {
    next_front.clear();
    for (std::uint32_t at : front)
      neighbours(out.grid, at, [&](std::size_t v) {
        if (out.voxels[v] || !all.voxels[v]) return;
        out.voxels[v] = 1;
        next_front.push_back(std::uint32_t(v));
      });
    front.swap(next_front);
  }
  return out;
}

}  // namespace facenav::volume
