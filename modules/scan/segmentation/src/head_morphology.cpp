#include "head_morphology.h"

#include <array>
#include <utility>

#include "facenav/volume/mask_morphology.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;

constexpr double kNarrowOpening_mm = 4.0;  // ear canals, nostrils: closed with a ball of this radius
constexpr int kMostOpenDirections =
    4;  // of 26 directions: a voxel with at most this many open ones lies in a cavity

/// Calls visit(neighbour index) for the 6 neighbours within the grid.
template <class Visit>
void forNeighbours(const Mask& mask, std::size_t v, Visit&& visit) {
  const std::size_t nx = mask.grid.size[0], nxy = nx * mask.grid.size[1];
  const int i = int(v % nx), j = int(v % nxy / nx), k = int(v / nxy);
  if (i > 0) visit(v - 1);
  if (i + 1 < mask.grid.size[0]) visit(v + 1);
  if (j > 0) visit(v - nx);
  if (j + 1 < mask.grid.size[1]) visit(v + nx);
  if (k > 0) visit(v - nxy);
  if (k + 1 < mask.grid.size[2]) visit(v + nxy);
}

/// Flood of one face of the grid, in 2-D, from the face's border. Returns the reached voxels: they are
/// outside.
std::vector<std::size_t> outsideOnFace(const Mask& mask, int axis, int at) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const int na = mask.grid.size[a], nb = mask.grid.size[b];
  auto voxel = [&](int u, int v) {
    std::array<int, 3> ijk;
    ijk[axis] = at, ijk[a] = u, ijk[b] = v;
    return mask.grid.index(ijk[0], ijk[1], ijk[2]);
  };
  std::vector<std::uint8_t> reached(std::size_t(na) * nb);
  std::vector<std::pair<int, int>> queue;
  std::vector<std::size_t> outside;
  auto reach = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= na || v >= nb || reached[u + std::size_t(na) * v]) return;
    const std::size_t at_voxel = voxel(u, v);
    if (mask.voxels[at_voxel] != 0) return;
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

/// Casts one row of rays: is_open where the voxel is not in the mask and the next one on its ray, `di` voxels
/// along `next`, is open. Without a `next` row, and beyond a row's ends, the ray has reached the outside.
void castRow(const std::uint8_t* mask, const std::uint8_t* next, int di, int n, std::uint8_t* is_open) {
  if (!next) {
    for (int i = 0; i < n; ++i) is_open[i] = !mask[i];
    return;
  }
  const int first = di < 0 ? 1 : 0, last = di > 0 ? n - 1 : n;
  if (first > 0) is_open[0] = !mask[0];
  if (last < n) is_open[n - 1] = !mask[n - 1];
  if (next != is_open)
    for (int i = first; i < last; ++i) is_open[i] = (!mask[i]) & next[i + di];
  else if (di > 0)  // along the row itself: starts at its far end
    for (int i = last - 1; i >= first; --i) is_open[i] = (!mask[i]) & next[i + 1];
  else
    for (int i = first; i < last; ++i) is_open[i] = (!mask[i]) & next[i - 1];
}

/// Increments `open_directions` where the ray from the voxel along (di, dj, dk) leaves the grid.
void castRays(const Mask& mask, int di, int dj, int dk, std::vector<std::uint8_t>& open_directions) {
  std::vector<std::uint8_t> is_open(mask.voxels.size());
  const auto [nx, ny, nz] = mask.grid.size;
  for (int k_step = 0; k_step < nz; ++k_step)
    for (int j_step = 0; j_step < ny; ++j_step) {
      const int k = dk > 0 ? nz - 1 - k_step : k_step, j = dj > 0 ? ny - 1 - j_step : j_step;
      const int b = j + dj, c = k + dk;
      const bool leaves = b < 0 || c < 0 || b >= ny || c >= nz;
      const std::size_t row = mask.grid.index(0, j, k);
      castRow(&mask.voxels[row], leaves ? nullptr : &is_open[mask.grid.index(0, b, c)], di, nx,
              &is_open[row]);
    }
  for (std::size_t v = 0; v < is_open.size(); ++v) open_directions[v] += is_open[v];
}

}  // namespace

Mask growInside(const Mask& seed, const Mask& limit, int steps) {
  Mask grown = seed;
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

Mask fillCavities(const Mask& mask) {
  std::vector<std::size_t> outside;
  for (int axis = 0; axis < 3; ++axis)
    for (const int at : {0, mask.grid.size[std::size_t(axis)] - 1}) {
      const auto on_face = outsideOnFace(mask, axis, at);
      outside.insert(outside.end(), on_face.begin(), on_face.end());
    }
  return fillHolesFrom(mask, outside);
}

Mask fillOccluded(const Mask& mask, int most_open) {
  std::vector<std::uint8_t> open_directions(mask.voxels.size());
  for (int d = 0; d < 27; ++d)
    if (d != 13) castRays(mask, d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1, open_directions);
  Mask filled = mask;
  for (std::size_t v = 0; v < filled.voxels.size(); ++v) filled.voxels[v] |= open_directions[v] <= most_open;
  return filled;
}

Mask withoutCavities(const Mask& tissue) {
  const Mask closed = close(fillOccluded(tissue, kMostOpenDirections), kNarrowOpening_mm);
  const Mask filled = fillCavities(closed);
  Mask cavities = filled;
  for (std::size_t v = 0; v < cavities.voxels.size(); ++v)
    cavities.voxels[v] = filled.voxels[v] && !closed.voxels[v];
  Mask plugs = dilate(cavities, kNarrowOpening_mm + tissue.grid.spacing_mm().maxCoeff());
  for (std::size_t v = 0; v < plugs.voxels.size(); ++v) plugs.voxels[v] = plugs.voxels[v] && filled.voxels[v];
  return fillCavities(fillOccluded(unionOf(plugs, tissue), kMostOpenDirections));
}

}  // namespace facenav::segmentation
