#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "prior/prior_network.h"
#include "prior_pattern.h"
#include "support/run_program.h"
#include "support/test_data.h"

// The training program on balls: a few steps, a stop, a few more. The network here reads its output.

namespace facenav::segmentation {
namespace {

const std::string kPython = "/usr/bin/python3";
constexpr int kSmoke_s = 300;  // it takes 25 s of processor time

bool isTorchThere() { return testing::runProgram(kPython, "-c 'import torch, scipy, nibabel'").status == 0; }

struct Expected {
  int i = 0, j = 0, k = 0;
  float share[kPriorClasses] = {};
};

/// Reads the values that expected.py prints.
std::vector<Expected> expectedIn(const std::filesystem::path& header) {
  std::vector<Expected> all;
  std::ifstream stream(header);
  for (std::string line; std::getline(stream, line);) {
    Expected e;
    float* s = e.share;
    if (std::sscanf(line.c_str(), " {%d, %d, %d, {%ff, %ff, %ff, %ff}}", &e.i, &e.j, &e.k, s, s + 1, s + 2,
                    s + 3) == 7)
      all.push_back(e);
  }
  return all;
}

TEST(BrainPriorTraining, TrainsStopsGoesOnAndItsWeightsGiveTorchsProbabilitiesHere) {
  if (!isTorchThere()) GTEST_SKIP() << "needs Debian's python3-torch, python3-scipy and python3-nibabel";
  const testing::TemporaryFolder folder;
  const auto script = std::filesystem::path(FACENAV_SOURCE_DIR) / "resources/training/brain_prior/smoke.py";
  const auto run =
      testing::runProgram(kPython, "-B '" + script.string() + "' '" + folder.path().string() + "'", kSmoke_s);
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.output.find("{\"step\": 2, \"heads\": 4,"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("{\"step\": 4, \"heads\": 8,"), std::string::npos) << run.output;  // it continued
  EXPECT_NE(run.output.find("{\"step\": 1, \"heads\": 2,"), std::string::npos)
      << run.output;  // from another start
  const auto expected = expectedIn(folder.path() / "expected.h");
  ASSERT_GE(expected.size(), 8u);
  const volume::Volume window = pattern();
  const PriorShares found = PriorNetwork(folder.path() / "weights.fnbp").shares(window);
  for (const auto& e : expected)
    for (int c = 0; c < kPriorClasses; ++c)
      EXPECT_NEAR(found[std::size_t(c)][window.grid.index(e.i, e.j, e.k)], e.share[c], 1e-4)
          << e.i << " " << e.j << " " << e.k << ", class " << c;
}

}  // namespace
}  // namespace facenav::segmentation
