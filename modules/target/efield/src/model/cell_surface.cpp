#include "model/cell_surface.h"

#include <algorithm>
#include <array>

namespace facenav::efield {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int kRelaxSteps = 12;
constexpr double kStays = 0.48;  // of the voxel's edge: how far a vertex may move from its cell's middle

/// Voxel of corner `c` (bits: x, y, z) of a block of eight.
Vector3i cornerOf(const Vector3i& block, int c) { return block + Vector3i(c & 1, (c >> 1) & 1, c >> 2); }

/// The corner to be set of a block of eight voxels whose set ones are the bits of `set`: it has a set voxel
/// and an unset one that touch their like at an edge or a corner alone. -1: none.
template <class Value>
int cornerToSet(unsigned set, const Value& value) {
  const auto bestOf = [&](std::initializer_list<int> corners) {
    return *std::max_element(corners.begin(), corners.end(),
                             [&](int a, int b) { return value(a) < value(b); });
  };
  const auto is = [set](int corner) { return (set >> corner & 1) != 0; };
  for (int axis = 0; axis < 3; ++axis) {
    const int a = 1 << ((axis + 1) % 3), b = 1 << ((axis + 2) % 3);
    for (const int base : {0, 1 << axis}) {
      if (is(base) != is(base + a + b) || is(base + a) != is(base + b) || is(base) == is(base + a)) continue;
      return is(base) ? bestOf({base + a, base + b}) : bestOf({base, base + a + b});
    }
  }
  for (int c = 0; c < 4; ++c) {
    const unsigned pair = 1u << c | 1u << (7 - c);
    if (set == (~pair & 0xffu)) return bestOf({c, 7 - c});
    if (set == pair) return bestOf({c ^ 1, c ^ 2, c ^ 4});
  }
  return -1;
}

/// The field at a place, and its slope.
class Level {
 public:
  Level(const volume::Volume& field, double step_mm) : field_(field), step_mm_(step_mm) {}
  double at(const Vector3d& p) const {
    return volume::sampleLinear(field_, field_.grid.toVoxel(Point<Mri>(p)), 0.f);
  }
  /// Step towards the 0.5 level, at most `most_mm`.
  Vector3d stepTo(const Vector3d& p, double most_mm) const {
    Vector3d slope;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = step_mm_ * Vector3d::Unit(axis);
      slope[axis] = (at(p + step) - at(p - step)) / (2 * step_mm_);
    }
    constexpr double kLeastSlope = 0.02;  // a mm; the field is flat
    if (slope.norm() < kLeastSlope) return Vector3d::Zero();
    const Vector3d step = (0.5 - at(p)) / slope.squaredNorm() * slope;
    return step.norm() > most_mm ? Vector3d(step * (most_mm / step.norm())) : step;
  }

 private:
  const volume::Volume& field_;
  double step_mm_;
};

class Net {
 public:
  Net(const volume::Mask& coarse, const volume::Volume& field)
      : coarse_(coarse),
        spacing_mm_(coarse.grid.spacing_mm()[0]),
        level_(field, field.grid.spacing_mm()[0]),
        number_(coarse.grid.count(), -1) {
    addQuads();
    neighbours_.resize(middles_mm_.size());
    for (const auto& quad : quads_)
      for (std::size_t c = 0; c < 4; ++c) neighbours_[std::size_t(quad[c])].push_back(quad[(c + 1) % 4]);
    places_mm_ = middles_mm_;
    for (int step = 0; step < kRelaxSteps; ++step) relax();
  }

  ShellMesh mesh() const {
    ShellMesh mesh{Eigen::Matrix3Xd(3, Index(places_mm_.size())),
                   Eigen::Matrix3Xi(3, Index(2 * quads_.size()))};
    for (std::size_t i = 0; i < places_mm_.size(); ++i) mesh.vertices_mm.col(Index(i)) = places_mm_[i];
    for (std::size_t q = 0; q < quads_.size(); ++q) {
      const auto& v = quads_[q];
      const auto length = [&](int a, int b) {
        return (places_mm_[std::size_t(v[std::size_t(a)])] - places_mm_[std::size_t(v[std::size_t(b)])])
            .norm();
      };
      const bool is_first = length(0, 2) <= length(1, 3);
      mesh.triangles.col(Index(2 * q)) << v[0], v[1], is_first ? v[2] : v[3];
      mesh.triangles.col(Index(2 * q + 1)) << (is_first ? v[0] : v[1]), v[2], v[3];
    }
    return mesh;
  }

