#include "facenav/capture/rig_store.h"

#include <gmock/gmock.h>

#include <fstream>

#include "facenav/capture/stream_logins.h"
#include "facenav/core/whole_file.h"
#include "support/camera_contract.h"
#include "support/fake_v4l2.h"
#include "support/recordings.h"
#include "support/test_data.h"

namespace facenav::capture {
namespace {

using ::testing::HasSubstr;

NamedRig webcams(const std::string& name) {
  NamedRig rig;
  rig.name = name;
  rig.created_utc = "2026-11-24T10:00:00Z";
  rig.rig = testing::smallRig();
  CameraSettings settings;
  settings.width_px = 64;
  settings.height_px = 48;
  settings.frames_per_s = 100;
  settings.exposure_ms = 8.0;
  rig.left = RigCamera{{"v4l2", "/dev/video0", "Webcam", "A", "1-1"}, settings};
  rig.right = RigCamera{{"v4l2", "/dev/video2", "Webcam", "B", "1-2"}, settings};
  rig.uncertainty = RigUncertainty_mm{600, 0.42};
  return rig;
}

std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Sets a variable of the environment while it lives.
class SetVariable {
 public:
  SetVariable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  ~SetVariable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  SetVariable(const SetVariable&) = delete;
  SetVariable& operator=(const SetVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(RigStore, GivesBackWhatWasWritten) {
  const testing::TemporaryFolder folder;
  const RigStore store(folder.path() / "rigs");
  EXPECT_TRUE(store.list().empty());
  store.write(webcams("room 2"), Existing::refuse);
  store.note("room 2", {"2026-11-25T08:00:00Z", "holds", "the calibration holds"});
  const NamedRig rig = store.read("room 2");
  EXPECT_EQ(rig.created_utc, "2026-11-24T10:00:00Z");
  ASSERT_TRUE(rig.left && rig.right && rig.uncertainty && rig.last_check);
  EXPECT_TRUE(isSameCamera(rig.left->identity, webcams("").left->identity));
  EXPECT_EQ(rig.left->settings.exposure_ms, 8.0);
  EXPECT_EQ(rig.left->settings.width_px, 64);
  EXPECT_FALSE(rig.left->settings.focus);
  EXPECT_EQ(rig.uncertainty->point_mm, 0.42);
  EXPECT_EQ(rig.last_check->state, "holds");
  EXPECT_NEAR(rig.rig.baseline_mm(), testing::smallRig().baseline_mm(), 1e-9);
}

TEST(RigStore, KeepsMeasuredRowTimes) {
  const testing::TemporaryFolder folder;
  const RigStore store(folder.path());
  store.write(webcams("bar"), Existing::refuse);
  EXPECT_EQ(store.read("bar").rig.left.row_time_s, 0.0);
  store.noteRowTimes("bar", {"2026-11-25T08:00:00Z", 42e-6, 41e-6});
  store.note("bar", {"2026-11-25T09:00:00Z", "holds", "the calibration holds"});
  const NamedRig rig = store.read("bar");
  EXPECT_NEAR(rig.rig.left.row_time_s, 42e-6, 1e-12);
  EXPECT_NEAR(rig.rig.right.row_time_s, 41e-6, 1e-12);
  ASSERT_TRUE(rig.row_times);
  EXPECT_EQ(rig.row_times->utc, "2026-11-25T08:00:00Z");

  store.write(webcams("bar"), Existing::replace);  // calibrated again: the same cameras
  EXPECT_NEAR(store.read("bar").rig.right.row_time_s, 41e-6, 1e-12);
  NamedRig other = webcams("bar");
  other.left->identity.serial = "C";
  store.write(other, Existing::replace);
  EXPECT_EQ(store.read("bar").rig.right.row_time_s, 0.0);
  other.left->settings.frames_per_s = 50;  // another mode of the sensor
  store.noteRowTimes("bar", {"2026-11-25T08:00:00Z", 42e-6, 41e-6});
  store.write(other, Existing::replace);
  EXPECT_FALSE(store.read("bar").row_times);
  EXPECT_THAT(errorOf([&] { store.noteRowTimes("foo", {}); }), HasSubstr("there are: bar"));
  store.noteRowTimes("bar", {"2026-11-25T08:00:00Z", 1.0, 41e-6});
  EXPECT_THAT(errorOf([&] { store.read("bar"); }), HasSubstr("longer than 100 ms"));
}

TEST(RigStore, RefusesInOneClearLine) {
  const testing::TemporaryFolder folder;
  const RigStore store(folder.path());
  store.write(webcams("bar"), Existing::refuse);
  EXPECT_THAT(errorOf([&] { store.write(webcams("bar"), Existing::refuse); }), HasSubstr("bar"));
  store.write(webcams("bar"), Existing::replace);
  EXPECT_THAT(errorOf([&] { store.read("foo"); }), HasSubstr("there are: bar"));
  for (const char* name : {"", "../etc", "a/b", ".hidden"})
    EXPECT_THAT(errorOf([&] { store.write(webcams(name), Existing::refuse); }),
                HasSubstr("no name for a rig"));
  std::ofstream(folder.path() / "bar" / "rig.json") << R"({"version": 1, "name": "bar"})";
  EXPECT_THAT(errorOf([&] { store.read("bar"); }), HasSubstr("created"));
  ASSERT_EQ(store.list().size(), 1u);
  EXPECT_THAT(store.list()[0].problem, HasSubstr("rig.json"));
}

TEST(RigStore, ItsPlaceIsTheUsersConfiguration) {
  const testing::TemporaryFolder folder;
  const SetVariable configuration("XDG_CONFIG_HOME", folder.path().string());
  EXPECT_EQ(RigStore().folder(), folder.path() / "facenav" / "rigs");
}

/// Every file below `folder` that contains the text.
std::vector<std::string> filesWith(const std::filesystem::path& folder, const std::string& text) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && readWholeFile(entry.path()).find(text) != std::string::npos)
      found.push_back(entry.path().filename());
  return found;
}

TEST(RigStore, APasswordOfAStreamLiesInTheUsersOwnFileAlone) {
  const testing::TemporaryFolder folder;
  const SetVariable configuration("XDG_CONFIG_HOME", folder.path().string());
  const RigStore store(folder.path() / "lent");
  NamedRig rig = webcams("bar");
  rig.left->identity = findCamera({}, "rtsp://doe:Sec/ret@127.0.0.1:9/left");
  rig.right->identity = findCamera({}, "http://127.0.0.1:9/right?user=doe&pwd=Sec/ret");
  store.write(rig, Existing::refuse);
  store.note("bar", {"2026-11-25T09:00:00Z", "holds", "the calibration holds"});
  EXPECT_THAT(filesWith(folder.path(), "ec/ret"), ::testing::ElementsAre("stream_logins.json"));
  const auto file = folder.path() / "facenav" / "stream_logins.json";
  EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms(0600));

