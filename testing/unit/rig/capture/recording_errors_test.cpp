#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <opencv2/imgcodecs.hpp>

#include "facenav/capture/recording.h"
#include "facenav/core/error.h"
#include "support/recordings.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::capture;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;
namespace support = facenav::testing;

namespace {

// The message after opening (and playing) a valid recording of 4 frames that `damage` has changed.
std::string messageAfter(const std::function<void(const fs::path&)>& damage) {
  support::TemporaryFolder folder;
  const fs::path rec = folder.path() / "rec";
  support::writeSmallRecording(rec);
  damage(rec);
  try {
    const auto source = makeSource(openRecording(rec));
    while (source->next()) {
    }
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

void truncate(const fs::path& path) { fs::resize_file(path, fs::file_size(path) / 2); }

}  // namespace

TEST(RecordingErrors, NameWhatIsMissing) {
  EXPECT_EQ(messageAfter([](const fs::path&) {}), "no error");
  EXPECT_THAT(messageAfter([](const fs::path& rec) { fs::remove(rec / "stereo.yml"); }),
              HasSubstr("stereo.yml"));
  EXPECT_THAT(messageAfter([](const fs::path& rec) { fs::remove_all(rec); }), HasSubstr("does not exist"));
  EXPECT_THAT(messageAfter([](const fs::path& rec) { fs::remove_all(rec / "right"); }), HasSubstr("'right'"));
  EXPECT_THAT(messageAfter([](const fs::path& rec) { fs::remove(rec / "capture" / "plain_right.png"); }),
              HasSubstr("plain_right"));
}

// The folder vanishes after the recording was opened, as if its disk was unplugged.
TEST(RecordingErrors, AFolderThatHasVanishedIsSaidToBeMissing) {
  const auto messageOfStart = [](const std::function<void(const fs::path&)>& damage) {
    support::TemporaryFolder folder;
    const fs::path rec = folder.path() / "rec";
    support::writeSmallRecording(rec);
    const Recording recording = openRecording(rec);
    damage(rec);
    try {
      makeSource(recording);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const auto emptied = [](const fs::path& rec) {
    fs::remove_all(rec);
    fs::create_directory(rec);
  };
  EXPECT_EQ(messageOfStart([](const fs::path&) {}), "no error");
  EXPECT_THAT(messageOfStart([](const fs::path& rec) { fs::remove_all(rec); }),
              AllOf(HasSubstr("folder is missing"), HasSubstr("/rec"), Not(HasSubstr("0 frames"))));
  EXPECT_THAT(messageOfStart(emptied),
              AllOf(HasSubstr("folder is empty"), HasSubstr("/rec"), Not(HasSubstr("0 frames"))));
  EXPECT_THAT(messageAfter(emptied), HasSubstr("folder is empty")) << "before it was opened";
}

TEST(RecordingErrors, CountsAndNumbersMustAgree) {
  EXPECT_THAT(messageAfter([](const fs::path& rec) { fs::remove(rec / "right" / "000003.png"); }),
              AllOf(HasSubstr("counts differ"), HasSubstr("4 images"), HasSubstr("3 in right")));
  EXPECT_THAT(messageAfter([](const fs::path& rec) {
                fs::rename(rec / "right" / "000002.png", rec / "right" / "000009.png");
              }),
              HasSubstr("numbers differ"));
  EXPECT_THAT(messageAfter([](const fs::path& rec) {
                for (const char* side : {"left", "right"})
                  for (const char* name : {"000000.png", "000001.png", "000002.png", "000003.png"})
                    fs::remove(rec / side / name);
              }),
              HasSubstr("0 frames"));
  EXPECT_THAT(messageAfter(
                  [](const fs::path& rec) { fs::copy(rec / "left" / "000002.png", rec / "left" / "2.png"); }),
              HasSubstr("two images have the number 2"));
}

TEST(RecordingErrors, ImagesMustFitTheRigAndBeWhole) {
  const auto overwrite = [](const char* name, int width) {
    return [=](const fs::path& rec) { cv::imwrite(rec / name, support::noiseImage(1, width)); };
  };
  EXPECT_THAT(messageAfter(overwrite("left/000000.png", 32)),
              AllOf(HasSubstr("32 x 48"), HasSubstr("64 x 48")));
  EXPECT_THAT(messageAfter(overwrite("right/000002.png", 32)), HasSubstr("32 x 48"));
  EXPECT_THAT(messageAfter(overwrite("capture/plain_left.png", 32)), HasSubstr("plain_left.png"));
  EXPECT_THAT(messageAfter([](const fs::path& rec) { truncate(rec / "right" / "000001.png"); }),
              AllOf(HasSubstr("truncated"), HasSubstr("right/000001.png")));
  EXPECT_THAT(messageAfter([](const fs::path& rec) {
                std::ofstream(rec / "right" / "000001.png") << "this is no image";
              }),
              AllOf(HasSubstr("decoded"), HasSubstr("right/000001.png")));
  EXPECT_THAT(messageAfter([](const fs::path& rec) {
                for (const char* side : {"left", "right"}) {
                  fs::remove(rec / side / "000001.png");
                  cv::imwrite(rec / side / "000001.jpg", support::noiseImage(3));
                  truncate(rec / side / "000001.jpg");
                }
              }),
              AllOf(HasSubstr("truncated"), HasSubstr("left/000001.jpg")));
}

TEST(RecordingErrors, TimestampsNameTheirLine) {
  const auto csv = [](const std::string& text) {
    return messageAfter([&](const fs::path& rec) { std::ofstream(rec / "timestamps.csv") << text; });
  };
  EXPECT_EQ(csv("frame,t_s\n0,0\n1,1\n2,2\n3,3"), "no error");
  EXPECT_THAT(csv("frame,t_s\n0,0\n1,x\n2,2\n3,3\n"),
              AllOf(HasSubstr("timestamps.csv, line 3"), HasSubstr("'x'")));
  EXPECT_THAT(csv("frame,t_s\n0,0\n1\n2,2\n3,3\n"), HasSubstr("line 3"));
  EXPECT_THAT(csv("frame,t_s\n0,0\n1,2\n2,2\n3,3\n"), AllOf(HasSubstr("line 4"), HasSubstr("rise")));
  EXPECT_THAT(csv("frame,t_s\n0,0\n1,1\n2,nan\n3,3\n"), HasSubstr("line 4"));
  EXPECT_THAT(csv("frame,t_s\n0,0\n1.5,1\n2,2\n3,3\n"), HasSubstr("line 3"));
  EXPECT_THAT(csv("frame,time\n0,0\n"), HasSubstr("'t_s'"));
  EXPECT_THAT(csv("frame,t_s\n0,0\n1,1\n2,2\n"), AllOf(HasSubstr("3 lines"), HasSubstr("4 frames")));
  EXPECT_THAT(csv(""), HasSubstr("empty"));
}

TEST(RecordingErrors, DamagedVideoIsNamed) {
  EXPECT_THAT(messageAfter([](const fs::path& rec) {
                for (const char* side : {"left", "right"}) fs::remove_all(rec / side);
                std::ofstream(rec / "left.mkv") << "no video";
                std::ofstream(rec / "right.mkv") << "no video";
              }),
              HasSubstr("left.mkv"));
}

TEST(RecordingErrors, TruthMustBeUnitQuaternions) {
  support::TemporaryFolder folder;
  std::ofstream(folder.path() / "head.csv")
      << "frame,tx,ty,tz,qw,qx,qy,qz\n0,1,2,3,1,0,0,0\n1,1,2,3,0.5,0,0,0\n";
  try {
    readTruth(folder.path() / "head.csv");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("line 3"));
  }
}
