#include "ball_dilation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "facenav/volume/for_slices.h"

namespace facenav::volume {
namespace {

using Word = std::uint64_t;
constexpr int kBits = 64;

/// A grid's voxels as bits. Each row along i starts at a new word; unused bits are 0.
struct BitRows {
  std::size_t words_a_row, words_a_slice;
  Word last_word;  // mask of the bits of a row's last word that are voxels
  std::vector<Word> words;

  explicit BitRows(const std::array<int, 3>& n)
      : words_a_row((std::size_t(n[0]) + kBits - 1) / kBits),
        words_a_slice(words_a_row * std::size_t(n[1])),
        last_word(n[0] % kBits ? (Word(1) << n[0] % kBits) - 1 : ~Word(0)),
        words(words_a_slice * std::size_t(n[2])) {}
};

/// Packs eight voxels (0 or not 0) into eight bits.
Word packed(const std::uint8_t* voxels) {
  Word v;
  std::memcpy(&v, voxels, sizeof v);
  v |= v >> 4, v |= v >> 2, v |= v >> 1;
  return (v & 0x0101010101010101ull) * 0x0102040810204080ull >> 56;
}

void packRow(const std::uint8_t* voxels, int n, bool is_set, Word last_word, Word* row) {
  int i = 0;
  for (; i + 8 <= n; i += 8) row[i / kBits] |= packed(voxels + i) << i % kBits;
  for (; i < n; ++i) row[i / kBits] |= Word(voxels[i] != 0) << i % kBits;
  if (is_set) return;
  const int last = (n - 1) / kBits;
  for (int w = 0; w <= last; ++w) row[w] = ~row[w];
  row[last] &= last_word;
}

/// For each byte value, the eight voxels of its bits.
const std::array<Word, 256>& voxelsOfByte() {
  static const std::array<Word, 256> table = [] {
    std::array<Word, 256> out{};
    for (std::size_t byte = 0; byte < 256; ++byte)
      for (std::size_t b = 0; b < 8; ++b) out[byte] |= Word(byte >> b & 1) << 8 * b;
    return out;
  }();
  return table;
}

void unpackRow(const Word* row, int n, std::uint8_t* voxels) {
  int i = 0;
  for (; i + 8 <= n; i += 8) std::memcpy(voxels + i, &voxelsOfByte()[row[i / kBits] >> i % kBits & 0xff], 8);
  for (; i < n; ++i) voxels[i] = row[i / kBits] >> i % kBits & 1;
}

/// Widens every row of a slice by one voxel at both ends.
void widen(const Word* in, Word* out, std::size_t rows, std::size_t words, Word last_word) {
  for (std::size_t r = 0; r < rows; ++r, in += words, out += words) {
    for (std::size_t w = 0; w < words; ++w)
      out[w] = in[w] | in[w] << 1 | in[w] >> 1 | (w > 0 ? in[w - 1] >> (kBits - 1) : 0) |
               (w + 1 < words ? in[w + 1] << (kBits - 1) : 0);
    out[words - 1] &= last_word;
  }
}

/// A row of the ball, offset by `dj` rows and `dk` slices: voxels up to `half_width` in both directions
/// belong to it.
struct BallRow {
  int dj, dk, half_width;
};

/// Squares are added in the order of the axes, as in the distance map, so that both agree to the last bit.
std::vector<BallRow> ballRows(const VoxelGrid& grid, float squared_radius_mm2) {
  const Eigen::Vector3d h = grid.spacing_mm();
  std::array<int, 3> reach;
  std::array<float, 3> w;
  for (std::size_t a = 0; a < 3; ++a) {
    w[a] = float(h[int(a)] * h[int(a)]);
    reach[a] = std::min(grid.size[a] - 1, int(std::sqrt(double(squared_radius_mm2)) / h[int(a)]));
  }
  const auto squared = [&](int i, int j, int k) {
    return (w[0] * float(i) * float(i) + w[1] * float(j) * float(j)) + w[2] * float(k) * float(k);
  };
  std::vector<BallRow> rows;
  for (int dk = -reach[2]; dk <= reach[2]; ++dk)
    for (int dj = -reach[1]; dj <= reach[1]; ++dj) {
      int half_width = -1;
      while (half_width < reach[0] && squared(half_width + 1, dj, dk) <= squared_radius_mm2) ++half_width;
      if (half_width >= 0) rows.push_back({dj, dk, half_width});
    }
  return rows;
}

}  // namespace

std::vector<std::uint8_t> withinBall(const Mask& mask, bool is_set, float squared_radius_mm2) {
  const auto& n = mask.grid.size;
  std::vector<std::uint8_t> out(mask.voxels.size());
  if (out.empty()) return out;
  const std::vector<BallRow> ball = ballRows(mask.grid, squared_radius_mm2);
  int widest = 0;
  for (const BallRow& row : ball) widest = std::max(widest, row.half_width);
  std::vector<BitRows> widened(std::size_t(widest) + 1, BitRows(n));
  const std::size_t row = widened[0].words_a_row, slice = widened[0].words_a_slice;
  std::vector<std::uint8_t> has_any(std::size_t(n[2]), 0);
  forSlices(n[2], [&](int k) {
    for (int j = 0; j < n[1]; ++j)
      packRow(&mask.voxels[mask.grid.index(0, j, k)], n[0], is_set, widened[0].last_word,
              &widened[0].words[k * slice + j * row]);
    const Word* first = &widened[0].words[k * slice];
    has_any[std::size_t(k)] = std::any_of(first, first + slice, [](Word w) { return w != 0; });
    for (std::size_t s = 1; has_any[std::size_t(k)] && s < widened.size(); ++s)
      widen(&widened[s - 1].words[k * slice], &widened[s].words[k * slice], std::size_t(n[1]), row,
            widened[0].last_word);
  });
  forSlices(n[2], [&](int k) {
    std::vector<Word> united(slice);
    for (const BallRow& b : ball) {
      const int from_k = k + b.dk, first = std::max(0, -b.dj), last = std::min(n[1], n[1] - b.dj);
      if (from_k < 0 || from_k >= n[2] || !has_any[std::size_t(from_k)]) continue;
      const Word* from = &widened[std::size_t(b.half_width)].words[from_k * slice + (first + b.dj) * row];
      Word* to = &united[first * row];
      const std::size_t count = std::size_t(last - first) * row;
      for (std::size_t w = 0; w < count; ++w) to[w] |= from[w];
    }
    for (int j = 0; j < n[1]; ++j) unpackRow(&united[j * row], n[0], &out[mask.grid.index(0, j, k)]);
  });
  return out;
}

}  // namespace facenav::volume
