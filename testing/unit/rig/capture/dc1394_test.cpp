// The IEEE 1394 backend against a fake bus; not tested with a real camera.

#include <gmock/gmock.h>

#include <atomic>
#include <map>
#include <thread>

#include "facenav/capture/dc1394_driver.h"
#include "support/camera_contract.h"

namespace facenav::capture {
namespace {

using testing::faultOf;
using ::testing::HasSubstr;

/// A camera on the bus; shared by the test and the driver.
struct FakeIidc {
  std::vector<Dc1394Mode> modes{
      {1, 64, 48, false, {30, 60}}, {2, 64, 48, true, {30, 60}}, {3, 32, 24, true, {60}}};
  std::map<Dc1394Feature, Dc1394Adjustment> adjustments{
      {Dc1394Feature::shutter, {0.0001, 0.05, 0.02, true, true}},
      {Dc1394Feature::gain, {0, 24, 6, true, true}}};
  std::atomic<bool> is_unplugged{false}, is_hung{false}, is_stuck{false}, is_busy{false}, is_bus_full{false};
  std::atomic<double> slowdown{1.0};
  std::atomic<int> damage{0};
  std::vector<std::uint8_t> memory;
  Dc1394Mode mode;
  double rate = 60, last_s = 0;
  int pictures = 0, devices = 0;
  bool is_running = false;
};

double unixNow() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

class FakeIidcDevice : public Dc1394Device {
 public:
  explicit FakeIidcDevice(std::shared_ptr<FakeIidc> camera) : camera_(std::move(camera)) {
    ++camera_->devices;
  }
  ~FakeIidcDevice() override { --camera_->devices; }
  std::vector<Dc1394Mode> modes() override { return camera_->modes; }
  Dc1394Answer setMode(const Dc1394Mode& mode, double rate) override {
    camera_->mode = mode;
    camera_->rate = rate;
    return Dc1394Answer::done;
  }
  std::optional<Dc1394Adjustment> read(Dc1394Feature feature) override {
    const auto found = camera_->adjustments.find(feature);
    return found == camera_->adjustments.end() ? std::nullopt : std::optional(found->second);
  }
  void write(Dc1394Feature feature, bool is_automatic, std::optional<double> value) override {
    const auto found = camera_->adjustments.find(feature);
    if (found == camera_->adjustments.end() || camera_->is_stuck) return;
    found->second.is_automatic = is_automatic;
    if (value) found->second.value = *value;
  }
  Dc1394Answer setTrigger(Trigger trigger) override {
    return trigger == Trigger::hardware ? Dc1394Answer::refused : Dc1394Answer::done;
  }
  Dc1394Answer pullTrigger() override { return Dc1394Answer::refused; }
  Dc1394Answer start() override {
    if (camera_->is_busy) return Dc1394Answer::busy;
    if (camera_->is_bus_full) return Dc1394Answer::no_bandwidth;
    camera_->is_running = true;
    camera_->last_s = Timestamp::now().s;
    return Dc1394Answer::done;
  }
  void stop() override { camera_->is_running = false; }
  std::optional<Dc1394Picture> take(double timeout_s, bool& is_gone) override {
    const double until_s = Timestamp::now().s + timeout_s;
    while (Timestamp::now().s < until_s) {
      if (camera_->is_unplugged) return is_gone = true, std::nullopt;
      if (!camera_->is_hung && Timestamp::now().s >= camera_->last_s + camera_->slowdown / camera_->rate)
        return picture();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return std::nullopt;
  }
  void giveBack() override { std::fill(camera_->memory.begin(), camera_->memory.end(), std::uint8_t(0)); }

 private:
  Dc1394Picture picture() {
    auto& camera = *camera_;
    camera.last_s += camera.slowdown / camera.rate;
    const std::size_t step = camera.mode.is_yuv422 ? 2 : 1, stride = std::size_t(camera.mode.width_px) * step;
    camera.memory.assign(stride * std::size_t(camera.mode.height_px), 128);
    ++camera.pictures;
    for (std::size_t i = 0; i < camera.memory.size() / step; ++i)
      camera.memory[i * step + step - 1] = std::uint8_t((i + 5 * std::size_t(camera.pictures)) % 200);
    const bool is_damaged = camera.damage > 0;
    if (is_damaged) --camera.damage;
    return {camera.memory.data(), stride, unixNow() - (Timestamp::now().s - camera.last_s), is_damaged};
  }
  std::shared_ptr<FakeIidc> camera_;
};

class FakeBus : public Dc1394Driver {
 public:
  std::map<std::uint64_t, std::shared_ptr<FakeIidc>> cameras;
  std::vector<Dc1394Unit> list() override {
    std::vector<Dc1394Unit> units;
    for (const auto& [guid, camera] : cameras)
      if (!camera->is_unplugged) units.push_back({guid, "Point Grey", "Flea2"});
    return units;
  }
  std::unique_ptr<Dc1394Device> open(std::uint64_t guid) override {
    const auto found = cameras.find(guid);
    if (found == cameras.end() || found->second->is_unplugged) return nullptr;
    return std::make_unique<FakeIidcDevice>(found->second);
  }
};

class IidcBench : public testing::CameraBench {
 public:
  IidcBench(std::shared_ptr<FakeBus> bus, std::uint64_t guid) : bus_(std::move(bus)), guid_(guid) {
    bus_->cameras[guid_] = camera_;
  }
  std::unique_ptr<Camera> open() override {
    const auto backend = makeDc1394Backend(bus_);
    for (const auto& found : backend->list())
      if (std::stoull(found.identity.serial, nullptr, 16) == guid_) return backend->open(found.identity);
    return backend->open({"dc1394", "0", "Point Grey Flea2", "", ""});
  }
  CameraSettings settings() const override {
    CameraSettings settings;
    settings.width_px = 64;
    settings.height_px = 48;
    settings.frames_per_s = 60;
    return settings;
  }
  bool hang(bool is_hung) override { return camera_->is_hung = is_hung, true; }
  bool unplug(bool is_unplugged) override { return camera_->is_unplugged = is_unplugged, true; }
  bool slowDown(double factor) override { return camera_->slowdown = factor, true; }
  FakeIidc& camera() { return *camera_; }

