#include "facenav/session/recorder.h"

#include <gtest/gtest.h>

#include "facenav/capture/recording.h"
#include "session_fakes.h"
#include "support/test_data.h"

namespace facenav::session {
namespace {

TEST(Recorder, WhatWasAddedIsReadBackWhole) {
  testing::TemporaryFolder folder;
  Recorder recorder(folder.path() / "recording", fakes::rig());
  for (int i = 0; i < 5; ++i) recorder.add(fakes::frame(i, i * 0.02));
  recorder.close();
  EXPECT_EQ(recorder.written(), 5u);
  EXPECT_EQ(recorder.failure(), "");
  const auto recording = capture::openRecording(folder.path() / "recording");
  EXPECT_EQ(recording.frame_count, 5);
  auto source = capture::makeSource(recording);
  source->next();
  EXPECT_NEAR(source->next()->captured.s, 0.02, 1e-6);
}

TEST(Recorder, LeavesFramesOutRatherThanWait) {
  testing::TemporaryFolder folder;
  Recorder recorder(folder.path() / "recording", fakes::rig(), 2);
  for (int i = 0; i < 500; ++i) recorder.add(fakes::frame(i, i * 0.001));
  recorder.close();
  EXPECT_EQ(recorder.written() + recorder.leftOut(), 500u);
  EXPECT_GT(recorder.leftOut(), 0u);
}

TEST(Recorder, AnAbandonedRecordingLeavesNothingBehind) {
  testing::TemporaryFolder folder;
  {
    Recorder recorder(folder.path() / "recording", fakes::rig());
    recorder.add(fakes::frame(0, 0));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace facenav::session
