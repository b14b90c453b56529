// A frame source -> a recording.

#include "facenav/setup/record_live.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "support/test_data.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;
namespace fakes = session::fakes;
using ::testing::HasSubstr;

/// Frames 1/30 s apart; the right picture is 4 ms late.
class LateSource : public fakes::Source {
 public:
  explicit LateSource(int frames, int fails_at = -1) : Source(frames, 1 / 30.0, fails_at) {}
  std::shared_ptr<const cameras::StereoFrame> next() override {
    const auto frame = Source::next();
    if (!frame) return nullptr;
    auto late = *frame;
    late.right_late_s = 0.004;
    return std::make_shared<cameras::StereoFrame>(late);
  }
};

RecordRequest requestIn(const testing::TemporaryFolder& folder, double seconds) {
  RecordRequest request;
  request.folder = folder.path() / "recording";
  request.seconds = seconds;
  return request;
}

TEST(RecordLive, WritesTheDriversTimesForAsLongAsAsked) {
  const testing::TemporaryFolder folder;
  LateSource source(1000);
  TaskMonitor monitor;
  const auto outcome = recordLive(source, requestIn(folder, 1.0), monitor);
  EXPECT_EQ(outcome.frames, 31);
  EXPECT_NEAR(outcome.seconds, 1.0, 1e-9);
  EXPECT_NEAR(outcome.rate, 30.0, 1e-6);
  ASSERT_TRUE(outcome.right_late_ms);
  EXPECT_NEAR(*outcome.right_late_ms, 4.0, 1e-9);
  EXPECT_THAT(outcome.words(), HasSubstr("31 pairs in 1.0 s"));
  const auto recording = capture::openRecording(folder.path() / "recording");
  EXPECT_EQ(recording.frame_count, 31);
  EXPECT_FALSE(recording.capture);
  const auto frames = capture::makeSource(recording);
  frames->next();
  const auto second = frames->next();
  EXPECT_NEAR(second->captured.s, 1 / 30.0, 1e-8);
  EXPECT_NEAR(second->right_late_s.value(), 0.004, 1e-8);
}

TEST(RecordLive, ThePlainPairGoesIntoTheCaptureWithoutDots) {
  const testing::TemporaryFolder folder;
  LateSource source(100);
  TaskMonitor monitor;
  auto request = requestIn(folder, 0.2);
  request.keeps_first_as_plain = true;
  recordLive(source, request, monitor);
  EXPECT_TRUE(fs::exists(request.folder / "capture/plain_left.png"));
  EXPECT_FALSE(fs::exists(request.folder / "capture/pattern_left.png"));
  EXPECT_TRUE(capture::openRecording(request.folder).capture);
}

TEST(RecordLive, ACameraThatFailsEndsItAndWhatWasThereIsKept) {
  const testing::TemporaryFolder folder;
  LateSource source(100, 7);
  TaskMonitor monitor;
  const auto outcome = recordLive(source, requestIn(folder, 2.0), monitor);
  EXPECT_EQ(outcome.frames, 7);
  EXPECT_THAT(outcome.ended_by, HasSubstr("cannot be read"));
  EXPECT_EQ(capture::openRecording(folder.path() / "recording").frame_count, 7);
}

TEST(RecordLive, WithoutAFrameNothingIsLeftBehind) {
  const testing::TemporaryFolder folder;
  TaskMonitor monitor;
  LateSource none(0), broken(5, 0);
  EXPECT_THROW(recordLive(none, requestIn(folder, 1), monitor), Error);
  EXPECT_THROW(recordLive(broken, requestIn(folder, 1), monitor), Error);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(RecordLive, ACancelKeepsWhatWasRecorded) {
  const testing::TemporaryFolder folder;
  LateSource source(1000);
  TaskMonitor* to_cancel = nullptr;
  TaskMonitor monitor([&](const std::string&, double fraction) {
    if (fraction > 0.5) to_cancel->cancel();
  });
  to_cancel = &monitor;
  const auto outcome = recordLive(source, requestIn(folder, 2.0), monitor);
  EXPECT_EQ(outcome.ended_by, "stopped by the user");
  EXPECT_NEAR(outcome.seconds, 1.0, 0.1);
  EXPECT_EQ(capture::openRecording(folder.path() / "recording").frame_count, outcome.frames);
}

TEST(RecordLive, ATimeThatTheDiskCannotHoldIsRefusedBeforehand) {
  const testing::TemporaryFolder folder;
  LateSource source(1000);
  TaskMonitor monitor;
  auto request = requestIn(folder, 1e12);
  std::string words;
  try {
    recordLive(source, request, monitor);
  } catch (const Error& error) {
    words = error.what();
  }
  EXPECT_THAT(words, HasSubstr("the disk has space for"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace facenav::steps
