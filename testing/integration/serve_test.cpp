// facenav serve, and --serve and --send of sessions, from the command line.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <future>
#include <memory>
#include <thread>

#include "facenav/links/igtl_content.h"
#include "support/command_line.h"
#include "support/free_port.h"
#include "support/igtl_client.h"
#include "support/recordings.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

using ::testing::HasSubstr;

class Serve : public ::testing::Test {
 protected:
  Serve() { writeSmallRecording(folder_.path() / "recording", 50); }
  std::string recording() const { return (folder_.path() / "recording").string(); }
  TemporaryFolder folder_;
};

TEST_F(Serve, ARecordingWithoutAFaceIsServedAsLost) {
  const int port = freePort();
  auto program = std::async(std::launch::async, [&] {
    return runFacenav("serve " + recording() + " --accept commands --passes 0 --seconds 3 --port " +
                      std::to_string(port));
  });
  std::unique_ptr<LoopbackClient> client;
  for (int i = 0; i < 400 && !client; ++i) {
    try {
      client = std::make_unique<LoopbackClient>(port);
    } catch (const std::runtime_error&) {  // the program has not started yet
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  ASSERT_TRUE(client);
  const auto head = client->next("TRANSFORM", 60000);
  ASSERT_TRUE(head);
  EXPECT_EQ(head->device, "SubjectToTracker");
  EXPECT_TRUE(links::readTransform(head->content)->matrix().isIdentity());
  client->ask("GET_STATUS", "", 2);
  ASSERT_TRUE(client->next("STATUS"));
  const auto coil = client->nextPose("Coil1ToTracker");
  ASSERT_TRUE(coil);
  EXPECT_EQ(coil->value("TransformValid"), "0");
  EXPECT_EQ(coil->value("TransformStatus"), "OUT_OF_VIEW");
  client->ask("STRING", "", 1, links::stringContent({"stop"}));
  client->ask("STRING", "", 1, links::stringContent({"pulse"}));
  EXPECT_TRUE(client->isClosed());
  const auto result = program.get();
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr(": no poses until start"));
  EXPECT_THAT(result.errors, HasSubstr(": a pulse was given"));
  EXPECT_THAT(result.output, HasSubstr("frames served"));
  EXPECT_THAT(result.errors, HasSubstr("is connected"));
}

TEST_F(Serve, OptionsThatDoNotFitAreWrongUsage) {
  const std::string some = "serve " + recording();
  for (const std::string& words :
       {std::string("serve"), some + " --rig R", some + " --target M1", some + " --send udp:5",
        some + " --send osc", some + " --port 70000", some + " --accept targets", some + " --accept all",
        std::string("serve --rig R --case C"), "track " + recording() + " --serve -o poses.csv",
        "track " + recording() + " --send osc:9 -o poses.csv",
        "track " + recording() + " --pulses keyboard --serve here -o poses.csv"})
    EXPECT_EQ(runFacenav(words).status, 2) << words;
  const auto missing = runFacenav("serve " + (folder_.path() / "absent").string());
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(missing.errors.find("sending to"), std::string::npos) << missing.errors;
  const auto used = runFacenav(some + " --address 300.1.1.1");
  EXPECT_EQ(used.status, 1);
  EXPECT_THAT(used.errors, HasSubstr("is no address"));
}

TEST_F(Serve, AMissingLslIsSaidInOneLineWithItsRemedy) {
  ::setenv("FACENAV_LSL", "/nowhere/liblsl.so", 1);
  const auto result = runFacenav("serve " + recording() + " --port 0 --send lsl");
  ::unsetenv("FACENAV_LSL");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.errors, HasSubstr("LSL is not installed"));
  EXPECT_THAT(result.errors, HasSubstr("labstreaminglayer.org"));
  EXPECT_THAT(result.errors, HasSubstr("FACENAV_LSL"));
}

}  // namespace
}  // namespace facenav::testing
