// Every source by its real way in: sockets, a pair of pseudo terminals, a stand-in for liblsl.

#include <arpa/inet.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <pty.h>
#include <sys/socket.h>
#include <unistd.h>

#include "facenav/core/error.h"
#include "support/pulse_source_contract.h"

namespace facenav::links {
namespace {

using ::testing::HasSubstr;
using testing::HeardPulses;

constexpr double kThetaBurst_s = 0.02, kByHand_s = 0.16;

/// A socket that sends to this machine.
class Sender {
 public:
  Sender(int type, int port) : socket_(::socket(AF_INET, type | SOCK_CLOEXEC, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(std::uint16_t(port));
    ::inet_pton(AF_INET, "127.0.0.1", &to.sin_addr);
    for (int i = 0; i < 200; ++i)
      if (::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) break;
  }
  ~Sender() { ::close(socket_); }
  void send(const std::string& text) const {
    ASSERT_EQ(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), ssize_t(text.size()));
  }

 private:
  int socket_;
};

/// A port that is free now.
int freePort(int type) {
  const int socket = ::socket(AF_INET, type, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof place;
  ::bind(socket, reinterpret_cast<const sockaddr*>(&place), size);
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&place), &size);
  ::close(socket);
  return ntohs(place.sin_port);
}

TEST(PulseSources, TheKeyboardKeepsTheContract) {
  KeyboardSource source;
  testing::expectPulseSourceContract(
      source, [&] { source.press(); }, kByHand_s);
}

TEST(PulseSources, UdpKeepsTheContract) {
  const int port = freePort(SOCK_DGRAM);
  const auto source = openPulseSource("udp:127.0.0.1:" + std::to_string(port));
  const Sender sender(SOCK_DGRAM, port);
  testing::expectPulseSourceContract(
      *source, [&] { sender.send(R"({"pulse": true})"); }, kThetaBurst_s);
}

TEST(PulseSources, TcpKeepsTheContract) {
  const int port = freePort(SOCK_STREAM);
  const auto source = openPulseSource("tcp:127.0.0.1:" + std::to_string(port));
  std::unique_ptr<Sender> sender;
  testing::expectPulseSourceContract(
      *source,
      [&] {
        static int times = 0;
        if (times == 0 || times == 16) sender = std::make_unique<Sender>(SOCK_STREAM, port);  // each start
        ++times;
        sender->send("{\"pulse\": 1}\n");
      },
      kThetaBurst_s);
}

/// A pair of pseudo terminals: what is written to `master` arrives at the port.
struct Terminals {
  Terminals() {
    char path[128] = "";
    int slave = -1;
    if (::openpty(&master, &slave, path, nullptr, nullptr) == 0) ::close(slave);
    port = path;
  }
  ~Terminals() { hangUp(); }
  void hangUp() {
    if (master >= 0) ::close(std::exchange(master, -1));
  }
  void send(const std::string& bytes) const {
    ASSERT_EQ(::write(master, bytes.data(), bytes.size()), ssize_t(bytes.size()));
  }
  int master = -1;
  std::string port;
};

TEST(PulseSources, ASerialLineKeepsTheContract) {
  const Terminals terminals;
  const auto source = openPulseSource("serial:" + terminals.port);
  testing::expectPulseSourceContract(
      *source, [&] { terminals.send("x"); }, kThetaBurst_s);
}

TEST(PulseSources, AnUnpluggedSerialLineIsSaid) {
  Terminals terminals;
  const auto source = openPulseSource("serial:" + terminals.port);
  HeardPulses heard;
  source->start(heard.listener());
  terminals.send("x");
  ASSERT_TRUE(heard.waitFor(1));
  terminals.hangUp();
  for (int i = 0; i < 1000 && heard.problems().empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_FALSE(heard.problems().empty());
  EXPECT_THAT(heard.problems()[0], HasSubstr("was unplugged"));
  source->stop();
}

TEST(PulseSources, NothingIsEverWrittenToASerialLine) {
  const Terminals terminals;
  ::fcntl(terminals.master, F_SETFL, O_NONBLOCK);
  const auto source = openPulseSource("serial:" + terminals.port);
  HeardPulses heard;
  source->start(heard.listener());
  terminals.send("abc\n\r");
  ASSERT_TRUE(heard.waitFor(5));
  char byte = 0;
  EXPECT_LT(::read(terminals.master, &byte, 1), 0) << "an echo, or a command to the stimulator";
  source->stop();
}

TEST(PulseSources, APortWithoutLinesIsRefusedForEdges) {
  const Terminals terminals;
  const auto source = openPulseSource("serial:" + terminals.port + ":cts");
  EXPECT_THROW(source->start({}), Error) << "a pseudo terminal has no CTS";
}

TEST(PulseSources, LslKeepsTheContract) {
  void* fake = ::dlopen("liblsl.so.2", RTLD_NOW);
  ASSERT_NE(fake, nullptr) << ::dlerror();
  const auto send = reinterpret_cast<void (*)()>(::dlsym(fake, "fake_lsl_send"));
  ASSERT_NE(send, nullptr) << "this is another liblsl";
  const auto source = openPulseSource("lsl:tms");
  int times = 0;
  testing::expectPulseSourceContract(
      *source,
      [&] {
        // An inlet takes a moment to be there; samples before it are not heard.
        if (times == 0 || times == 16) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        ++times;
        send();
      },
      kThetaBurst_s);
}

TEST(PulseSources, AnLslStreamThatIsNotThereIsSaid) {
  const auto source = openPulseSource("lsl:other");
  HeardPulses heard;
  source->start(heard.listener());
  for (int i = 0; i < 1000 && heard.problems().empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  source->stop();
  ASSERT_FALSE(heard.problems().empty());
  EXPECT_THAT(heard.problems()[0], HasSubstr("other"));
}

TEST(PulseSources, AMessageThatIsNoPulseIsSaidAndNotCounted) {
  const int port = freePort(SOCK_DGRAM);
  const auto source = openPulseSource("udp:127.0.0.1:" + std::to_string(port));
  HeardPulses heard;
  source->start(heard.listener());
  const Sender sender(SOCK_DGRAM, port);
  for (const char* text : {"", "pulse", "[1]", R"({"pulse": false})", R"({"armed": true})", "\xff\xfe{"})
    sender.send(text);
  sender.send(R"({"pulse": true, "intensity_pct": 55.5})");
  ASSERT_TRUE(heard.waitFor(1));
  EXPECT_DOUBLE_EQ(heard.triggers()[0].intensity_pct.value(), 55.5);
  ASSERT_EQ(heard.problems().size(), 2u) << "said once, and that it works again";
  EXPECT_THAT(heard.problems()[0], HasSubstr("was no pulse"));
  EXPECT_EQ(heard.problems()[1], "");
  source->stop();
}

TEST(PulseSources, ATakenPortIsRefusedInOneLine) {
  const int port = freePort(SOCK_STREAM);
  const auto first = openPulseSource("tcp:127.0.0.1:" + std::to_string(port));
  const auto second = openPulseSource("tcp:127.0.0.1:" + std::to_string(port));
  first->start({});
  EXPECT_THROW(second->start({}), Error);
  first->stop();
  EXPECT_NO_THROW(second->start({})) << "free again";
  second->stop();
}

TEST(PulseSources, UnknownWordsAreRefused) {
  for (const char* words : {"", "udp", "udp:x", "udp:99999", "tcp:a:b:c", "serial:", "serial:/dev/ttyS0:rts",
                            "usb:1", "udp:5005:dead=x", "dead=0.1", "lsl:a:b"})
    EXPECT_THROW(openPulseSource(words), Error) << words;
  EXPECT_NO_THROW(openPulseSource("serial:/dev/ttyS0:cts:dead=0.15"));
  EXPECT_NO_THROW(openPulseSource("serial:/dev/ttyS0:115200"));
}

}  // namespace
}  // namespace facenav::links
