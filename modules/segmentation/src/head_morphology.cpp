#include "head_morphology.h"

#include <algorithm>
#include <limits>

namespace facenav::segmentation {
namespace {

constexpr float kFar = 1e12f;

/// Lower envelope of parabolas over one line; `line` in place.
void distanceLine(std::vector<float>& line, double step_mm, std::vector<int>& vertex,
                  std::vector<double>& border, std::vector<float>& result) {
  const int n = int(line.size());
  const double s2 = step_mm * step_mm;
  int top = -1;
  for (int q = 0; q < n; ++q) {
    if (line[q] >= kFar) continue;
    double from = -std::numeric_limits<double>::infinity();
    while (top >= 0) {
      const int v = vertex[top];
      from = ((line[q] + s2 * q * q) - (line[v] + s2 * v * v)) / (2 * s2 * (q - v));
      if (from > border[top]) break;
      --top;
    }
    if (top < 0) from = -std::numeric_limits<double>::infinity();
    ++top;
    vertex[top] = q;
    border[top] = from;
  }
  if (top < 0) return;
  for (int q = 0, t = 0; q < n; ++q) {
    while (t < top && border[t + 1] < q) ++t;
    const double d = step_mm * (q - vertex[t]);
    result[q] = float(d * d + line[vertex[t]]);
  }
  line = result;
}

BitGrid thresholded(const BitGrid& like, const std::vector<float>& squared, double radius_mm, bool is_near) {
  BitGrid out{like.size, like.spacing_mm, std::vector<std::uint8_t>(squared.size())};
  const float limit = float(radius_mm * radius_mm * (1 + 1e-6));
  for (std::size_t v = 0; v < squared.size(); ++v) out.voxels[v] = (squared[v] <= limit) == is_near;
  return out;
}

/// Calls visit(neighbour index) for the 6 neighbours within the grid.
template <class Visit>
void forNeighbours(const BitGrid& grid, std::size_t v, Visit&& visit) {
  const std::size_t nx = grid.size[0], nxy = nx * grid.size[1];
  const int i = int(v % nx), j = int(v % nxy / nx), k = int(v / nxy);
  if (i > 0) visit(v - 1);
  if (i + 1 < grid.size[0]) visit(v + 1);
  if (j > 0) visit(v - nx);
  if (j + 1 < grid.size[1]) visit(v + nx);
  if (k > 0) visit(v - nxy);
  if (k + 1 < grid.size[2]) visit(v + nxy);
}

/// Marks with `mark` the zeros of `voxels` that connect to the queue's members (already marked).
void flood(BitGrid& grid, std::vector<std::size_t> queue, std::uint8_t mark) {
  while (!queue.empty()) {
    const std::size_t v = queue.back();
    queue.pop_back();
    forNeighbours(grid, v, [&](std::size_t n) {
      if (grid.voxels[n] == 0) grid.voxels[n] = mark, queue.push_back(n);
    });
  }
}

/// Voxels of one face of the grid as a 2-D flood from the face's rim: those reached are outside.
std::vector<std::size_t> outsideOnFace(const BitGrid& grid, int axis, int at) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const int na = grid.size[a], nb = grid.size[b];
  auto voxel = [&](int u, int v) {
    std::array<int, 3> ijk;
    ijk[axis] = at, ijk[a] = u, ijk[b] = v;
    return grid.index(ijk[0], ijk[1], ijk[2]);
  };
  std::vector<std::uint8_t> reached(std::size_t(na) * nb);
  std::vector<std::pair<int, int>> queue;
  std::vector<std::size_t> outside;
  auto reach = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= na || v >= nb || reached[u + std::size_t(na) * v]) return;
    const std::size_t at_voxel = voxel(u, v);
    if (grid.voxels[at_voxel] != 0) return;
    reached[u + std::size_t(na) * v] = 1;
    outside.push_back(at_voxel);
    queue.emplace_back(u, v);
  };
  for (int u = 0; u < na; ++u) reach(u, 0), reach(u, nb - 1);
  for (int v = 0; v < nb; ++v) reach(0, v), reach(na - 1, v);
  while (!queue.empty()) {
    const auto [u, v] = queue.back();
    queue.pop_back();
    reach(u - 1, v), reach(u + 1, v), reach(u, v - 1), reach(u, v + 1);
  }
  return outside;
}

/// Counts up `open_directions` where the ray from the voxel along (di, dj, dk) leaves the grid unhindered.
void castRays(const BitGrid& grid, int di, int dj, int dk, std::vector<std::uint8_t>& open_directions) {
  std::vector<std::uint8_t> is_open(grid.voxels.size());
  const auto [nx, ny, nz] = grid.size;
  for (int k_step = 0; k_step < nz; ++k_step)
    for (int j_step = 0; j_step < ny; ++j_step)
      for (int i_step = 0; i_step < nx; ++i_step) {
        const int k = dk > 0 ? nz - 1 - k_step : k_step, j = dj > 0 ? ny - 1 - j_step : j_step;
        const int i = di > 0 ? nx - 1 - i_step : i_step;
        const int a = i + di, b = j + dj, c = k + dk;
        const std::size_t v = grid.index(i, j, k);
        if (grid.voxels[v]) continue;
        const bool leaves = a < 0 || b < 0 || c < 0 || a >= nx || b >= ny || c >= nz;
        is_open[v] = leaves || is_open[grid.index(a, b, c)];
        open_directions[v] += is_open[v];
      }
}

}  // namespace

