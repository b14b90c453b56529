// Body of the "sgm" step, included by sgm_kernel_base.cpp and sgm_kernel_avx2.cpp inside an anonymous
// namespace.

inline std::int16_t lesser(std::int16_t a, std::int16_t b) { return a < b ? a : b; }

inline std::int16_t step(const std::uint8_t* __restrict cost, const std::int16_t* __restrict before,
                         std::int16_t least_before, std::int16_t small_step, std::int16_t large_step,
                         int disparities, std::int16_t* __restrict now, std::int16_t* __restrict total) {
  std::int16_t least = kFar;
  const std::int16_t jump = std::int16_t(least_before + large_step);
  for (int d = 0; d < disparities; ++d) {
    const std::int16_t beside = std::int16_t(lesser(before[d - 1], before[d + 1]) + small_step);
    const std::int16_t best = lesser(lesser(before[d], jump), beside);
    const std::int16_t path = std::int16_t(cost[d] + best - least_before);
    now[d] = path;
    total[d] = std::int16_t(total[d] + path);
    least = lesser(least, path);
  }
  return least;
}

inline void distances(std::uint64_t left, const std::uint64_t* right, int count, std::uint8_t* out) {
  for (int d = 0; d < count; ++d) out[d] = std::uint8_t(__builtin_popcountll(left ^ right[-d]));
}
