#include "prior/prior_network.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "prior/convolution_kernel.h"
#include "prior_expected.h"
#include "prior_pattern.h"
#include "support/test_data.h"

namespace facenav::segmentation {
namespace {

std::filesystem::path weights() {
  return std::filesystem::path(FACENAV_SOURCE_DIR) / "Data/brain_prior/weights.fnbp";
}

std::string content() {
  std::ifstream stream(weights(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(PriorNetwork, GivesTorchsProbabilities) {
  const volume::Volume window = pattern();
  const PriorShares found = PriorNetwork(weights()).shares(window);
  for (const auto& e : kExpectedByTorch)
    for (int c = 0; c < kPriorClasses; ++c)
      EXPECT_NEAR(found[std::size_t(c)][window.grid.index(e.i, e.j, e.k)], e.share[c], 1e-4)
          << e.i << " " << e.j << " " << e.k << ", class " << c;
}

std::string faultOf(const std::filesystem::path& file) {
  try {
    PriorNetwork{file};
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(PriorNetwork, RefusesWeightsThatAreNotWholeAndSaysWhere) {
  const testing::TemporaryFolder folder;
  const auto file = folder.path() / "weights.fnbp";
  const auto faultWith = [&](const std::string& bytes) {
    writeWholeFile(file, bytes);
    return faultOf(file);
  };
  std::string damaged = content();
  ASSERT_GT(damaged.size(), 1000u);
  damaged[damaged.size() / 2] = char(damaged[damaged.size() / 2] ^ 1);
  EXPECT_NE(faultWith(damaged).find("is damaged"), std::string::npos);
  EXPECT_NE(faultWith(content().substr(0, 1000)).find("is damaged"), std::string::npos);
  EXPECT_NE(faultWith("FNBP").find("ends too early"), std::string::npos);
  EXPECT_NE(faultOf(file).find(file.string()), std::string::npos);
  EXPECT_NE(faultOf(folder.path() / "absent").find("are missing"), std::string::npos);
}

/// Convolution by its definition, in double precision.
std::vector<double> plainlyConvolved(const convolution::Task& task) {
  std::vector<double> out;
  for (std::ptrdiff_t row = 0; row < task.rows; ++row)
    for (int o = 0; o < task.outputs; ++o) {
      double sum = 0;
      for (int t = 0; t < task.taps; ++t)
        for (int i = 0; i < task.inputs; ++i)
          sum += double(task.in[(row + task.shift[t]) * task.inputs + i]) *
                 task.weights[((o / 16 * task.taps + t) * task.inputs + i) * 16 + o % 16];
      out.push_back(sum);
    }
  return out;
}

TEST(ConvolutionKernel, IsAConvolutionOnEachInstructionSet) {
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  convolution::Task task{};
  task.inputs = 8, task.outputs = 32, task.taps = 3, task.rows = 19;
  task.shift[0] = -2, task.shift[2] = 5;
  std::vector<float> in(std::size_t(task.inputs) * 40), weights(32 * 3 * 8);
  for (auto* values : {&in, &weights})
    for (float& v : *values) v = normal(random);
  task.in = in.data() + 10 * task.inputs, task.weights = weights.data();
  const auto expected = plainlyConvolved(task);
  for (const auto& kernel : {convolution::baseKernel(), convolution::kernel()}) {
    std::vector<float> out(expected.size());
    task.out = out.data();
    kernel.convolve(task);
    for (std::size_t n = 0; n < out.size(); ++n) ASSERT_NEAR(out[n], expected[n], 1e-4) << n;
  }
}

}  // namespace
}  // namespace facenav::segmentation
