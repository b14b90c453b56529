#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>

#include "facenav/capture/v4l2_driver.h"

namespace facenav::capture {
namespace {

class SystemV4l2Driver : public V4l2Driver {
 public:
  // Non-blocking, because a hung camera must not block the thread in DQBUF.
  int open(const std::string& path) override {
    return orError(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  }
  void close(int device) override { ::close(device); }
  int control(int device, unsigned long request, void* argument) override {
    int result = 0;
    do {
      result = ::ioctl(device, request, argument);
    } while (result == -1 && errno == EINTR);
    return orError(result);
  }
  void* map(int device, std::size_t length, std::size_t offset) override {
    void* address = ::mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, device, off_t(offset));
    return address == MAP_FAILED ? nullptr : address;
  }
  void unmap(void* address, std::size_t length) override { ::munmap(address, length); }
  int wait(int device, int timeout_ms) override {
    pollfd descriptor{device, POLLIN, 0};
    const int result = ::poll(&descriptor, 1, timeout_ms);
    return result == -1 && errno == EINTR ? 0 : orError(result);
  }

 private:
  static int orError(int result) { return result == -1 ? -errno : result; }
};

}  // namespace

std::shared_ptr<V4l2Driver> makeSystemV4l2Driver() { return std::make_shared<SystemV4l2Driver>(); }

}  // namespace facenav::capture
