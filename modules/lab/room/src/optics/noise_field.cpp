#include "noise_field.h"

#include <cmath>
#include <random>

namespace facenav::room {
namespace {

constexpr int kSize = 64;  // cells along each edge, a power of two
constexpr int kMask = kSize - 1;

std::size_t cell(int x, int y, int z) {
  return std::size_t(x & kMask) + kSize * (std::size_t(y & kMask) + kSize * std::size_t(z & kMask));
}

/// Smooths by (1 2 1) / 4 along one axis, wrapped.
std::vector<float> smooth(const std::vector<float>& in, int axis) {
  std::vector<float> out(in.size());
  const int dx = axis == 0, dy = axis == 1, dz = axis == 2;
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        out[cell(x, y, z)] = 0.25f * in[cell(x - dx, y - dy, z - dz)] + 0.5f * in[cell(x, y, z)] +
                             0.25f * in[cell(x + dx, y + dy, z + dz)];
  return out;
}

void normalise(std::vector<float>& cells) {
  double sum = 0.0, squares = 0.0;
  for (const float value : cells) sum += value, squares += double(value) * value;
  const double mean = sum / cells.size(), deviation = std::sqrt(squares / cells.size() - mean * mean);
  for (float& value : cells) value = float((value - mean) / deviation);
}

}  // namespace

NoiseField::NoiseField(std::uint64_t seed) : cells_(std::size_t(kSize) * kSize * kSize) {
  std::mt19937_64 random(seed);
  for (float& value : cells_) value = float(double(random() >> 11) * 0x1p-53 - 0.5);
  for (int axis = 0; axis < 3; ++axis) cells_ = smooth(cells_, axis);
  normalise(cells_);
}

float NoiseField::at(const Eigen::Vector3d& p_mm, double grain_mm) const {
  // Rotated against the axes, so that cells never line up with scan rows.
  static const Eigen::Matrix3f kTurn = [] {
    Eigen::Matrix3f turn;
    turn << 0.8047f, -0.5059f, 0.3106f, 0.5059f, 0.3106f, -0.8047f, 0.3106f, 0.8047f, 0.5059f;
    return turn;
  }();
  constexpr float kFar = 4096.f;  // offset that makes truncation act as floor
  const Eigen::Vector3f q = kTurn * (p_mm / grain_mm).cast<float>() + Eigen::Vector3f::Constant(kFar);
  const int x = int(q.x()), y = int(q.y()), z = int(q.z());
  const float fx = q.x() - float(x), fy = q.y() - float(y), fz = q.z() - float(z);
  const std::size_t x0 = std::size_t(x & kMask), x1 = std::size_t((x + 1) & kMask);
  const auto along_x = [&](int row, int slice) {
    const float* cells = &cells_[kSize * (std::size_t(row & kMask) + kSize * std::size_t(slice & kMask))];
    return cells[x0] + fx * (cells[x1] - cells[x0]);
  };
  const float a = along_x(y, z), b = along_x(y + 1, z), c = along_x(y, z + 1), d = along_x(y + 1, z + 1);
  const float near_slice = a + fy * (b - a), far_slice = c + fy * (d - c);
  return near_slice + fz * (far_slice - near_slice);
}

const NoiseField& sharedNoise() {
  static const NoiseField field(20100917);
  return field;
}

}  // namespace facenav::room
