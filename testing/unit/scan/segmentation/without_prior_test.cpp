#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "facenav/segmentation/segmenter.h"
#include "head_phantom.h"
#include "support/skin_phantom.h"
#include "support/test_data.h"

// A separate program, since the weights are read once in a process.

namespace facenav {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

void removePrior() {
  const testing::TemporaryFolder nothing;
  ASSERT_EQ(setenv("FACENAV_DATA", nothing.path().c_str(), 1), 0);
}

TEST(BrainSegmenter, GrowsTheBrainWithoutThePriorAndSaysSo) {
  removePrior();
  const auto head = testing::makeHeadPhantom();
  TaskMonitor monitor;
  const auto result = segmentation::makeBrainSegmenter()->segment(head.volume, monitor);
  EXPECT_GE(volume::overlap(result.mask, head.brain).dice, 0.98);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(result.warnings.back().find("without the learned brain prior"), std::string::npos);
}

TEST(HeadSegmenter, SaysThatPadsAreNotToldFromSkinWithoutThePrior) {
  removePrior();
  TaskMonitor monitor;
  const auto mr = testing::SkinPhantom().scan({2, 2, 2});
  EXPECT_THAT(segmentation::makeHeadSegmenter()->segment(mr, monitor).warnings,
              Contains(AllOf(HasSubstr("pads and earphones could not be told from skin"),
                             HasSubstr("is missing or damaged"))));
}

TEST(HeadSegmenter, NeedsNoPriorForACt) {
  removePrior();
  testing::SkinPhantom tissue;
  tissue.dermis_mm = 0, tissue.fat_level = 1000, tissue.brain_level = 1040, tissue.offset = -1000;
  auto ct = tissue.scan({2, 2, 2});
  ct.modality = "CT";
  TaskMonitor monitor;
  EXPECT_THAT(segmentation::makeHeadSegmenter()->segment(ct, monitor).warnings,
              Not(Contains(HasSubstr("pads and earphones"))));
}

}  // namespace
}  // namespace facenav
