// The GenICam backend against Aravis's fake GigE camera on loopback, and against its fake device without a
// network.

#include <arv.h>
#include <gmock/gmock.h>

#include <mutex>

#include "facenav/capture/camera_backend.h"
#include "support/camera_contract.h"

namespace facenav::capture {
namespace {

using testing::faultOf;
using ::testing::HasSubstr;

CameraSettings smallSettings() {
  CameraSettings settings;
  settings.width_px = 128;
  settings.height_px = 96;
  settings.frames_per_s = 50;
  return settings;
}

/// A GigE camera at 127.0.0.1, in this process: real packets over loopback.
class FakeGigE : public testing::CameraBench {
 public:
  FakeGigE() { FakeGigE::unplug(false); }
  ~FakeGigE() override { FakeGigE::unplug(true); }
  std::unique_ptr<Camera> open() override { return makeGenicamBackend()->open(identity()); }
  CameraIdentity identity() const {
    return {"genicam", "Aravis-Fake-GV01", "Aravis Fake", "GV01", "127.0.0.1"};
  }
  CameraSettings settings() const override { return smallSettings(); }
  bool unplug(bool is_unplugged) override {
    if (camera_) g_object_unref(camera_);
    camera_ = is_unplugged ? nullptr : arv_gv_fake_camera_new("127.0.0.1", "GV01");
    return true;
  }
  double noticesUnplugWithin_s() const override {
    return 9.0;
  }  // Aravis gives up its heartbeat after five seconds
  std::string sizeItHas() const override { return "2048"; }
  bool hang(bool is_hung) override { return losePackets(is_hung ? 1.0 : 0.0), true; }
  void losePackets(double share) { g_object_set(camera_, "gvsp-lost-ratio", share, nullptr); }
  std::uint32_t triggerRegister() const {
    guint32 value = 0;
    arv_fake_camera_read_register(arv_gv_fake_camera_get_fake_camera(camera_),
                                  ARV_FAKE_CAMERA_REGISTER_TRIGGER_SOFTWARE, &value);
    return value;
  }
  bool isRunning() const { return camera_ && arv_gv_fake_camera_is_running(camera_); }

 private:
  ArvGvFakeCamera* camera_ = nullptr;
};

/// Aravis's fake device, without a network.
class FakeDevice : public testing::CameraBench {
 public:
  FakeDevice() { arv_enable_interface("Fake"); }
  ~FakeDevice() override { arv_disable_interface("Fake"); }
  std::unique_ptr<Camera> open() override {
    return makeGenicamBackend()->open({"genicam", "Fake_1", "Aravis Fake device", "1", ""});
  }
  CameraSettings settings() const override { return smallSettings(); }
};

TEST(Genicam, AGigECameraKeepsTheContractOfCameras) {
  FakeGigE bench;
  ASSERT_TRUE(bench.isRunning());
  testing::expectCameraContract(bench);
}

/// GigE camera that can be unplugged; Aravis needs eight seconds to notice.
class PluggedInGigE : public FakeGigE {
 public:
  bool unplug(bool) override { return false; }
};

TEST(Genicam, TwoKeepTheContractOfLivePairs) {
  FakeDevice left;
  PluggedInGigE right;
  testing::expectLivePairContract(left, right);
}

TEST(Genicam, PicturesWithLostPacketsAreLeftOutAndCounted) {
  FakeGigE bench;
  const auto camera = bench.open();
  camera->configure(bench.settings());
  camera->start();
  ASSERT_TRUE(camera->next(2.0));
  bench.losePackets(0.15);
  int whole = 0;
  for (int i = 0; i < 100 && camera->counts().damaged < 3; ++i) whole += camera->next(0.5).has_value();
  EXPECT_GE(camera->counts().damaged, 3);
  bench.losePackets(0.0);
  EXPECT_TRUE(camera->next(2.0));
}

TEST(Genicam, ExposureAndGainAreSetAndReadBack) {
  FakeGigE bench;
  const auto camera = bench.open();
  auto settings = bench.settings();
  settings.exposure_ms = 4.0;
  settings.gain = 5.0;
  const auto state = camera->configure(settings);
  EXPECT_TRUE(unlockedInWords(state).empty());
  EXPECT_DOUBLE_EQ(*state.controls[0].actual, 4.0);
  EXPECT_DOUBLE_EQ(*state.controls[1].actual, 5.0);
  EXPECT_NEAR(state.frames_per_s, 50, 0.5);
  EXPECT_EQ(state.format, "Mono8");
  settings.focus = 10;
  settings.exposure_ms = 1e9;
  EXPECT_THAT(unlockedInWords(camera->configure(settings)),
              ::testing::ElementsAre(HasSubstr("exposure: 1e+09 ms is outside the camera's range"),
                                     "focus: the lens is focused by hand"));
}

// Aravis 0.8.26's fake GigE camera accepts the command without sending a picture; its fake device ignores
// triggers.
TEST(Genicam, ASoftwareTriggerReachesTheCameraAndNoPictureComesWithoutIt) {
  FakeGigE bench;
  const auto camera = bench.open();
  auto settings = bench.settings();
  settings.trigger = Trigger::software;
  camera->configure(settings);
  camera->start();
  EXPECT_FALSE(camera->next(0.3));
  EXPECT_EQ(bench.triggerRegister(), 0u);
  camera->trigger();
  EXPECT_EQ(bench.triggerRegister(), 1u);
}

TEST(Genicam, AHardwareTriggerWaitsForItsPulse) {
  FakeGigE bench;
  const auto camera = bench.open();
  auto settings = bench.settings();
  settings.trigger = Trigger::hardware;
  camera->configure(settings);
  camera->start();
  EXPECT_FALSE(camera->next(0.3));
  settings.trigger = Trigger::free_run;
  camera->configure(settings);
  camera->start();
  EXPECT_TRUE(camera->next(2.0));
}

TEST(Genicam, AConnectedCameraIsListedAndOneInUseIsSaid) {
  FakeGigE bench;
  const auto listed = makeGenicamBackend()->list();
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(stableName(listed[0].identity), "genicam:Aravis Fake#GV01");
  EXPECT_EQ(listed[0].identity.port, "127.0.0.1");
  EXPECT_EQ(listed[0].use, FoundCamera::Use::free);
  const auto mine = bench.open();
  EXPECT_EQ(makeGenicamBackend()->list().at(0).use, FoundCamera::Use::in_use);
}

}  // namespace
}  // namespace facenav::capture
