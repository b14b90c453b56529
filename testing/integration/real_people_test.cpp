// Real people before real cameras (shared data, skipped where absent): what is right is tracked, and nothing
// is shown of another person, of two moments, or of exchanged cameras. A picture is repeated with noise, as a
// camera repeats a face at rest.

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/capture/recording.h"
#include "facenav/treat/track_recording.h"
#include "registrations.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
constexpr int kFrames = 6;           // of each pair
constexpr double kNoise_grey = 0.7;  // a bit-for-bit repetition would be a frozen camera
constexpr double kFoundWithin_s = 0.2;
constexpr double kFrame_s = 1.0 / 30, kPause_s = 1.5;

struct Moment {
  std::string person;
  int number;
};
struct Scene {
  Moment left, right;
};
struct People {
  std::string rig;  // letters of the left and the right camera
  Moment start, later, stranger;
  std::string exchanged;  // what is said of exchanged cameras
};
void PrintTo(const People& people, std::ostream* out) {
  *out << people.rig << ' ' << people.start.person << ' ' << people.start.number;
}

class RealPeople : public ::testing::TestWithParam<People> {
 protected:
  fs::path pictures() const { return sharedData() / "real_faces"; }

  cv::Mat picture(char camera, const Moment& moment) const {
    const fs::path file =
        pictures() / moment.person / (std::string(1, camera) + "_" + std::to_string(moment.number) + ".jpg");
    return cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
  }

  /// Tracks the scenes one after the other. Returns the head's rows, kFrames a scene.
  std::vector<casefile::PoseRow> track(const std::vector<Scene>& scenes, bool is_swapped = false) const {
    const std::string rig = GetParam().rig;
    const TemporaryFolder folder;
    capture::RecordingWriter writer(folder.path() / "recording",
                                    cameras::readRig(pictures() / (rig + "_stereo.yml")));
    cv::RNG random(7);
    const auto seen = [&](char camera, const Moment& moment) {
      cv::Mat noise(picture(camera, moment).size(), CV_32F), noisy;
      random.fill(noise, cv::RNG::NORMAL, 0, kNoise_grey);
      cv::add(picture(camera, moment), noise, noisy, cv::noArray(), CV_8U);
      return noisy;
    };
    cameras::StereoFrame frame;
    double t_s = 0;
    for (const Scene& scene : scenes) {
      for (int i = 0; i < kFrames; ++i, ++frame.number, t_s += kFrame_s) {
        frame.left = seen(rig[0], scene.left), frame.right = seen(rig[1], scene.right);
        if (is_swapped) std::swap(frame.left, frame.right);
        frame.captured = {t_s};
        writer.add(frame);
      }
      t_s += kPause_s;
    }
    writer.close();
    const steps::Registrations methods = app::makeRegistrations();
    steps::TrackRequest request;
    request.recording = folder.path() / "recording";
    request.aligner = methods.aligners.defaultName();
    request.head_tracker = methods.head_trackers.defaultName();
    request.coil_tracker = methods.coil_trackers.defaultName();
    TaskMonitor monitor;
    std::vector<casefile::PoseRow> head;
    for (auto& row : steps::trackRecording(methods, request, monitor).poses)
      if (row.object == casefile::PoseObject::head) head.push_back(row);
    return head;
  }

  static int tracked(const std::vector<casefile::PoseRow>& rows, int scene) {
    int count = 0;
    for (int i = scene * kFrames; i < (scene + 1) * kFrames; ++i)
      count += rows.at(std::size_t(i)).pose.has_value();
    return count;
  }
  /// Frames of a scene in which the head must be shown.
  static int due() { return kFrames - int(kFoundWithin_s / kFrame_s); }
};

TEST_P(RealPeople, AreTrackedAndFoundAgainAtAnotherMoment) {
  FACENAV_NEEDS(pictures());
  const auto& [rig, start, later, stranger, exchanged] = GetParam();
  const auto rows = track({{start, start}, {later, later}});
  EXPECT_EQ(tracked(rows, 0), kFrames);
  EXPECT_GE(tracked(rows, 1), due());
}

TEST_P(RealPeople, AreNotTakenForAnother) {
  FACENAV_NEEDS(pictures());
  const auto& [rig, start, later, stranger, exchanged] = GetParam();
  const auto rows = track({{start, start}, {stranger, stranger}, {start, start}});
  EXPECT_EQ(tracked(rows, 0), kFrames);
  EXPECT_EQ(tracked(rows, 1), 0);
  EXPECT_GE(tracked(rows, 2), due());
}

TEST_P(RealPeople, AreNotShownFromPicturesOfTwoMoments) {
  FACENAV_NEEDS(pictures());
  const auto& [rig, start, later, stranger, exchanged] = GetParam();
  const auto rows = track({{start, start}, {start, later}});
  EXPECT_EQ(tracked(rows, 0), kFrames);
  EXPECT_EQ(tracked(rows, 1), 0);
  const auto from_the_first = track({{start, later}});
  EXPECT_EQ(tracked(from_the_first, 0), 0);
  // Pictures of one moment that come later are the start.
  const auto from_the_second = track({{start, later}, {later, later}});
  EXPECT_EQ(tracked(from_the_second, 0), 0);
  EXPECT_EQ(tracked(from_the_second, 1), kFrames);
}

TEST_P(RealPeople, AreNotShownFromExchangedCameras) {
  FACENAV_NEEDS(pictures());
  const auto& [rig, start, later, stranger, exchanged] = GetParam();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(tracked(track({{start, start}}, true), 0), 0);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), ::testing::HasSubstr(exchanged));
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, RealPeople,
    // The landmarks of the first pair disagree, so no fit starts; the second pair's face tells by its
    // matches.
    ::testing::Values(
        People{
            "lm", {"person", 418}, {"person", 1252}, {"person_2", 837}, "both cameras see a face (frame 0)"},
        People{"mr", {"person_2", 1}, {"person_2", 419}, {"person", 1669}, "left and right are exchanged"}),
    [](const auto& info) { return info.param.rig + "_" + info.param.start.person; });

}  // namespace
}  // namespace facenav::testing
