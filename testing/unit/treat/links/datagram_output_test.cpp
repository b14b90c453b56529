#include "live/datagram_output.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "facenav/core/error.h"

namespace facenav::links {
namespace {

LiveFrame oneFrame() {
  LiveFrame frame;
  frame.number = 12;
  frame.utc = std::chrono::system_clock::time_point(std::chrono::milliseconds(1772706030125));
  frame.state = "adjust";
  frame.instruction = "tilt \"left\"";
  frame.target = "M1";
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(1, 2, 3);
  frame.poses = {{"CoilToMri", pose}, {"CoilToTarget", std::nullopt, "OUT_OF_VIEW"}};
  frame.guidance = LiveGuidance{2.5, 2, 1.5, 3, -4};
  return frame;
}

/// A UDP socket on a free port of loopback.
class Receiver {
 public:
  Receiver() : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    place_.sin_family = AF_INET;
    place_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place_;
    (void)::bind(socket_, reinterpret_cast<sockaddr*>(&place_), size);
    (void)::getsockname(socket_, reinterpret_cast<sockaddr*>(&place_), &size);
  }
  ~Receiver() { ::close(socket_); }
  std::string port() const { return std::to_string(ntohs(place_.sin_port)); }
  std::string next() const {
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, 5000) <= 0) return {};
    char text[4096];
    const ssize_t size = ::recv(socket_, text, sizeof text, 0);
    return {text, std::size_t(std::max<ssize_t>(size, 0))};
  }

 private:
  int socket_;
  sockaddr_in place_{};
};

std::string padded(std::string text) {
  text.push_back('\0');
  while (text.size() % 4 != 0) text.push_back('\0');
  return text;
}

TEST(OscBundle, HasTheBytesOfTheSpecification) {
  PulseTrigger pulse;
  pulse.source = "udp:5005";
  pulse.intensity_pct = 1.0;
  pulse.utc = std::chrono::system_clock::time_point(std::chrono::seconds(1));
  const std::string message =
      padded("/facenav/pulse") + padded(",sf") + padded("udp:5005") + std::string("\x3F\x80\x00\x00", 4);
  const std::string expected = padded("#bundle") + std::string("\x83\xAA\x7E\x81\x00\x00\x00\x00", 8) +
                               std::string("\x00\x00\x00", 3) + char(message.size()) + message;
  EXPECT_EQ(oscBundle(pulse), expected);
}

TEST(OscBundle, ALostPoseIsMarkedAndHasNoPlace) {
  const std::string bundle = oscBundle(oneFrame());
  EXPECT_EQ(bundle.size() % 4, 0u);
  const std::string types = padded(",ifffffff");
  const std::string lost = padded("/facenav/pose/CoilToTarget") + types + std::string(28, '\0') +
                           std::string(4, '\0').replace(0, 4, std::string("\x3F\x80\x00\x00", 4));
  EXPECT_NE(bundle.find(lost), std::string::npos);
  const std::string seen = padded("/facenav/pose/CoilToMri") + types + std::string("\x00\x00\x00\x01", 4) +
                           std::string("\x3F\x80\x00\x00\x40\x00\x00\x00\x40\x40\x00\x00", 12);
  EXPECT_NE(bundle.find(seen), std::string::npos);
  EXPECT_NE(bundle.find(padded("/facenav/guidance") + padded(",fffff")), std::string::npos);
}

TEST(JsonLine, HoldsPosesStateAndGuidance) {
  const std::string line = jsonLine(oneFrame());
  ASSERT_EQ(line.back(), '\n');
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json["utc"], "2026-03-05T10:20:30.125Z");
  EXPECT_EQ(json["poses"]["CoilToMri"]["rows"],
            nlohmann::json({1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 2.0, 0.0, 0.0, 1.0, 3.0}));
  EXPECT_EQ(json["poses"]["CoilToTarget"]["valid"], false);
  EXPECT_TRUE(json["poses"]["CoilToTarget"]["rows"].is_null());
  EXPECT_EQ(json["instruction"], "tilt \"left\"");
  EXPECT_EQ(json["guidance"]["twist_deg"], -4.0);
}

TEST(DatagramOutput, SendsFramesPulsesAndTheEnd) {
  const Receiver receiver;
  auto output = openLiveOutput("json:" + receiver.port());
  output->publish(std::make_shared<LiveFrame>(oneFrame()));
  EXPECT_EQ(nlohmann::json::parse(receiver.next())["frame"], 12);
  output->publish(PulseTrigger{"pedal"});
  std::string line = receiver.next();
  while (line.find("pulse") == std::string::npos && !line.empty()) line = receiver.next();
  EXPECT_EQ(nlohmann::json::parse(line)["source"], "pedal");
  output.reset();
  EXPECT_EQ(nlohmann::json::parse(receiver.next())["state"], "lost");
}

TEST(DatagramOutput, AReceiverThatIsNotThereDoesNoHarm) {
  auto output = openLiveOutput("osc:127.0.0.1:" + Receiver().port());  // closed again
  for (int i = 0; i < 50; ++i) output->publish(std::make_shared<LiveFrame>(oneFrame()));
  output.reset();
  EXPECT_THROW(openLiveOutput("osc:no.such.host.invalid:9000"), Error);
}

}  // namespace
}  // namespace facenav::links
