// facenav record and facenav rig new before live cameras, as a user runs them: two videos replace the
// cameras.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "facenav/capture/recording.h"
#include "support/board_film.h"
#include "support/command_line.h"

namespace facenav::testing {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;
namespace scene = coil_tracking::testing;

class RecordVerb : public ::testing::Test {
 protected:
  RecordVerb() { cameras::writeRig(rig_, folder_.path() / "stereo.yml"); }
  std::string at(const std::string& name) const { return "'" + (folder_.path() / name).string() + "'"; }
  std::string liveCameras() const {
    return "--left " + at("left.avi") + " --right " + at("right.avi") + " --calibration " + at("stereo.yml");
  }
  /// Writes both videos at 30 pictures a second; a counter in a corner makes all pictures differ.
  void film(const std::vector<cameras::StereoFrame>& frames) const {
    for (const bool is_left : {true, false}) {
      cv::VideoWriter writer((folder_.path() / (is_left ? "left.avi" : "right.avi")).string(),
                             cv::VideoWriter::fourcc('H', 'F', 'Y', 'U'), 30, {640, 480}, false);
      ASSERT_TRUE(writer.isOpened());
      int number = 0;
      for (const auto& frame : frames) {
        cv::Mat image = (is_left ? frame.left : frame.right).clone();
        image(cv::Rect(0, 0, 4, 4)).setTo(number++ % 251);
        writer.write(image);
      }
    }
  }
  void filmOf(int frames) const {
    film(std::vector<cameras::StereoFrame>(std::size_t(frames), boardFrame(rig_, 0)));
  }
  bool isTidy() const {
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      if (entry.path().filename().string().front() == '.') return false;
    return !fs::exists(folder_.path() / "recording");
  }

  TemporaryFolder folder_;
  cameras::StereoRig rig_ = scene::roomRig();
};

TEST_F(RecordVerb, EveryPairOfTwoVideosIsReadAndMissingOnesAreNamed) {
  filmOf(90);
  const auto whole = runFacenav("record " + liveCameras() + " --seconds 60 -o " + at("recording"));
  ASSERT_EQ(whole.status, 0) << whole.errors;
  EXPECT_THAT(whole.output, HasSubstr("90 pairs in 3.0 s"));
  EXPECT_EQ(capture::openRecording(folder_.path() / "recording").frame_count, 90);
  // As folders of pictures, two of which are missing.
  for (const std::string side : {"l", "r"}) {
    fs::create_directories(folder_.path() / side);
    for (int i = 0; i < 12; ++i)
      if (!(side == "r" && (i == 4 || i == 9)))
        cv::imwrite((folder_.path() / side / (std::to_string(100 + i) + ".png")).string(),
                    boardFrame(rig_, 0).left);
  }
  const auto gaps = runFacenav("record --left " + at("l") + " --right " + at("r") + " --calibration " +
                               at("stereo.yml") + " -o " + at("gaps"));
  ASSERT_EQ(gaps.status, 0) << gaps.errors;
  EXPECT_THAT(gaps.output, HasSubstr("10 pairs in 0.4 s"));
  EXPECT_THAT(gaps.output,
              HasSubstr("2 pairs are missing: the right file has no partner for left pictures 104, 109"));
  EXPECT_EQ(capture::openRecording(folder_.path() / "gaps").frame_count, 10);
}

TEST_F(RecordVerb, WritesARecordingThatOtherVerbsRead) {
  filmOf(90);
  const auto recorded =
      runFacenav("record " + liveCameras() + " --seconds 1 --capture plain -o " + at("recording"));
  ASSERT_EQ(recorded.status, 0) << recorded.errors;
  EXPECT_THAT(recorded.output, HasSubstr("pairs in 1."));
  const auto recording = capture::openRecording(folder_.path() / "recording");
  EXPECT_NEAR(double(recording.frame_count), 31, 10);
  EXPECT_NEAR(recording.frames_per_s, 30, 8);
  EXPECT_TRUE(recording.has_timestamps);
  EXPECT_TRUE(recording.capture);
  EXPECT_THAT(readText(folder_.path() / "recording/timestamps.csv"), HasSubstr("right_t_s"));
  EXPECT_EQ(fs::status(folder_.path() / "recording").permissions(), fs::perms::owner_all);
  ASSERT_EQ(runFacenav("rig new bar --calibration " + at("stereo.yml") + " --rigs " + at("rigs")).status, 0);
  const auto checked =
      runFacenav("rig check bar " + at("recording") + " --rigs " + at("rigs") + " " + kPrintedBoardOptions);
  EXPECT_EQ(checked.status, 0) << checked.errors << checked.output;
}

TEST_F(RecordVerb, KeepsWhatWasRecordedWhenTheCamerasEnd) {
  filmOf(20);
  const auto recorded = runFacenav("record " + liveCameras() + " --seconds 10 -o " + at("recording"));
  EXPECT_EQ(recorded.status, 0) << recorded.errors;
  EXPECT_GT(capture::openRecording(folder_.path() / "recording").frame_count, 10);
}

TEST_F(RecordVerb, SaysInOneLineWhyItCannotRecord) {
  filmOf(60);
  const auto expectLine = [&](const CommandResult& result, const std::string& words, int status = 1) {
    EXPECT_EQ(result.status, status);
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(words));
    EXPECT_TRUE(isTidy());
  };
  const std::string to = " -o " + at("recording");
  expectLine(runFacenav("record --quiet" + to), "it is not said which cameras", 2);
  expectLine(runFacenav("record --rig none --rigs " + at("rigs") + to), "there is no such rig");
  expectLine(runFacenav("record --left " + at("no.avi") + " --right " + at("right.avi") + " --calibration " +
                        at("stereo.yml") + to),
             "no.avi");
  expectLine(runFacenav("record --quiet " + liveCameras() + " --rate 1000 --seconds 7200" + to),
             "the disk has space for");
  // A file may not grow beyond 16 kB, as on a full disk: no partly written file remains.
  expectLine(runProgram("bash", "-c \"trap '' XFSZ; ulimit -f 16; '" + std::string(FACENAV_CLI) +
                                    "' record --quiet " + liveCameras() + " --seconds 1" + to + "\""),
             "cannot be written");
}

