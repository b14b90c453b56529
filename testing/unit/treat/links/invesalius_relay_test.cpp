// InvesaliusOutput with a relay of python-socketio, as InVesalius's users run it, and with servers that fail.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "facenav/core/child_process.h"
#include "relay_frames.h"
#include "support/free_port.h"
#include "support/run_program.h"
#include "support/small_relay.h"

namespace facenav::links {
namespace {

using testing::SmallRelay;
using Json = nlohmann::json;

/// The relay, and a robot's program behind it: it writes what it hears, a line each, and says that it is
/// connected.
constexpr const char* kRelay = R"(
import asyncio, json, sys
import socketio
from aiohttp import web
sio = socketio.AsyncServer(async_mode='aiohttp')
app = web.Application()
sio.attach(app)
log = open(sys.argv[2], 'a')
@sio.event
async def from_neuronavigation(sid, msg):
    log.write(json.dumps(msg) + '\n')
    log.flush()
    if msg['topic'].endswith('Connect to robot'):
        await sio.emit('to_neuronavigation', {'topic': 'Robot to Neuronavigation: Robot connection status',
                                              'data': {'data': 'Connected', 'robot_ID': 'robot_1'}})
@sio.event
async def disconnect(sid):
    log.write(json.dumps({'topic': 'left', 'data': {}}) + '\n')
    log.flush()
web.run_app(app, host='127.0.0.1', port=int(sys.argv[1]), print=None, shutdown_timeout=0.2)
)";

class PythonRelay {
 public:
  explicit PythonRelay(int port) : port_(port) { std::ofstream(script()) << kRelay; }
  ~PythonRelay() { stop(); }
  static bool isInstalled() {
    return testing::runProgram("/usr/bin/python3", "-c 'import socketio, aiohttp'").status == 0;
  }
  void start() {
    ChildOptions options;
    options.output = ChildOptions::Output::nowhere;
    process_ = std::make_unique<ChildProcess>(ChildProcess::start(
        {"/usr/bin/python3", script().string(), std::to_string(port_), log().string()}, options));
  }
  void stop() {
    if (process_) process_->end();
    process_.reset();
  }
  std::vector<Json> data(const std::string& topic) const {
    std::vector<Json> found;
    std::istringstream text(testing::readText(log()));
    for (std::string line; std::getline(text, line);) {
      const Json body = Json::parse(line, nullptr, false);
      if (body.is_object() && body["topic"] == topic) found.push_back(body["data"]);
    }
    return found;
  }

 private:
  std::filesystem::path script() const { return folder_.path() / "relay.py"; }
  std::filesystem::path log() const { return folder_.path() / "heard"; }

  testing::TemporaryFolder folder_;
  int port_;
  std::unique_ptr<ChildProcess> process_;
};

TEST(InvesaliusRelay, APythonRelayHearsEverythingAlsoAfterItWasAway) {
  if (!PythonRelay::isInstalled())
    GTEST_SKIP() << "Debian packages python3-socketio and python3-aiohttp are not installed";
  const int port = testing::freePort();
  PythonRelay relay(port);
  auto output = openLiveOutput("invesalius:" + std::to_string(port) + ":robot=192.168.0.9");
  output->publish(guidedFrame());  // nobody is there yet
  relay.start();
  const auto publish = [&] { output->publish(guidedFrame()); };
  const auto isConnected = [&] {
    return output->report().receivers.at(0).find("robot: Connected") != std::string::npos;
  };
  ASSERT_TRUE(comesWithin(8, [&] { return publish(), isConnected() && !relay.data(kTargetTopic).empty(); }));
  EXPECT_GT(relay.data(kPosesTopic).size(), 0u);
  EXPECT_EQ(relay.data("Neuronavigation to Robot: Connect to robot").size(), 1u);
  const auto targets = relay.data(kTargetTopic).size();
  relay.stop();
  ASSERT_TRUE(
      comesWithin(3, [&] { return publish(), output->report().receivers.at(0).find("the relay") == 0; }));
  relay.start();
  ASSERT_TRUE(comesWithin(8, [&] { return publish(), relay.data(kTargetTopic).size() > targets; }));
  EXPECT_EQ(relay.data("Neuronavigation to Robot: Connect to robot").size(), 1u) << "not asked again";
  output.reset();
  EXPECT_TRUE(
      comesWithin(2, [&] { return !relay.data("left").empty() && !relay.data(kNoTargetTopic).empty(); }));
  EXPECT_EQ(relay.data(kPosesTopic).back()["visibilities"], Json({false, false, false}));
}

TEST(InvesaliusRelay, ASilentRelayIsLeftAndJoinedAgain) {
  SmallRelay relay(SmallRelay::Manner::usual, 1000);  // says that it pings at least once a second
  auto output = openLiveOutput(relay.words());
  ASSERT_TRUE(comesWithin(2, [&] { return output->report().receivers.at(0) == "connected"; }));
  EXPECT_TRUE(comesWithin(3, [&] { return output->report().receivers.at(0) == "the relay is silent"; }));
  EXPECT_TRUE(comesWithin(3, [&] { return relay.clients() == 2; }));
}

}  // namespace
}  // namespace facenav::links