std::vector<float> squaredDistance(const BitGrid& grid, std::uint8_t value) {
  std::vector<float> squared(grid.voxels.size());
  for (std::size_t v = 0; v < squared.size(); ++v) squared[v] = grid.voxels[v] == value ? 0.f : kFar;
  const std::array<std::size_t, 3> stride{1, std::size_t(grid.size[0]),
                                          std::size_t(grid.size[0]) * grid.size[1]};
  for (int axis = 0; axis < 3; ++axis) {
    const int n = grid.size[axis], a = (axis + 1) % 3, b = (axis + 2) % 3;
    std::vector<float> line(n), result(n);
    std::vector<int> vertex(n);
    std::vector<double> border(n);
    for (int v = 0; v < grid.size[b]; ++v)
      for (int u = 0; u < grid.size[a]; ++u) {
        const std::size_t start = u * stride[a] + v * stride[b];
        for (int q = 0; q < n; ++q) line[q] = squared[start + q * stride[axis]];
        distanceLine(line, grid.spacing_mm[axis], vertex, border, result);
        for (int q = 0; q < n; ++q) squared[start + q * stride[axis]] = line[q];
      }
  }
  return squared;
}

BitGrid dilate(const BitGrid& grid, double radius_mm) {
  return thresholded(grid, squaredDistance(grid, 1), radius_mm, true);
}
BitGrid erode(const BitGrid& grid, double radius_mm) {
  return thresholded(grid, squaredDistance(grid, 0), radius_mm, false);
}
BitGrid close(const BitGrid& grid, double radius_mm) { return erode(dilate(grid, radius_mm), radius_mm); }
BitGrid open(const BitGrid& grid, double radius_mm) { return dilate(erode(grid, radius_mm), radius_mm); }

BitGrid largestComponent(const BitGrid& grid) {
  BitGrid seen = grid, best{grid.size, grid.spacing_mm, std::vector<std::uint8_t>(grid.voxels.size())};
  std::vector<std::size_t> largest, members;
  for (std::size_t v = 0; v < seen.voxels.size(); ++v) {
    if (!seen.voxels[v]) continue;
    members.assign(1, v);
    seen.voxels[v] = 0;
    for (std::size_t m = 0; m < members.size(); ++m)
      forNeighbours(grid, members[m], [&](std::size_t n) {
        if (seen.voxels[n]) seen.voxels[n] = 0, members.push_back(n);
      });
    if (members.size() > largest.size()) largest.swap(members);
  }
  for (const std::size_t v : largest) best.voxels[v] = 1;
  return best;
}

BitGrid growInside(const BitGrid& seed, const BitGrid& limit, int steps) {
  BitGrid grown = seed;
  std::vector<std::size_t> front, next;
  for (std::size_t v = 0; v < seed.voxels.size(); ++v)
    if (seed.voxels[v]) front.push_back(v);
  for (int step = 0; step < steps && !front.empty(); ++step) {
    next.clear();
    for (const std::size_t v : front)
      forNeighbours(grown, v, [&](std::size_t n) {
        if (!grown.voxels[n] && limit.voxels[n]) grown.voxels[n] = 1, next.push_back(n);
      });
    front.swap(next);
  }
  return grown;
}

BitGrid fillCavities(const BitGrid& grid) {
  constexpr std::uint8_t kOutside = 2;
  std::vector<std::size_t> queue;
  for (int axis = 0; axis < 3; ++axis)
    for (const int at : {0, grid.size[axis] - 1}) {
      const auto outside = outsideOnFace(grid, axis, at);
      queue.insert(queue.end(), outside.begin(), outside.end());
    }
  BitGrid filled = grid;
  for (const std::size_t v : queue) filled.voxels[v] = kOutside;
  flood(filled, queue, kOutside);
  for (auto& voxel : filled.voxels) voxel = voxel != kOutside;
  return filled;
}

BitGrid fillOccluded(const BitGrid& grid, int most_open) {
  std::vector<std::uint8_t> open_directions(grid.voxels.size());
  for (int d = 0; d < 27; ++d)
    if (d != 13) castRays(grid, d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1, open_directions);
  BitGrid filled = grid;
  for (std::size_t v = 0; v < filled.voxels.size(); ++v) filled.voxels[v] |= open_directions[v] <= most_open;
  return filled;
}

}  // namespace facenav::segmentation