TEST_F(RecordVerb, TheBoardIsDrawnAtTrueSize) {
  const auto drawn = runFacenav("rig board --board 9x6 --square 20 -o " + at("board.svg"));
  ASSERT_EQ(drawn.status, 0) << drawn.errors;
  const std::string page = readText(folder_.path() / "board.svg");
  EXPECT_THAT(page, HasSubstr("width=\"297mm\""));
  EXPECT_THAT(page, HasSubstr("width=\"20.0000\" height=\"20.0000\""));
  EXPECT_EQ(runFacenav("rig board --square 60 -o " + at("large.svg")).status, 1);
  EXPECT_FALSE(fs::exists(folder_.path() / "large.svg"));
}

TEST_F(RecordVerb, ALiveBoardMakesARigFromViewsThatAreTakenByThemselves) {
  std::vector<cameras::StereoFrame> frames;
  const auto places = boardRound();
  for (std::size_t place = 0; place < 9; ++place) {
    const auto frame = heldBoardFrame(rig_, places[place], std::int64_t(place), 0);
    for (int i = 0; i < 18; ++i) frames.push_back(frame);
  }
  film(frames);
  const auto made =
      runFacenav("rig new bar --left-camera " + at("left.avi") + " --right-camera " + at("right.avi") +
                 " --size 640x480 --within 8 --rigs " + at("rigs") + " " + kPrintedBoardOptions);
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_THAT(made.errors, HasSubstr("view 5 taken; "));
  EXPECT_THAT(made.errors, HasSubstr("still missing: "));
  EXPECT_THAT(made.output, HasSubstr("640 x 480 px"));
  const auto checked = runFacenav("rig check bar --live 1 --rigs " + at("rigs") + " " + kPrintedBoardOptions);
  EXPECT_EQ(checked.status, 0) << checked.errors << checked.output;
}

}  // namespace
}  // namespace facenav::testing
