// Every source by its real input: sockets, a pair of pseudo terminals, a fake liblsl.

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

/// Socket that sends to this machine.
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

/// Port that is free now.
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

TEST(PulseSources, APressThatIsHandledLateHasTheTimeOfThePress) {
  KeyboardSource source;
  HeardPulses heard;
  source.start(heard.listener());
  const Timestamp now = Timestamp::now();
  for (const double age_s : {3.0, 2.0, 1.0, 0.0}) source.press({now.s - age_s});
  const auto triggers = heard.triggers();
  ASSERT_EQ(triggers.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(triggers[i].at.s, now.s - 3.0 + double(i), 1e-6);
  const std::chrono::duration<double> apart = triggers[3].utc - triggers[0].utc;
  EXPECT_NEAR(apart.count(), 3.0, 0.05);
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

/// Pair of pseudo terminals: bytes written to `master` arrive at the port.
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

/// The fake liblsl; the destructor resets its clock.
struct FakeLsl {
  FakeLsl() : library(::dlopen("liblsl.so.2", RTLD_NOW)) {
    find("fake_lsl_send", send);
    find("fake_lsl_send_late", sendLate);
    find("fake_lsl_set_clock", setClock);
    find("fake_lsl_reset_clock", resetClock);
    find("fake_lsl_is_followed", isFollowed);
    find("fake_lsl_send_text", sendText);
    find("fake_lsl_show_own", showOwn);
  }
  ~FakeLsl() {
    if (resetClock) resetClock();
  }
  template <class Function>
  void find(const char* name, Function& function) const {
    if (library) function = reinterpret_cast<Function>(::dlsym(library, name));
  }
  /// Returns false if this is another liblsl, or none.
  bool isThere() const { return send && sendLate && setClock && resetClock && isFollowed; }

  void* library;
  void (*send)() = nullptr;
  void (*sendLate)(double age_s) = nullptr;
  void (*setClock)(double behind_s, double correction_s, int has_correction) = nullptr;
  void (*resetClock)() = nullptr;
  int (*isFollowed)() = nullptr;
  void (*sendText)(double age_s, const char* text) = nullptr;
  void (*showOwn)(int has_own) = nullptr;
};

template <class Condition>
bool comes(Condition condition) {
  for (int i = 0; i < 5000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

/// Source that follows the fake stream, and its reports.
class LslClock : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(lsl_.isThere());
    source_ = openPulseSource("lsl:tms");
  }
  void TearDown() override {
    if (source_) source_->stop();
  }
  void start() {
    source_->start(heard_.listener());
    ASSERT_TRUE(comes([&] { return lsl_.isFollowed() != 0; }));
  }
  /// Time by which a pulse made `age_s` ago is dated before its sending; at most 0: dated by its arrival.
  double datedBack_s(double age_s) {
    const std::size_t count = heard_.triggers().size() + 1;
    const Timestamp before = Timestamp::now();
    lsl_.sendLate(age_s);
    EXPECT_TRUE(heard_.waitFor(count));
    return heard_.triggers().size() == count ? before - heard_.triggers().back().at : 1e9;
  }

  static constexpr double kNear_s = 0.2;
  const FakeLsl lsl_;
  HeardPulses heard_;
  std::unique_ptr<PulseSource> source_;
};

TEST_F(LslClock, PulsesAreTimedByTheirArrivalUntilTheClockIsKnownAndThatIsSaidOnce) {
  lsl_.setClock(7200, 0, 0);
  start();
  for (int i = 0; i < 3; ++i) EXPECT_LE(datedBack_s(0.5), 0) << "no foreign stamp is taken";
  ASSERT_EQ(heard_.problems().size(), 1u);
  EXPECT_THAT(heard_.problems()[0], HasSubstr("is not known: pulses are timed by their arrival"));
  lsl_.setClock(7200, 7200, 1);
  ASSERT_TRUE(comes([&] { return heard_.problems().size() == 2; })) << "taken back without a pulse";
  EXPECT_EQ(heard_.problems()[1], "");
  EXPECT_NEAR(datedBack_s(0.5), 0.5, kNear_s);
  EXPECT_EQ(heard_.problems().size(), 2u);
}

TEST_F(LslClock, IsFollowedWhileItDrifts) {
  start();
  EXPECT_NEAR(datedBack_s(0.5), 0.5, kNear_s);
  lsl_.setClock(1000.7, 1000.7, 1);
  EXPECT_NEAR(datedBack_s(0.5), 0.5, kNear_s) << "the first correction would make it 1.2 s";
  EXPECT_TRUE(heard_.problems().empty());
}

TEST_F(LslClock, ARebootedComputersPulsesAreTimedByTheirArrivalUntilItsClockIsKnown) {
  start();
  EXPECT_NEAR(datedBack_s(0), 0, kNear_s);
  lsl_.setClock(90000, 1000, 1);  // it counts from its start; the old correction is still set
  for (int i = 0; i < 2; ++i) EXPECT_LE(datedBack_s(0.5), 0);
  lsl_.setClock(90000, 0, 0);
  EXPECT_LE(datedBack_s(0.5), 0);
  lsl_.setClock(90000, 90000, 1);
  ASSERT_TRUE(comes([&] { return heard_.problems().size() == 3; }));
  EXPECT_THAT(heard_.problems()[0], HasSubstr("more than a second off"));
  EXPECT_THAT(heard_.problems()[1], HasSubstr("is not known"));
  EXPECT_EQ(heard_.problems()[2], "");
  EXPECT_NEAR(datedBack_s(0.5), 0.5, kNear_s);
}

TEST_F(LslClock, AStampHoursAwayIsNotTakenAndSaidOnceUntilOneIsGood) {
  start();
  for (const double away_s : {7200.0, -7200.0, 1.5}) {
    EXPECT_LE(datedBack_s(away_s), 0) << away_s;
    std::this_thread::sleep_for(std::chrono::milliseconds(120));  // longer than the wait for a sample
  }
  ASSERT_EQ(heard_.problems().size(), 1u) << "the clock's being known takes nothing back";
  EXPECT_THAT(heard_.problems()[0], HasSubstr("more than a second off"));
  EXPECT_NEAR(datedBack_s(0.4), 0.4, kNear_s);
  ASSERT_EQ(heard_.problems().size(), 2u);
  EXPECT_EQ(heard_.problems()[1], "");
}

TEST(PulseSources, LslKeepsTheContract) {
  const FakeLsl lsl;
  ASSERT_TRUE(lsl.isThere());
  const auto source = openPulseSource("lsl:tms");
  int times = 0;
  testing::expectPulseSourceContract(
      *source,
      [&] {
        // An inlet takes a moment to connect; earlier samples are not received.
        if (times == 0 || times == 16) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        ++times;
        lsl.send();
      },
      kThetaBurst_s);
}

TEST(PulseSources, AnLslMarkerIsChosenByItsText) {
  const FakeLsl lsl;
  ASSERT_TRUE(lsl.isThere());
  const auto source = openPulseSource("lsl:tms:T");
  HeardPulses heard;
  source->start(heard.listener());
  ASSERT_TRUE(comes([&] { return lsl.isFollowed() != 0; }));
  for (const char* text : {"S1", "T", "t", "", "TT", "T"}) lsl.sendText(0, text);
  EXPECT_TRUE(heard.waitFor(2));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(heard.triggers().size(), 2u);
  source->stop();
}

TEST(PulseSources, FaceNavsOwnLslMarkersAreNoPulses) {
  const FakeLsl lsl;
  ASSERT_TRUE(lsl.isThere());
  lsl.showOwn(1);  // it answers first
  const auto source = openPulseSource("lsl");
  HeardPulses heard;
  source->start(heard.listener());
  ASSERT_TRUE(comes([&] { return lsl.isFollowed() != 0; })) << "the other stream is found behind it";
  lsl.send();
  EXPECT_TRUE(heard.waitFor(1));
  source->stop();
  lsl.showOwn(0);
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
  for (const char* text : {"", "pulse", "[1]", R"({"pulse": false})", R"({"armed": true})", "\xff\xfe{",
                           R"({"pulse": "maybe"})", R"({"pulse": 0})", R"({"pulse": -1})", R"({"pulse": []})",
                           R"({"pulse": {}})", R"({"pulse": null})", R"({"pulse": "true"})"})
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
                            "usb:1", "udp:5005:dead=x", "dead=0.1", "lsl:a:b:c", "lsl:a:"})
    EXPECT_THROW(openPulseSource(words), Error) << words;
  EXPECT_NO_THROW(openPulseSource("serial:/dev/ttyS0:cts:dead=0.15"));
  EXPECT_NO_THROW(openPulseSource("serial:/dev/ttyS0:115200"));
}

}  // namespace
}  // namespace facenav::links
