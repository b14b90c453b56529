#include "prior/prior_network.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/volume/for_slices.h"
#include "prior/convolution_kernel.h"
#include "prior/prior_features.h"

namespace facenav::segmentation {
namespace {

constexpr std::array<int, 3> kChannels{48, 64, 64};
constexpr int kFolded = 8, kBlocksPerLevel = 2;
constexpr float kSlope = 0.1f, kLeastVariance = 1e-5f;  // network.py, torch's InstanceNorm3d

/// Reads the tensors one after the other.
class Tensors {
 public:
  explicit Tensors(const std::vector<PriorTensor>& tensors) : tensors_(tensors) {}
  const PriorTensor& next(const std::vector<int>& size) {
    if (at_ == tensors_.size() || tensors_[at_].size != size)
      throw Error("the brain prior's weights are not of this network", {}, "install FaceNav anew");
    return tensors_[at_++];
  }
  bool areUsedUp() const { return at_ == tensors_.size(); }

 private:
  const std::vector<PriorTensor>& tensors_;
  std::size_t at_ = 0;
};

/// Reorders torch's weights (output, input, tap) as the kernel needs them.
std::vector<float> inBlocks(const PriorTensor& weights, int taps) {
  const int outputs = weights.size[0], inputs = weights.size[1];
  std::vector<float> ordered;
  ordered.reserve(weights.values.size());
  for (int block = 0; block < outputs; block += convolution::kBlock)
    for (int t = 0; t < taps; ++t)
      for (int i = 0; i < inputs; ++i)
        for (int o = block; o < block + convolution::kBlock; ++o)
          ordered.push_back(weights.values[(std::size_t(o) * inputs + i) * taps + t]);
  return ordered;
}

/// Convolution. The rim of the result is not zero.
Features convolved(const Features& in, const PriorTensor& weights) {
  const int taps = weights.size[2] * weights.size[3] * weights.size[4];
  const std::vector<float> ordered = inBlocks(weights, taps);
  Features out(in.size, weights.size[0]);
  convolution::Task all{};
  all.weights = ordered.data(), all.inputs = in.channels, all.outputs = out.channels, all.taps = taps;
  for (int t = 0; taps == convolution::kMostTaps && t < taps; ++t)
    all.shift[t] = in.row(t / 9 - 1, t / 3 % 3 - 1, t % 3 - 1) - in.row(0, 0, 0);
  volume::forSlices(in.size[0], [&](int x) {
    convolution::Task slice = all;
    slice.in = in.at(x, 0, 0), slice.out = out.at(x, 0, 0);
    slice.rows = in.row(x, in.size[1] - 1, in.size[2] - 1) + 1 - in.row(x, 0, 0);
    convolution::kernel().convolve(slice);
  });
  return out;
}

struct Moments {
  std::vector<double> sum, squares;
};

/// Sums of each channel, over all voxels but the rim.
Moments momentsOf(const Features& in) {
  const auto channels = std::size_t(in.channels);
  std::vector<Moments> by_slice(std::size_t(in.size[0]));
  volume::forSlices(in.size[0], [&](int x) {
    Moments& m = by_slice[std::size_t(x)];
    m.sum.assign(channels, 0), m.squares.assign(channels, 0);
    in.forSlice(x, [&](int, int y, int z) {
      const float* v = in.at(x, y, z);
      for (std::size_t c = 0; c < channels; ++c) m.sum[c] += v[c], m.squares[c] += double(v[c]) * v[c];
    });
  });
  Moments all = by_slice[0];
  for (std::size_t x = 1; x < by_slice.size(); ++x)
    for (std::size_t c = 0; c < channels; ++c)
      all.sum[c] += by_slice[x].sum[c], all.squares[c] += by_slice[x].squares[c];
  return all;
}

/// Applies instance normalisation and leaky rectifier; the rim becomes zero.
Features normalised(const Features& in, const PriorTensor& scale, const PriorTensor& offset) {
  const Moments moments = momentsOf(in);
  const double count = double(in.size[0]) * in.size[1] * in.size[2];
  std::vector<float> factor(std::size_t(in.channels)), shift(factor.size());
  for (std::size_t c = 0; c < factor.size(); ++c) {
    const double mean = moments.sum[c] / count;
    const double variance = std::max(0.0, moments.squares[c] / count - mean * mean);
    factor[c] = scale.values[c] / std::sqrt(float(variance) + kLeastVariance);
    shift[c] = offset.values[c] - float(mean) * factor[c];
  }
  Features out(in.size, in.channels);
  volume::forSlices(in.size[0], [&](int x) {
    out.forSlice(x, [&](int, int y, int z) {
      const float* from = in.at(x, y, z);
      float* to = out.at(x, y, z);
      for (std::size_t c = 0; c < factor.size(); ++c) {
        const float v = from[c] * factor[c] + shift[c];
        to[c] = std::max(v, kSlope * v);
      }
    });
  });
  return out;
}

Features blocks(Features x, int outputs, Tensors& tensors) {
  for (int b = 0; b < kBlocksPerLevel; ++b) {
    const auto& weights = tensors.next({outputs, x.channels, 3, 3, 3});
    const auto& scale = tensors.next({outputs});
    const auto& offset = tensors.next({outputs});
    x = normalised(convolved(x, weights), scale, offset);
  }
  return x;
}

/// Convolution over single voxels, with offset. The rim of the result is not zero.
Features narrowed(const Features& in, int outputs, Tensors& tensors) {
  const auto& weights = tensors.next({outputs, in.channels, 1, 1, 1});
  const auto& offset = tensors.next({outputs});
  Features out = convolved(in, weights);
  for (std::size_t v = 0; v < out.values.size(); ++v)
    out.values[v] += offset.values[v % std::size_t(outputs)];
  return out;
}

/// Maximum over blocks of 2 x 2 x 2.
Features halved(const Features& in) {
  Features out({in.size[0] / 2, in.size[1] / 2, in.size[2] / 2}, in.channels);
  volume::forSlices(out.size[0], [&](int slice) {
    out.forSlice(slice, [&](int x, int y, int z) {
      float* most = out.at(x, y, z);
      std::copy_n(in.at(2 * x, 2 * y, 2 * z), in.channels, most);
      for (int part = 1; part < kFolded; ++part) {
        const float* v = in.at(2 * x + part / 4, 2 * y + part / 2 % 2, 2 * z + part % 2);
        for (int c = 0; c < in.channels; ++c) most[c] = std::max(most[c], v[c]);
      }
    });
  });
  return out;
}

void addDoubled(const Features& coarse, Features& fine) {
  volume::forSlices(fine.size[0], [&](int slice) {
    fine.forSlice(slice, [&](int x, int y, int z) {
      float* sum = fine.at(x, y, z);
      const float* more = coarse.at(x / 2, y / 2, z / 2);
      for (int c = 0; c < fine.channels; ++c) sum[c] += more[c];
    });
  });
}

Features folded(const volume::Volume& window) {
  Features out({kPriorSize[0] / 2, kPriorSize[1] / 2, kPriorSize[2] / 2}, kFolded);
  for (int slice = 0; slice < out.size[0]; ++slice)
    out.forSlice(slice, [&](int x, int y, int z) {
      for (int part = 0; part < kFolded; ++part)
        out.at(x, y, z)[part] = window.at(2 * x + part / 4, 2 * y + part / 2 % 2, 2 * z + part % 2);
    });
  return out;
}

/// Converts scores of the last layer to shares on the window's grid.
PriorShares unfolded(const Features& scores, const volume::VoxelGrid& grid) {
  PriorShares all;
  for (auto& one : all) one.resize(grid.count());
  volume::forSlices(scores.size[0], [&](int slice) {
    scores.forSlice(slice, [&](int x, int y, int z) {
      for (int part = 0; part < kFolded; ++part) {
        const float* score = scores.at(x, y, z) + part * kPriorClasses;
        const float most = *std::max_element(score, score + kPriorClasses);
        std::array<float, kPriorClasses> share;
        float sum = 0;
        for (std::size_t c = 0; c < kPriorClasses; ++c) sum += share[c] = std::exp(score[c] - most);
        const auto at = grid.index(2 * x + part / 4, 2 * y + part / 2 % 2, 2 * z + part % 2);
        for (std::size_t c = 0; c < kPriorClasses; ++c) all[c][at] = share[c] / sum;
      }
    });
  });
  return all;
}

Features scoresOf(Features x, Tensors& tensors) {
  std::vector<Features> kept;
  for (std::size_t level = 0; level < kChannels.size(); ++level) {
    x = blocks(level ? halved(x) : std::move(x), kChannels[level], tensors);
    kept.push_back(x);
  }
  for (std::size_t level = kChannels.size() - 1; level-- > 0;) {
    addDoubled(narrowed(x, kChannels[level], tensors), kept[level]);
    x = blocks(std::move(kept[level]), kChannels[level], tensors);
  }
  return narrowed(x, kFolded * kPriorClasses, tensors);
}

}  // namespace

PriorNetwork::PriorNetwork(const std::filesystem::path& weights) : tensors_(readPriorWeights(weights)) {
  Tensors tensors(tensors_);
  scoresOf(Features({4, 4, 4}, kFolded), tensors);  // takes each tensor by its size
  if (!tensors.areUsedUp())
    throw Error("the brain prior's weights are not of this network", weights.string(),
                "install FaceNav anew");
}

PriorShares PriorNetwork::shares(const volume::Volume& window) const {
  FACENAV_EXPECT(window.grid.size == kPriorSize, "a window of the network's size");
  Tensors tensors(tensors_);
  return unfolded(scoresOf(folded(window), tensors), window.grid);
}

}  // namespace facenav::segmentation
