#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/timestamp.h"
#include "facenav/core/utc_time.h"
#include "facenav/links/live_output.h"
#include "relay_frames.h"

namespace facenav::links {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

constexpr double kAhead_s = 500;  // of the fake's clock

/// The fake liblsl's record of outlets.
struct FakeOutlets {
  FakeOutlets() : library(::dlopen("liblsl.so.2", RTLD_NOW)) {
    find("fake_lsl_outlet", outlet);
    find("fake_lsl_pushed", pushed);
    find("fake_lsl_pushed_at", pushedAt);
    find("fake_lsl_listen", listen);
  }
  template <class Function>
  void find(const char* name, Function& function) const {
    if (library) function = reinterpret_cast<Function>(::dlsym(library, name));
  }
  Json text(int index, double* stamp_s = nullptr) const {
    const char* text = "";
    const double stamp = pushedAt(index, &text);
    if (stamp_s) *stamp_s = stamp;
    return Json::parse(text, nullptr, false);
  }
  void* library;
  const char* (*outlet)() = nullptr;
  int (*pushed)() = nullptr;
  double (*pushedAt)(int index, const char** text) = nullptr;
  void (*listen)(int) = nullptr;
};

std::shared_ptr<LiveFrame> stateFrame(const std::string& state, const std::string& target = "M1") {
  auto frame = std::make_shared<LiveFrame>();
  frame->utc = std::chrono::system_clock::now();
  frame->state = state;
  frame->target = target;
  frame->poses = {{"CoilToMri", Eigen::Isometry3d::Identity()}};
  return frame;
}

TEST(LslOutput, IsAStreamOfMarkersWithTheWordsOfTheJsonOutputAndNoPoses) {
  const FakeOutlets fake;
  ASSERT_TRUE(fake.pushedAt && fake.listen);
  auto output = openLiveOutput("lsl");
  EXPECT_THAT(fake.outlet(), StartsWith("FaceNav|Markers|1|0|3|facenav-markers|"));
  EXPECT_THAT(fake.outlet(), HasSubstr("monotonic_clock_to_lsl_s=500.0"));
  PulseTrigger pulse{"pedal"};
  pulse.at.s = Timestamp::now().s - 0.3;  // it is handed over late
  pulse.intensity_pct = 52.0;
  output->publish(pulse);
  ASSERT_TRUE(comesWithin(2, [&] { return fake.pushed() == 1; }));
  double stamp_s = 0;
  EXPECT_EQ(
      fake.text(0, &stamp_s),
      Json({{"pulse", true}, {"utc", isoUtc(pulse.utc)}, {"source", "pedal"}, {"intensity_pct", 52.0}}));
  EXPECT_NEAR(stamp_s, pulse.at.s + kAhead_s, 1e-3) << "LSL's clock at the pulse's own time";
  int told = 1;
  for (const char* state : {"adjust", "adjust", "on_target", "on_target", "lost"}) {
    const bool is_new = told == 1 || fake.text(told - 1)["state"] != state;
    output->publish(stateFrame(state));
    told += is_new;
    ASSERT_TRUE(comesWithin(2, [&] { return fake.pushed() == told; })) << state;
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    ASSERT_EQ(fake.pushed(), told) << "changes alone";
  }
  const auto state = fake.text(2, &stamp_s);
  EXPECT_EQ(state["state"], "on_target");
  EXPECT_EQ(state["target"], "M1");
  EXPECT_FALSE(state.contains("poses"));
  EXPECT_NEAR(stamp_s, Timestamp::now().s + kAhead_s, 2);
  EXPECT_THAT(output->report().receivers.at(0), HasSubstr("nobody listens"));
  fake.listen(1);
  EXPECT_TRUE(comesWithin(
      2, [&] { return output->report().receivers.at(0).find("listened to") != std::string::npos; }));
  fake.listen(0);
  output.reset();
  EXPECT_STREQ(fake.outlet(), "");
}

TEST(LslOutput, TheStreamsNameCanBeChosen) {
  const FakeOutlets fake;
  const auto output = openLiveOutput("lsl:Room 2");
  EXPECT_THAT(fake.outlet(), StartsWith("Room 2|Markers|"));
}

}  // namespace
}  // namespace facenav::links