  const NamedRig kept = store.read("bar");
  EXPECT_EQ(kept.left->identity.address, "rtsp://doe@127.0.0.1:9/left");
  EXPECT_EQ(StreamLogins().openingAddress(kept.left->identity), "rtsp://doe:Sec%2Fret@127.0.0.1:9/left");
  EXPECT_EQ(StreamLogins().openingAddress(kept.right->identity),
            "http://127.0.0.1:9/right?user=doe&pwd=Sec/ret");
  CameraBackends backends("camera connection");
  backends.add("stream", "", makeStreamBackend);
  const std::string words = errorOf([&] { openRig(backends, kept); });
  EXPECT_THAT(words, HasSubstr("rtsp://doe@127.0.0.1:9/left: the stream cannot be opened"));
  EXPECT_THAT(words, ::testing::Not(HasSubstr("ret")));
}

TEST(RigStore, APasswordInARigOfAnEarlierVersionIsMovedWhenTheRigIsWritten) {
  const testing::TemporaryFolder folder;
  const SetVariable configuration("XDG_CONFIG_HOME", folder.path().string());
  const RigStore store(folder.path() / "rigs");
  NamedRig rig = webcams("bar");
  rig.left->identity = {"stream", "rtsp://doe@host/left", "", "", ""};
  store.write(rig, Existing::refuse);
  const auto file = folder.path() / "rigs" / "bar" / "rig.json";
  std::string json = readWholeFile(file);
  json.replace(json.find("doe@"), 4, "doe:secret@");
  writeWholeFile(file, json);
  EXPECT_EQ(store.read("bar").left->identity.address, "rtsp://doe@host/left");
  store.note("bar", {"2026-11-25T09:00:00Z", "holds", "the calibration holds"});
  EXPECT_THAT(filesWith(folder.path(), "secret"), ::testing::ElementsAre("stream_logins.json"));
  EXPECT_EQ(StreamLogins().openingAddress(store.read("bar").left->identity), "rtsp://doe:secret@host/left");
}

TEST(RigStore, NoMessageAboutATypedAddressShowsItsPassword) {
  for (const char* typed : {"rtsp:/doe:secret@host/left", "doe:secret@host/left", "doe:secret@host",
                            "file:///no/such?pwd=secret", "stream:rtsp://doe:secret@host"}) {
    const std::string words = errorOf([&] { findCamera({}, typed); });
    EXPECT_THAT(words, ::testing::Not(HasSubstr("secret"))) << typed;
  }
  const auto camera = findCamera({}, "rtsp://doe:secret@host");
  for (const std::string& words : {stableName(camera), inWords(camera), camera.address})
    EXPECT_THAT(words, ::testing::Not(HasSubstr("secret")));
}

/// Lists two webcams of a fake kernel.
class TwoWebcams : public CameraBackend {
 public:
  explicit TwoWebcams(std::shared_ptr<testing::FakeV4l2> kernel) : kernel_(std::move(kernel)) {}
  std::vector<FoundCamera> list() override {
    std::vector<FoundCamera> found;
    for (const auto& [path, camera] : kernel_->cameras)
      found.push_back({{"v4l2", path, "Webcam",
                        path == "/dev/video2"   ? "B"
                        : path == "/dev/video0" ? "A"
                                                : "C",
                        ""},
                       {},
                       ""});
    return found;
  }
  std::unique_ptr<Camera> open(const CameraIdentity& camera) override {
    return makeV4l2Backend(kernel_, {})->open(camera);
  }

