#include <gtest/gtest.h>

#include <cstdlib>

#include "facenav/segmentation/segmenter.h"
#include "head_phantom.h"
#include "support/test_data.h"

// Of its own: the weights are read once in a process.

namespace facenav {
namespace {

TEST(BrainSegmenter, GrowsTheBrainWithoutThePriorAndSaysSo) {
  const testing::TemporaryFolder nothing;
  ASSERT_EQ(setenv("FACENAV_DATA", nothing.path().c_str(), 1), 0);
  const auto head = testing::makeHeadPhantom();
  TaskMonitor monitor;
  const auto result = segmentation::makeBrainSegmenter()->segment(head.volume, monitor);
  EXPECT_GE(volume::overlap(result.mask, head.brain).dice, 0.98);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(result.warnings.back().find("without the learned brain prior"), std::string::npos);
}

}  // namespace
}  // namespace facenav
