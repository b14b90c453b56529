// facenav cameras and facenav rig, as a user runs them: from files and streams, without a camera.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "facenav/capture/recording.h"
#include "facenav/capture/rig_store.h"
#include "facenav/casefile/case_store.h"
#include "support/ball_case.h"
#include "support/board_scene.h"
#include "support/command_line.h"
#include "support/jpeg_server.h"
#include "unit/track/coil_tracking/tracked_once.h"

namespace facenav::testing {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;
namespace scene = coil_tracking::testing;

class RigVerb : public ::testing::Test {
 protected:
  RigVerb() { cameras::writeRig(rig_, folder_.path() / "stereo.yml"); }
  std::string at(const std::string& name) const { return "'" + (folder_.path() / name).string() + "'"; }
  std::string rigs() const { return " --rigs " + at("rigs"); }
  CommandResult make(const std::string& more = "") const {
    return runFacenav("rig new bar --calibration " + at("stereo.yml") + rigs() + " " + more);
  }
  /// Writes board pictures of a rig at its true pose; returns the options.
  std::string pictures(const std::string& name, const cameras::StereoRig& real) const {
    fs::create_directories(folder_.path() / name);
    for (int i = 0; i < 3; ++i) {
      const auto frame = boardFrame(real, i);
      cv::imwrite((folder_.path() / name / ("left" + std::to_string(i) + ".png")).string(), frame.left);
      cv::imwrite((folder_.path() / name / ("right" + std::to_string(i) + ".png")).string(), frame.right);
    }
    return std::string(" ") + kPrintedBoardOptions + " --left " + at(name + "/left*.png") + " --right " +
           at(name + "/right*.png");
  }
  nlohmann::json list() const { return nlohmann::json::parse(runFacenav("rig list --json" + rigs()).output); }

  TemporaryFolder folder_;
  cameras::StereoRig rig_ = scene::roomRig();
};

TEST_F(RigVerb, IsMadeListedAndCheckedFromFiles) {
  EXPECT_THAT(runFacenav("rig list" + rigs()).output, HasSubstr("no rig in"));
  const auto made = make();
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_THAT(made.output, HasSubstr("640 x 480 px"));
  EXPECT_THAT(made.errors, HasSubstr("the rig knows no cameras"));
  EXPECT_THAT(make().errors, HasSubstr("there is a rig of this name"));
  const auto holds = runFacenav("rig check bar" + rigs() + pictures("same", rig_));
  EXPECT_EQ(holds.status, 0) << holds.errors;
  EXPECT_THAT(holds.output, HasSubstr("bar: the calibration holds"));
  EXPECT_EQ(list()[0]["last_check"]["state"], "holds");
  const auto turned = runFacenav("rig check bar --json" + rigs() +
                                 pictures("turned", turnedRight(rig_, {0, 0.3 * kRadPerDeg, 0})));
  EXPECT_EQ(turned.status, 1);
  EXPECT_EQ(std::count(turned.errors.begin(), turned.errors.end(), '\n'), 1) << turned.errors;
  EXPECT_THAT(turned.errors, HasSubstr("calibrate again"));
  EXPECT_EQ(nlohmann::json::parse(turned.output)["state"], "moved");
  EXPECT_TRUE(nlohmann::json::parse(turned.output)["fitting_square_mm"].is_null());
  auto typed_wrong = pictures("same", rig_);
  typed_wrong.replace(typed_wrong.find("--square 20"), 11, "--square 25");
  const auto wrong_square = runFacenav("rig check bar" + rigs() + typed_wrong);
  EXPECT_EQ(wrong_square.status, 1);
  EXPECT_THAT(wrong_square.errors, HasSubstr("the squares measure 20.0"));
  EXPECT_THAT(wrong_square.errors, HasSubstr("measure one and give its size again"));
  EXPECT_EQ(list()[0]["last_check"]["state"], "moved");
}

TEST_F(RigVerb, ChecksFromARecordingOfTheCoilsMarker) {
  ASSERT_EQ(make().status, 0);
  {
    capture::RecordingWriter writer(folder_.path() / "recording", rig_);
    for (int i = 0; i < 20; ++i) {
      scene::SceneOptions options;
      options.seed = unsigned(i + 1);
      auto frame = scene::renderMarkers(
          rig_, {{scene::id7(), 60, scene::markerPose(560 + 10 * (i / 4), 25, 40, 10, {5.0 * (i / 4), 0})}},
          options);
      frame.number = i;
      frame.captured = {i / 30.0};
      writer.add(frame);
    }
    writer.close();
  }
  const auto result = runFacenav("rig check bar " + at("recording") + rigs());
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("marker: "));
  EXPECT_THAT(result.output, HasSubstr("60.00 mm true"));
}

