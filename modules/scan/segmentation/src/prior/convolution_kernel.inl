// Included by one translation unit per instruction set. Six rows by sixteen channels are summed in registers.

using Lanes = float __attribute__((vector_size(32)));

/// Eight floats from any address.
inline Lanes eightOf(const float* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

constexpr int kRows = 6;

/// `count` rows from `first` on, output channels of block `block`.
template <int count>
void convolveRows(const Task& task, std::ptrdiff_t first, int block) {
  Lanes low[count] = {}, high[count] = {};
  const float* weights = task.weights + std::ptrdiff_t(block) * task.taps * task.inputs * kBlock;
  for (int tap = 0; tap < task.taps; ++tap) {
    const float* in = task.in + (first + task.shift[tap]) * task.inputs;
    for (int i = 0; i < task.inputs; ++i, weights += kBlock) {
      const Lanes a = eightOf(weights), b = eightOf(weights + 8);
      for (int r = 0; r < count; ++r) {
        const float value = in[r * std::ptrdiff_t(task.inputs) + i];
        low[r] += value * a;
        high[r] += value * b;
      }
    }
  }
  for (int r = 0; r < count; ++r) {
    float* out = task.out + (first + r) * task.outputs + block * kBlock;
    __builtin_memcpy(out, &low[r], sizeof low[r]);
    __builtin_memcpy(out + 8, &high[r], sizeof high[r]);
  }
}

void convolve(const Task& task) {
  for (int block = 0; block < task.outputs / kBlock; ++block) {
    std::ptrdiff_t row = 0;
    for (; row + kRows <= task.rows; row += kRows) convolveRows<kRows>(task, row, block);
    for (; row < task.rows; ++row) convolveRows<1>(task, row, block);
  }
}