 private:
  std::shared_ptr<FakeBus> bus_;
  std::uint64_t guid_;
  std::shared_ptr<FakeIidc> camera_ = std::make_shared<FakeIidc>();
};

TEST(Dc1394, KeepsTheContractOfCamerasAndLeavesNothingOpen) {
  IidcBench bench(std::make_shared<FakeBus>(), 0xb09d0100a1b2c3d4);
  testing::expectCameraContract(bench);
  EXPECT_EQ(bench.camera().devices, 0);
  EXPECT_FALSE(bench.camera().is_running);
}

TEST(Dc1394, TwoKeepTheContractOfLivePairs) {
  const auto bus = std::make_shared<FakeBus>();
  IidcBench left(bus, 0xb09d0100a1b2c3d4), right(bus, 0xb09d0100a1b2c3d5);
  testing::expectLivePairContract(left, right);
}

TEST(Dc1394, IsListedWithItsWorldwideNumber) {
  const auto bus = std::make_shared<FakeBus>();
  IidcBench bench(bus, 0xb09d0100a1b2c3d4);
  const auto found = makeDc1394Backend(bus)->list();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(stableName(found[0].identity), "dc1394:Point Grey Flea2#b09d0100a1b2c3d4");
}

TEST(Dc1394, GreyIsPreferredAndYuvIsDecoded) {
  IidcBench bench(std::make_shared<FakeBus>(), 1);
  const auto camera = bench.open();
  EXPECT_EQ(camera->configure(bench.settings()).format, "GREY");
  auto small = bench.settings();
  small.width_px = 32, small.height_px = 24;
  EXPECT_EQ(camera->configure(small).format, "UYVY");
  camera->start();
  const auto picture = camera->next(1.0);
  ASSERT_TRUE(picture);
  const int first = picture->grey.at<std::uint8_t>(0, 0);
  EXPECT_EQ(picture->grey.at<std::uint8_t>(0, 3), (first + 3) % 200);
}

TEST(Dc1394, LocksTheAdjustmentsAndSaysWhatIsRefused) {
  IidcBench bench(std::make_shared<FakeBus>(), 1);
  auto settings = bench.settings();
  settings.exposure_ms = 8;
  const auto state = bench.open()->configure(settings);
  EXPECT_TRUE(unlockedInWords(state).empty());
  EXPECT_NEAR(bench.camera().adjustments[Dc1394Feature::shutter].value, 0.008, 1e-9);
  EXPECT_FALSE(bench.camera().adjustments[Dc1394Feature::gain].is_automatic);
  EXPECT_EQ(state.controls[2].lock, ControlState::Lock::absent);  // focus
  bench.camera().adjustments[Dc1394Feature::shutter].is_automatic = true;
  bench.camera().is_stuck = true;
  EXPECT_THAT(unlockedInWords(bench.open()->configure(settings)),
              ::testing::Contains("exposure: the camera stays on automatic"));
}

TEST(Dc1394, FaultsAreSaidInPlainWords) {
  IidcBench bench(std::make_shared<FakeBus>(), 1);
  const auto camera = bench.open();
  camera->configure(bench.settings());
  std::string words;
  bench.camera().is_busy = true;
  EXPECT_EQ(faultOf([&] { camera->start(); }, &words), CameraFault::in_use);
  bench.camera().is_busy = false;
  bench.camera().is_bus_full = true;
  EXPECT_EQ(faultOf([&] { camera->start(); }, &words), CameraFault::no_bandwidth);
  EXPECT_THAT(words, HasSubstr("a bus for each camera"));
  bench.camera().is_bus_full = false;
  auto triggered = bench.settings();
  triggered.trigger = Trigger::hardware;
  EXPECT_EQ(faultOf([&] { camera->configure(triggered); }), CameraFault::refused);
  camera->configure(bench.settings());
  camera->start();
  bench.camera().damage = 2;
  ASSERT_TRUE(camera->next(1.0));
  EXPECT_EQ(camera->counts().damaged, 2);
}

/// On a machine without such a bus it lists none, and prints nothing.
TEST(Dc1394, WithoutABusThereIsNoCamera) {
  const auto backend = makeDc1394Backend();
  EXPECT_NO_THROW(backend->list());
  EXPECT_TRUE(faultOf([&] { backend->open({"dc1394", "1", "none", "", ""}); }));
}

}  // namespace
}  // namespace facenav::capture