TEST_F(RigVerb, SaysWhatIsMissing) {
  EXPECT_THAT(runFacenav("rig check foo" + rigs() + " --live 1").errors, HasSubstr("there is no such rig"));
  ASSERT_EQ(make().status, 0);
  EXPECT_THAT(runFacenav("rig check bar" + rigs()).errors,
              HasSubstr("it is not said what to check the rig with"));
  EXPECT_THAT(runFacenav("rig check bar --live 1" + rigs()).errors, HasSubstr("the rig knows no cameras"));
  EXPECT_THAT(runFacenav("rig new b --board 9x6" + rigs()).errors, HasSubstr("--square"));
  EXPECT_EQ(runFacenav("rig").status, 2);
}

/// Two videos replace cameras: they are opened, paired, stored as a rig and viewed.
TEST_F(RigVerb, KeepsTwoStreamsAndLooksThroughThem) {
  const auto frame = boardFrame(rig_, 0);
  for (const auto& [name, image] : {std::pair("left.avi", frame.left), std::pair("right.avi", frame.right)}) {
    cv::VideoWriter writer((folder_.path() / name).string(), cv::VideoWriter::fourcc('H', 'F', 'Y', 'U'), 30,
                           image.size(), false);
    ASSERT_TRUE(writer.isOpened());
    cv::Mat changing = image.clone();
    for (int i = 0; i < 90; ++i) {
      changing(cv::Rect(0, 0, 4, 4)).setTo(i);
      writer.write(changing);
    }
  }
  const std::string pair = at("left.avi") + " --right " + at("right.avi");
  const auto tried = runFacenav("cameras --quick --try 0.5 --size 640x480 --json --left " + pair);
  ASSERT_EQ(tried.status, 0) << tried.errors;
  EXPECT_NEAR(double(nlohmann::json::parse(tried.output)["pairs_per_s"]), 30.0, 8.0);
  const auto made = make("--left-camera " + at("left.avi") + " --right-camera " + at("right.avi"));
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_EQ(list()[0]["left"], "stream:" + (folder_.path() / "left.avi").string());
  const auto checked = runFacenav("rig check bar --live 1 " + std::string(kPrintedBoardOptions) + rigs());
  EXPECT_EQ(checked.status, 0) << checked.errors << checked.output;
  const auto wrong = runFacenav("cameras --quick --try 0.5 --size 320x240 --left " + pair);
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.errors, HasSubstr("it has 640 x 480; choose this size"));
  const auto photo = make("--replace --left-camera " + at("same.png") + " --right-camera " + at("right.avi"));
  EXPECT_THAT(photo.errors, HasSubstr("there is no such file or folder"));
  cv::imwrite((folder_.path() / "same.png").string(), frame.left);
  EXPECT_THAT(make("--replace --left-camera " + at("same.png") + " --right-camera " + at("right.avi")).errors,
              HasSubstr("this is one picture, not a film"));
  EXPECT_THAT(runFacenav("rig check bar --board 9x6 --square 20 --left " + at("left.avi") + " --right " +
                         at("right.avi") + rigs())
                  .errors,
              HasSubstr("this is a film, not a picture"));
  EXPECT_THAT(
      runFacenav("rig check bar --left " + at("same.png") + " --right " + at("same.png") + rigs()).errors,
      HasSubstr("to check with a board, give --board and --square"));
}

TEST_F(RigVerb, APasswordTypedWithAnAddressIsInNoMessageAndInOneFileOnly) {
  ::setenv("XDG_CONFIG_HOME", (folder_.path() / "configuration").c_str(), 1);
  const JpegServer::Picture picture = [](int i) {
    return JpegServer::largeJpeg(cv::Mat(480, 640, CV_8U, cv::Scalar(60 + i % 50)));
  };
  JpegServer left(picture), right(picture);
  const auto address = [](const JpegServer& server, const std::string& login) {
    return "http://" + login + "@" + server.url().substr(7);
  };
  const std::string cameras =
      "--left-camera " + address(left, "doe:Sesame") + " --right-camera " + address(right, "doe:Sesame");
  std::string words;
  const auto expectDone = [&](const CommandResult& result, int status) {
    EXPECT_EQ(result.status, status) << result.errors;
    words += result.output + result.errors;
  };
  expectDone(make(cameras), 0);
  expectDone(runFacenav("rig list --json" + rigs()), 0);
  expectDone(runFacenav("record --rig bar --seconds 1 -o " + at("film") + rigs()), 0);
  left.switchOff(true);
  const std::string silent = "--left rtsp://doe:Sesame@127.0.0.1:9/l --right rtsp:/doe:Sesame@127.0.0.1";
  expectDone(runFacenav("rig check bar --live 1 --board 9x6 --square 20" + rigs()), 1);
  expectDone(runFacenav("cameras --quick --try 1 --size 640x480 " + silent), 1);
  expectDone(
      runFacenav("record --seconds 1 --calibration " + at("stereo.yml") + " -o " + at("no") + " " + silent),
      1);
  expectDone(runFacenav("cameras rtsp://doe:Sesame@host/left"), 2);
  ::unsetenv("XDG_CONFIG_HOME");
  EXPECT_THAT(words, HasSubstr("http://doe@127.0.0.1"));
  EXPECT_THAT(words, ::testing::Not(HasSubstr("Sesame")));
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
    if (entry.is_regular_file() && readText(entry.path()).find("Sesame") != std::string::npos) {
      EXPECT_EQ(entry.path().filename(), "stream_logins.json");
    }
}

