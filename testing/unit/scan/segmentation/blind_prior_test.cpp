#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdlib>
#include <cstring>

#include "facenav/core/whole_file.h"
#include "facenav/segmentation/segmenter.h"
#include "head_phantom.h"
#include "support/test_data.h"

// The prior's weights are installed, but its network finds no brain. A separate program, since the weights
// are read once in a process.

namespace facenav {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

/// The installed weights with the last layer's offsets for brain as low as half precision allows.
std::string blindWeights() {
  constexpr std::size_t kParts = 8, kClasses = 4, kBrain = 1, kChecksum = 4;
  constexpr std::uint16_t kLowest = 0xFBFF;
  std::string bytes =
      readWholeFile(std::filesystem::path(FACENAV_SOURCE_DIR) / "Data/brain_prior/weights.fnbp");
  bytes.resize(bytes.size() - kChecksum);
  const std::size_t offsets = bytes.size() - kParts * kClasses * sizeof kLowest;
  for (std::size_t part = 0; part < kParts; ++part)
    std::memcpy(&bytes[offsets + (part * kClasses + kBrain) * sizeof kLowest], &kLowest, sizeof kLowest);
  const auto sum = std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size())));
  return bytes.append(reinterpret_cast<const char*>(&sum), kChecksum);
}

class BlindPrior : public ::testing::Test {
 protected:
  BlindPrior() {
    std::filesystem::create_directory(data_.path() / "brain_prior");
    writeWholeFile(data_.path() / "brain_prior/weights.fnbp", blindWeights());
    setenv("FACENAV_DATA", data_.path().c_str(), 1);
  }
  testing::TemporaryFolder data_;
  testing::HeadPhantom head_ = testing::makeHeadPhantom();
  TaskMonitor monitor_;
};

TEST_F(BlindPrior, LeavesTheBrainToGrowthAloneWithAWarning) {
  const auto result = segmentation::makeBrainSegmenter()->segment(head_.volume, monitor_);
  EXPECT_GE(volume::overlap(result.mask, head_.brain).dice, 0.98);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("the learned brain prior sees no brain in this scan")));
}

TEST_F(BlindPrior, TellsNoPadsFromSkinAndTheHeadsWarningsSaySo) {
  EXPECT_THAT(segmentation::makeHeadSegmenter()->segment(head_.volume, monitor_).warnings,
              Contains(AllOf(HasSubstr("pads and earphones could not be told from skin"),
                             HasSubstr("found no brain"))));
}

}  // namespace
}  // namespace facenav