 private:
  /// Number of the vertex in the cell whose first voxel this is.
  int vertexOf(const Vector3i& cell) {
    int& number = number_[coarse_.grid.index(cell.x(), cell.y(), cell.z())];
    if (number < 0) {
      number = int(middles_mm_.size());
      middles_mm_.push_back(coarse_.grid.toMri(cell.cast<double>().array() + 0.5).mm);
    }
    return number;
  }
  /// One quad for each face between a set voxel and an unset one.
  void addQuads() {
    const auto& size = coarse_.grid.size;
    for (int k = 1; k < size[2]; ++k)
      for (int j = 1; j < size[1]; ++j)
        for (int i = 1; i < size[0]; ++i)
          for (int axis = 0; axis < 3; ++axis) {
            const Vector3i here(i, j, k), before = here - Vector3i::Unit(axis);
            const bool is_set = coarse_.at(i, j, k);
            if (is_set == coarse_.at(before.x(), before.y(), before.z())) continue;
            const Vector3i a = Vector3i::Unit((axis + 1) % 3), b = Vector3i::Unit((axis + 2) % 3);
            std::array<int, 4> quad = {vertexOf(before - a - b), vertexOf(before - b), vertexOf(before),
                                       vertexOf(before - a)};
            if (is_set) std::swap(quad[1], quad[3]);
            quads_.push_back(quad);
          }
  }
  void relax() {
    const std::vector<Vector3d> before = places_mm_;
    for (std::size_t i = 0; i < before.size(); ++i) {
      Vector3d mean = Vector3d::Zero();
      for (const int neighbour : neighbours_[i]) mean += before[std::size_t(neighbour)];
      Vector3d p = 0.5 * (before[i] + mean / double(neighbours_[i].size()));
      p += level_.stepTo(p, 0.3 * spacing_mm_);
      const double most_mm = kStays * spacing_mm_;
      places_mm_[i] = middles_mm_[i] + (p - middles_mm_[i]).cwiseMax(-most_mm).cwiseMin(most_mm);
    }
  }

  const volume::Mask& coarse_;
  double spacing_mm_;
  Level level_;
  std::vector<int> number_;  // by cell
  std::vector<Vector3d> middles_mm_, places_mm_;
  std::vector<std::array<int, 4>> quads_;
  std::vector<std::vector<int>> neighbours_;
};

}  // namespace

void joinDiagonals(volume::Mask& coarse, const volume::Volume& field) {
  const auto& size = coarse.grid.size;
  const auto valueAt = [&](const Vector3i& v) {
    return volume::sampleLinear(field, field.grid.toVoxel(coarse.grid.toMri(v.cast<double>())), 0.f);
  };
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (int k = 0; k + 1 < size[2]; ++k)
      for (int j = 0; j + 1 < size[1]; ++j)
        for (int i = 0; i + 1 < size[0]; ++i) {
          const Vector3i block(i, j, k);
          unsigned set = 0;
          for (int c = 0; c < 8; ++c) {
            const Vector3i v = cornerOf(block, c);
            set |= unsigned(coarse.at(v.x(), v.y(), v.z())) << c;
          }
          if (set == 0 || set == 0xff) continue;
          const int corner = cornerToSet(set, [&](int c) { return valueAt(cornerOf(block, c)); });
          if (corner < 0) continue;
          const Vector3i v = cornerOf(block, corner);
          coarse.voxels[coarse.grid.index(v.x(), v.y(), v.z())] = 1;
          has_changed = true;
        }
  }
}

ShellMesh cellSurface(const volume::Mask& coarse, const volume::Volume& field) {
  return Net(coarse, field).mesh();
}

}  // namespace facenav::efield