/// Two videos of the coil's marker at rest replace the cameras of a kept rig, whose right one has turned
/// sideways by `turned_deg` since.
class KeptRigVerb : public RigVerb {
 protected:
  void film(double turned_deg) const {
    const auto real = turnedRight(rig_, {0, turned_deg * kRadPerDeg, 0});
    const auto frame =
        scene::renderMarkers(real, {{scene::id7(), 60, scene::markerPose(580, 20, 40, 10)}}, {});
    for (const auto& [name, image] :
         {std::pair("left.avi", frame.left), std::pair("right.avi", frame.right)}) {
      cv::VideoWriter writer((folder_.path() / name).string(), cv::VideoWriter::fourcc('H', 'F', 'Y', 'U'),
                             30, image.size(), false);
      ASSERT_TRUE(writer.isOpened());
      cv::Mat changing = image.clone();
      for (int i = 0; i < 150; ++i) {
        changing(cv::Rect(0, 0, 4, 4)).setTo(i);
        writer.write(changing);
      }
    }
  }
  CommandResult record(const std::string& name) const {
    return runFacenav("record --rig bar" + rigs() + " --seconds 3 -o " + at(name));
  }
  std::string caseFolder() const {
    casefile::CaseStore::create(folder_.path() / "case", ballCase(), {}, false);
    return at("case");
  }
};

TEST_F(KeptRigVerb, IsVerifiedEachTimeItsCamerasOpen) {
  ASSERT_NO_FATAL_FAILURE(film(0));
  const auto made = make("--left-camera " + at("left.avi") + " --right-camera " + at("right.avi"));
  ASSERT_EQ(made.status, 0) << made.errors;
  const auto holds = record("first");
  EXPECT_EQ(holds.status, 0) << holds.errors;
  EXPECT_THAT(holds.errors, HasSubstr("rig bar: cameras, picture size and adjustments are as kept; the "
                                      "calibration holds: the coil's marker measures"));
  EXPECT_EQ(list()[0]["last_check"]["state"], "holds");
  // The bar is bumped.
  ASSERT_NO_FATAL_FAILURE(film(0.4));
  const auto moved = record("second");
  EXPECT_EQ(moved.status, 0) << "a recording is no guidance: " << moved.errors;
  EXPECT_THAT(moved.errors, HasSubstr("the cameras have moved against each other"));
  EXPECT_THAT(moved.errors, HasSubstr("repair it in two minutes: facenav-gui --set-up --rig bar"));
  EXPECT_EQ(list()[0]["last_check"]["state"], "moved");
  const auto aligned = runFacenav("align " + caseFolder() + " --live bar" + rigs());
  EXPECT_EQ(aligned.status, 1);
  EXPECT_THAT(aligned.errors, HasSubstr("not aligned: the cameras have moved against each other"));
  EXPECT_THAT(aligned.errors, HasSubstr("facenav-gui --set-up --rig bar"));
  EXPECT_FALSE(fs::exists(folder_.path() / "case" / "alignment.json"));
  // It is bent back: the marker shows that the calibration is valid again.
  ASSERT_NO_FATAL_FAILURE(film(0));
  EXPECT_THAT(record("third").errors, HasSubstr("the calibration holds: the coil's marker measures"));
  EXPECT_EQ(list()[0]["last_check"]["state"], "holds");
}

TEST_F(KeptRigVerb, AFaultStaysUntilSomethingClearsIt) {
  ASSERT_NO_FATAL_FAILURE(film(0));
  ASSERT_EQ(make("--left-camera " + at("left.avi") + " --right-camera " + at("right.avi")).status, 0);
  capture::RigStore(folder_.path() / "rigs").note("bar", {"2020-01-02T08:00:00Z", "moved", "it was bumped"});
  // A plain grey picture shows neither face nor marker.
  const cv::Mat grey(480, 640, CV_8U, cv::Scalar(90));
  for (const char* name : {"left.avi", "right.avi"}) {
    cv::VideoWriter writer((folder_.path() / name).string(), cv::VideoWriter::fourcc('H', 'F', 'Y', 'U'), 30,
                           grey.size(), false);
    cv::Mat changing = grey.clone();
    for (int i = 0; i < 120; ++i) {
      changing(cv::Rect(0, 0, 4, 4)).setTo(i);
      writer.write(changing);
    }
  }
  const auto recorded = record("first");
  EXPECT_EQ(recorded.status, 0) << recorded.errors;
  EXPECT_THAT(
      recorded.errors,
      HasSubstr("the check of 2020-01-02T08:00:00Z found a fault that is not repaired: it was bumped"));
  EXPECT_EQ(list()[0]["last_check"]["utc"], "2020-01-02T08:00:00Z");
  EXPECT_THAT(runFacenav("align " + caseFolder() + " --live bar" + rigs()).errors,
              HasSubstr("not aligned: the check of 2020-01-02T08:00:00Z found a fault"));
}

}  // namespace
}  // namespace facenav::testing
