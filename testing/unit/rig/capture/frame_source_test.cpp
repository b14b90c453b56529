#include <gtest/gtest.h>

#include "support/frame_source_contract.h"
#include "support/recordings.h"
#include "support/test_data.h"

using namespace facenav;
namespace support = facenav::testing;

TEST(RecordingSource, KeepsTheContractOfFrameSources) {
  support::TemporaryFolder folder;
  support::writeSmallRecording(folder.path() / "rec", 5, 3);
  const auto recording = capture::openRecording(folder.path() / "rec");
  support::expectFrameSourceContract([&] { return capture::makeSource(recording); });
}