 private:
  std::shared_ptr<testing::FakeV4l2> kernel_;
};

TEST(RigStore, OpensItsOwnCamerasWithTheirSettings) {
  const auto kernel = std::make_shared<testing::FakeV4l2>();
  for (const char* path : {"/dev/video0", "/dev/video2"})
    kernel->cameras[path] = std::make_shared<testing::FakeV4l2Camera>();
  CameraBackends backends("kind of camera");
  backends.add("v4l2", "", [kernel] { return std::make_unique<TwoWebcams>(kernel); });
  {
    const auto source = openRig(backends, webcams("bar"));
    EXPECT_TRUE(source->next());
    EXPECT_TRUE(changedSettings(*source).empty());
    EXPECT_EQ(kernel->cameras["/dev/video0"]->controls[V4L2_CID_EXPOSURE_ABSOLUTE].value, 80);
  }
  auto& exposure = kernel->cameras["/dev/video2"]->controls[V4L2_CID_EXPOSURE_ABSOLUTE];
  exposure.value = 156;
  exposure.is_stuck = true;
  EXPECT_THAT(changedSettings(*openRig(backends, webcams("bar"))),
              ::testing::ElementsAre("right camera, exposure: 8 ms was asked for, the camera keeps 15.6 ms"));
  kernel->cameras["/dev/video4"] = kernel->cameras["/dev/video2"];
  kernel->cameras.erase("/dev/video2");
  EXPECT_THAT(errorOf([&] { openRig(backends, webcams("bar")); }),
              HasSubstr("an equal camera is connected, another piece"));
  NamedRig of_files = webcams("files");
  of_files.left.reset();
  EXPECT_THAT(errorOf([&] { openRig(backends, of_files); }), HasSubstr("knows no cameras"));
}

/// Another program changed the exposure meanwhile; the right camera's gain can no longer be set.
TEST(RigStore, AdjustmentsThatDifferAreSetAgainOrNamed) {
  const auto kernel = std::make_shared<testing::FakeV4l2>();
  for (const char* path : {"/dev/video0", "/dev/video2"})
    kernel->cameras[path] = std::make_shared<testing::FakeV4l2Camera>();
  CameraBackends backends("kind of camera");
  backends.add("v4l2", "", [kernel] { return std::make_unique<TwoWebcams>(kernel); });
  NamedRig rig = webcams("bar");
  rig.right->settings.gain = 40;
  auto& left = kernel->cameras["/dev/video0"]->controls;
  auto& right = kernel->cameras["/dev/video2"]->controls;
  left[V4L2_CID_EXPOSURE_ABSOLUTE].value = 200;
  right[V4L2_CID_EXPOSURE_ABSOLUTE].value = 80;
  right[V4L2_CID_GAIN].value = 33;
  right[V4L2_CID_GAIN].is_stuck = true;
  {
    const auto source = openRig(backends, rig);
    EXPECT_THAT(restoredSettings(*source),
                ::testing::ElementsAre("left camera, exposure: was 20 ms, is 8 ms again"));
    EXPECT_THAT(changedSettings(*source),
                ::testing::ElementsAre("right camera, gain: 40 was asked for, the camera keeps 33"));
    EXPECT_EQ(left[V4L2_CID_EXPOSURE_ABSOLUTE].value, 80);
  }
  EXPECT_TRUE(restoredSettings(*openRig(backends, rig)).empty()) << "as it was left";
  // A camera that loses its settings at the start is set once more; the earlier findings are valid.
  left[V4L2_CID_EXPOSURE_ABSOLUTE].forgets_at_start = true;
  left[V4L2_CID_EXPOSURE_ABSOLUTE].at_start = 333;
  EXPECT_TRUE(restoredSettings(*openRig(backends, rig)).empty());
  EXPECT_EQ(left[V4L2_CID_EXPOSURE_ABSOLUTE].value, 80);
}

TEST(RigStore, ANoteOfNowHasTheTime) {
  const auto note = noteOfNow("holds", "as kept");
  EXPECT_EQ(note.utc.size(), 20u);
  EXPECT_EQ(note.utc.back(), 'Z');
  EXPECT_GT(note.utc, "2020");
}

}  // namespace
}  // namespace facenav::capture
