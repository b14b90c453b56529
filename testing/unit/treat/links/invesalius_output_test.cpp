#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/core/timestamp.h"
#include "relay_frames.h"
#include "support/free_port.h"
#include "support/small_relay.h"

namespace facenav::links {
namespace {

using testing::SmallRelay;
using Json = nlohmann::json;

std::string firstReceiver(const LiveOutput& output) { return output.report().receivers.at(0); }

/// Publishes frames until the condition holds.
bool comesWith(LiveOutput& output, const std::function<std::shared_ptr<LiveFrame>()>& make,
               const std::function<bool()>& condition) {
  return comesWithin(3, [&] {
    output.publish(make());
    return condition();
  });
}

TEST(InvesaliusOutput, SendsPosesThenTheTargetOnceAndTakesBothBackAtTheEnd) {
  SmallRelay relay;
  auto output = openLiveOutput(relay.words());
  ASSERT_TRUE(comesWith(
      *output, [] { return guidedFrame(); }, [&] { return relay.data(kPosesTopic).size() > 3; }));
  EXPECT_EQ(relay.data(kTargetTopic).size(), 1u);
  EXPECT_TRUE(relay.data("Neuronavigation to Robot: Connect to robot").empty()) << "only when asked to";
  for (const auto& text : relay.heard()) {
    EXPECT_EQ(text.find("objective"), std::string::npos) << "nothing moves the robot";
    EXPECT_EQ(text.find("restart"), std::string::npos);
  }
  EXPECT_EQ(relay.data(kPosesTopic).front()["visibilities"], Json({false, true, true}));
  ASSERT_TRUE(comesWith(
      *output, [] { return guidedFrame(true, false); },
      [&] {
        return relay.data(kPosesTopic).back()["visibilities"] == Json({false, false, false});
      }));
  EXPECT_TRUE(relay.data(kNoTargetTopic).empty()) << "a lost head does not unset the target";
  ASSERT_TRUE(comesWith(
      *output, [] { return guidedFrame(); },
      [&] {
        return relay.data(kPosesTopic).back()["visibilities"] == Json({false, true, true});
      }));
  EXPECT_EQ(relay.data(kTargetTopic).size(), 1u);
  output.reset();
  ASSERT_TRUE(comesWithin(2, [&] { return relay.data(kNoTargetTopic).size() == 1; }));
  EXPECT_EQ(relay.data(kPosesTopic).back()["visibilities"], Json({false, false, false}));
  EXPECT_EQ(relay.data("From Neuronavigation: Coil at target").back()["state"], false);
}

TEST(InvesaliusOutput, ARobotsWordsAreShownAndItsConnectionGetsTheTargetAnew) {
  SmallRelay relay;
  auto output = openLiveOutput(relay.words() + ":robot=192.168.0.9");
  ASSERT_TRUE(comesWith(
      *output, [] { return guidedFrame(); }, [&] { return relay.data(kTargetTopic).size() == 1; }));
  ASSERT_EQ(relay.data("Neuronavigation to Robot: Connect to robot").size(), 1u);
  EXPECT_EQ(relay.data("Neuronavigation to Robot: Connect to robot")[0]["robot_IP"], "192.168.0.9");
  relay.say(
      R"(42["to_neuronavigation",{"topic":"Robot to Neuronavigation: Robot connection status","data":{"data":"Connected"}}])");
  ASSERT_TRUE(comesWith(
      *output, [] { return guidedFrame(); }, [&] { return relay.data(kTargetTopic).size() == 2; }));
  relay.say(
      R"(42["to_neuronavigation",{"topic":"Robot to Neuronavigation: Update robot warning","data":{"robot_warning":"too far"}}])");
  EXPECT_TRUE(comesWithin(2, [&] {
    return firstReceiver(*output) == "connected, robot: Connected, robot warns: too far";
  })) << firstReceiver(*output);
  output->publish(guidedFrame(false));
  EXPECT_TRUE(comesWithin(2, [&] { return relay.data(kNoTargetTopic).size() == 1; }));
  relay.say("2");
  EXPECT_TRUE(comesWithin(2, [&] {
    return relay.heard().back() == "3" || relay.heard()[relay.heard().size() - 2] == "3";
  })) << "the answer to a ping";
}

TEST(InvesaliusOutput, AFrameThatStaysTheLastIsTakenBack) {
  SmallRelay relay;
  auto output = openLiveOutput(relay.words());
  ASSERT_TRUE(comesWith(
      *output, [] { return guidedFrame(); }, [&] { return !relay.data(kPosesTopic).empty(); }));
  EXPECT_TRUE(comesWithin(2, [&] {
    return relay.data(kPosesTopic).back()["visibilities"] == Json({false, false, false});
  })) << "no frame has come for a quarter of a second";
}

TEST(InvesaliusOutput, GarbageOrNobodyIsSaidAndPublishingNeverWaits) {
  SmallRelay garbage(SmallRelay::Manner::garbage);
  const SmallRelay silent(SmallRelay::Manner::silent);
  const auto first = openLiveOutput(garbage.words()), second = openLiveOutput(silent.words()),
             third = openLiveOutput("invesalius:" + std::to_string(testing::freePort()));
  EXPECT_TRUE(comesWithin(2, [&] { return garbage.clients() > 0 && silent.clients() > 0; }));
  const auto frame = guidedFrame();
  const Timestamp begin = Timestamp::now();
  for (int i = 0; i < 1000; ++i)
    for (const auto* output : {&first, &second, &third}) (*output)->publish(frame);
  EXPECT_LT(Timestamp::now() - begin, 1.0) << "three thousand frames, handed over";
  EXPECT_TRUE(
      comesWithin(2, [&] { return firstReceiver(*first).find("no web server") != std::string::npos; }));
  EXPECT_TRUE(comesWithin(2, [&] { return firstReceiver(*third).find("not there") != std::string::npos; }));
  EXPECT_EQ(firstReceiver(*second), "connecting");
}

TEST(InvesaliusOutput, ItsWordsNameRelayAndRobot) {
  for (const char* words : {"invesalius:5000", "invesalius:192.168.0.5:5000",
                            "invesalius:5000:robot=192.168.0.9", "lsl", "lsl:Other"})
    EXPECT_NO_THROW(requireLiveOutput(words)) << words;
  for (const char* words :
       {"invesalius", "invesalius:", "invesalius:0", "invesalius:a:b",
        "invesalius:5000:robot=", "osc:9000:robot=1.2.3.4", "invesalius:5000:robot=1:2", "lsl:", "lsl:a:b"})
    EXPECT_THROW(requireLiveOutput(words), Error) << words;
}

}  // namespace
}  // namespace facenav::links
