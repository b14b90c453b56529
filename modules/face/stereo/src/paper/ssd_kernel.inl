// Body of searchRows..., included by ssd_kernel_base.cpp and ssd_kernel_avx2.cpp inside an anonymous
// namespace.

// column[d] += (l_new - r_new[d])^2 - (l_old - r_old[d])^2, differences truncated.
inline void slideColumn(std::uint16_t* __restrict column, int l_new, const std::uint8_t* __restrict r_new,
                        int l_old, const std::uint8_t* __restrict r_old, int disparities) {
  const std::int16_t added_left = std::int16_t(l_new), removed_left = std::int16_t(l_old);
  for (int d = 0; d < disparities; ++d) {
    std::int16_t added = std::int16_t(added_left - r_new[d]), removed = std::int16_t(removed_left - r_old[d]);
    added = added < 0 ? std::int16_t(-added) : added;
    removed = removed < 0 ? std::int16_t(-removed) : removed;
    added = added > kLargestDifference ? std::int16_t(kLargestDifference) : added;
    removed = removed > kLargestDifference ? std::int16_t(kLargestDifference) : removed;
    column[d] = std::uint16_t(column[d] + added * added - removed * removed);
  }
}

inline void addToColumn(std::uint16_t* __restrict column, int left, const std::uint8_t* __restrict right,
                        int disparities) {
  const std::int16_t l = std::int16_t(left);
  for (int d = 0; d < disparities; ++d) {
    std::int16_t difference = std::int16_t(l - right[d]);
    difference = difference < 0 ? std::int16_t(-difference) : difference;
    difference = difference > kLargestDifference ? std::int16_t(kLargestDifference) : difference;
    column[d] = std::uint16_t(column[d] + difference * difference);
  }
}

// One block of 16 disparities: slides the box sum, keeps the right image's best match, returns the least
// cost.
inline std::uint16_t slideBlock(std::uint16_t* __restrict box, const std::uint16_t* __restrict entering,
                                const std::uint16_t* __restrict leaving, std::uint16_t* __restrict right_cost,
                                std::uint16_t* __restrict right_match, std::uint16_t x) {
  std::uint16_t least = kNoCost;
  for (int d = 0; d < kDisparityBlock; ++d) {
    const std::uint16_t cost = std::uint16_t(box[d] + entering[d] - leaving[d]);
    box[d] = cost;
    right_match[d] = cost < right_cost[d] ? x : right_match[d];
    right_cost[d] = cost < right_cost[d] ? cost : right_cost[d];
    least = cost < least ? cost : least;
  }
  return least;
}

inline std::uint16_t blockMinimum(const std::uint16_t* box) {
  std::uint16_t least = kNoCost;
  for (int d = 0; d < kDisparityBlock; ++d) least = box[d] < least ? box[d] : least;
  return least;
}

// The disparity of the least cost, or -1 where another one (not next to it) is about as good.
inline int uniqueMinimum(std::uint16_t* box, std::uint16_t* block_least, int disparities, int uniqueness) {
  const int blocks = disparities / kDisparityBlock;
  int best_block = 0;
  for (int i = 1; i < blocks; ++i)
    if (block_least[i] < block_least[best_block]) best_block = i;
  const std::uint16_t least = block_least[best_block];
  int best = best_block * kDisparityBlock;
  while (box[best] != least) ++best;
  const int first = best > 2 ? best - 2 : 0, last = best + 2 < disparities - 1 ? best + 2 : disparities - 1;
  std::uint16_t kept[5];
  for (int d = first; d <= last; ++d) {
    kept[d - first] = box[d];
    box[d] = kNoCost;
  }
  for (int i = first / kDisparityBlock; i <= last / kDisparityBlock; ++i)
    block_least[i] = blockMinimum(box + i * kDisparityBlock);
  std::uint16_t second = kNoCost;
  for (int i = 0; i < blocks; ++i) second = block_least[i] < second ? block_least[i] : second;
  for (int d = first; d <= last; ++d) box[d] = kept[d - first];
  return (int(second) - int(least)) * 256 > uniqueness * int(least) ? best : -1;
}

inline void searchRows(const Images& im, const Scratch& s, int first, int last, int uniqueness,
                       std::int16_t* out, int out_stride) {
  const int half = im.half, columns = im.width + 2 * half, n = im.disparities, blocks = n / kDisparityBlock;
  // Column i stands for image column i - half; left and right images are padded by `half` columns on both
  // sides.
  const auto left_row = [&](int y) { return im.left + y * im.left_stride; };
  const auto right_at = [&](int y, int column) {
    return im.right_mirrored + y * im.right_stride + (columns - 1 - column);
  };
  for (int i = 0; i < columns * n; ++i) s.column[i] = 0;
  for (int y = first - half; y < first + half;
       ++y)  // the row above `first + half`: the first slide adds that one
    for (int c = 0; c < columns; ++c) addToColumn(s.column + c * n, left_row(y)[c], right_at(y, c), n);
  std::uint16_t block_least[256];
  for (int y = first; y < last; ++y) {
    for (int i = 0; i < im.width + n; ++i) s.right_cost[i] = kNoCost;
    for (int d = 0; d < n; ++d) s.box[d] = 0;
    std::int16_t* row = out + y * out_stride;
    for (int c = 0; c < columns; ++c) {
      std::uint16_t* column = s.column + c * n;
      if (y == first)
        addToColumn(column, left_row(y + half)[c], right_at(y + half, c), n);
      else
        slideColumn(column, left_row(y + half)[c], right_at(y + half, c), left_row(y - half - 1)[c],
                    right_at(y - half - 1, c), n);
      if (c < 2 * half) {
        for (int d = 0; d < n; ++d) s.box[d] = std::uint16_t(s.box[d] + column[d]);
        continue;
      }
      const int x = c - 2 * half;
      const std::uint16_t* leaving = x == 0 ? nullptr : s.column + (x - 1) * n;
      const int mirrored = im.width - 1 - x;
      for (int i = 0; i < blocks; ++i) {
        const int d = i * kDisparityBlock;
        block_least[i] =
            slideBlock(s.box + d, column + d, leaving ? leaving + d : s.zeros, s.right_cost + mirrored + d,
                       s.right_match + mirrored + d, std::uint16_t(x));
      }
      row[x] = std::int16_t(uniqueMinimum(s.box, block_least, n, uniqueness));
    }
    for (int x = 0; x < im.width; ++x)
      if (row[x] >= 0) {
        const int difference = int(s.right_match[im.width - 1 - x + row[x]]) - x;
        if (difference < -1 || difference > 1) row[x] = -1;
      }
  }
}
