#include <fcntl.h>
#include <linux/serial.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "facenav/core/error.h"
#include "line_edges.h"
#include "sources.h"
#include "threaded_source.h"

namespace facenav::links {
namespace {

constexpr int kReading_ms = 1;  // between two readings of a line; the driver counts what happens in between
constexpr int kRetry_ms = 500;  // after the adapter was unplugged

std::optional<speed_t> speedOf(int baud) {
  constexpr std::pair<int, speed_t> kSpeeds[] = {{1200, B1200},   {2400, B2400},     {4800, B4800},
                                                 {9600, B9600},   {19200, B19200},   {38400, B38400},
                                                 {57600, B57600}, {115200, B115200}, {230400, B230400}};
  for (const auto& [number, speed] : kSpeeds)
    if (number == baud) return speed;
  return std::nullopt;
}

class SerialSource : public ThreadedSource {
 public:
  SerialSource(const std::string& name, SerialPort port, double dead_time_s)
      : ThreadedSource(name, dead_time_s), port_(std::move(port)) {}
  ~SerialSource() override { stop(); }

 private:
  void open() override;
  void run() override;
  void close() override;
  void runBytes();
  void runLine();
  std::optional<int> changes() const;
  std::optional<LineReading> reading() const;

  SerialPort port_;
  int descriptor_ = -1;
};

/// Opens the port raw, without flow control. The output lines RTS and DTR may be wired to a stimulator's
/// trigger: they are lowered as soon as the port is open, and nothing is ever written.
void SerialSource::open() {
  const auto speed = speedOf(port_.baud);
  if (!speed)
    throw Error(std::to_string(port_.baud) + " baud are not possible", name(), "use 9600 or 115200");
  descriptor_ = ::open(port_.device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  termios settings{};
  if (descriptor_ < 0 || ::tcgetattr(descriptor_, &settings) != 0)
    throw Error(std::string("cannot be opened (") + std::strerror(errno) + ")", port_.device,
                "is the adapter plugged in, and may you use it (group dialout)?");
  const int outputs = TIOCM_DTR | TIOCM_RTS;
  ::ioctl(descriptor_, TIOCMBIC, &outputs);
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~tcflag_t(HUPCL | CRTSCTS);
  settings.c_cc[VMIN] = 1;  // no byte is then EAGAIN, and 0 bytes mean that the port has gone
  settings.c_cc[VTIME] = 0;
  ::cfsetispeed(&settings, *speed);
  ::cfsetospeed(&settings, *speed);
  ::tcsetattr(descriptor_, TCSANOW, &settings);
  ::tcflush(descriptor_, TCIFLUSH);
  if (port_.signal != SerialSignal::byte && !reading())
    throw Error("has no CTS and DSR lines to read", port_.device, "use another port, or bytes");
}

void SerialSource::close() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

/// Number of changes counted by the driver; nothing if it does not count.
std::optional<int> SerialSource::changes() const {
  serial_icounter_struct counts{};
  if (::ioctl(descriptor_, TIOCGICOUNT, &counts) != 0) return std::nullopt;
  return port_.signal == SerialSignal::cts ? counts.cts : counts.dsr;
}

std::optional<LineReading> SerialSource::reading() const {
  const int mask = port_.signal == SerialSignal::cts ? TIOCM_CTS : TIOCM_DSR;
  for (;;) {
    const auto before = changes();
    int lines = 0;
    if (::ioctl(descriptor_, TIOCMGET, &lines) != 0) return std::nullopt;
    if (changes() == before)
      return LineReading{(lines & mask) != 0, before};  // else the line changed in between
  }
}

/// Reads bytes until the port is gone.
void SerialSource::runBytes() {
  std::vector<pollfd> waiting{{descriptor_, POLLIN, 0}};
  while (!isStopping()) {
    waitFor(waiting, -1);
    char bytes[256];
    const ssize_t size = ::read(descriptor_, bytes, sizeof bytes);
    const bool has_gone = size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR);
    if (has_gone && !isStopping()) return;
    for (ssize_t i = 0; i < size; ++i) tellPulse();
  }
}

void SerialSource::runLine() {
  auto before = reading();
  while (!isStopping() && before) {
    waitFor(kReading_ms);
    const auto now = reading();
    if (!now) return;
    for (int edges = risingEdges(*before, *now); edges > 0; --edges) tellPulse();
    before = now;
  }
}

void SerialSource::run() {
  while (!isStopping()) {
    port_.signal == SerialSignal::byte ? runBytes() : runLine();
    if (isStopping()) return;
    tellProblem(port_.device + " was unplugged: no pulse arrives from it");
    close();
    while (!isStopping() && descriptor_ < 0) {
      waitFor(kRetry_ms);
      try {
        open();
        tellProblem("");
      } catch (const Error&) {
        close();
      }
    }
  }
}

}  // namespace

std::unique_ptr<PulseSource> makeSerialSource(const std::string& name, const SerialPort& port,
                                              double dead_time_s) {
  return std::make_unique<SerialSource>(name, port, dead_time_s);
}

}  // namespace facenav::links
