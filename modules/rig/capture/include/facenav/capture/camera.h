#pragma once
// Camera: one camera device, whatever it is connected by (USB, GigE, network stream). Each kind of connection
// is a CameraBackend (camera_backend.h). Two cameras make a FrameSource (camera_pair_source.h). Order of
// calls: configure, start, next .. next, stop; then configure or start again. One thread at a time.

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/timestamp.h"

namespace facenav::capture {

struct CameraIdentity {
  std::string backend;  // "v4l2", "genicam", "dc1394", "stream"
  std::string
      address;  // opens it now: "/dev/video2", "Aravis-Fake-GV01", "http://host/video", a file, a folder
  std::string model;   // "HD Pro Webcam C920"
  std::string serial;  // empty: it has none
  std::string port;    // port that it is plugged into: "1-2.4", "192.168.1.20"; empty: unknown
  std::string
      full_address{};  // address as typed, if it has a password; never shown or written (stream_logins.h)
};

enum class CameraFault {
  missing,        // no such camera
  in_use,         // another program has it
  no_permission,  // this user may not open it
  unplugged,      // it was there and is gone
  hung,           // it is there and gives no picture
  wrong_size,     // it does not give pictures of the wanted size
  no_bandwidth,   // the connection cannot carry its pictures
  ended,          // the file is at its end
  refused,        // anything else that the driver refuses
};

/// An Error of a camera, with its kind.
class CameraError : public Error {
 public:
  CameraError(CameraFault fault, const std::string& what_happened, const std::string& where,
              const std::string& remedy)
      : Error(what_happened, where, remedy), fault_(fault) {}
  CameraFault fault() const { return fault_; }

 private:
  CameraFault fault_;
};

enum class Trigger {
  free_run,  // the camera takes pictures at its own rate
  software,  // Camera::trigger() takes one picture
  hardware,  // an electric pulse takes one picture
};

struct CameraSettings {
  int width_px = 640, height_px = 480;
  double frames_per_s = 30.0;
  std::string format;  // "GREY", "YUYV", "MJPG"; empty: the first of these that is fast enough
  // Locked values; nullopt: locked at the value that the camera has now.
  std::optional<double> exposure_ms, gain, focus, white_balance_k;
  Trigger trigger = Trigger::free_run;
  // True: the camera adjusts itself to find values for this light. Let it run for some seconds, then
  // configure again with false.
  bool is_adjusting = false;
  // Files only. True: pictures come at the pace at which they were taken; false: as fast as they are asked
  // for.
  bool is_paced = true;
};

/// State of one of the camera's own adjustments, which changes the picture under the tracker unless it is
/// locked.
struct ControlState {
  enum class Lock {
    locked,   // automatic adjustment is off, and the camera reads back the wanted value
    absent,   // the camera has no such control
    refused,  // the camera keeps adjusting, or keeps another value
  };
  std::string name, unit;  // "exposure", "ms"
  std::optional<double> wanted, actual;
  Lock lock = Lock::absent;
  std::string words;                 // reason why it is not locked: "the camera stays on automatic"
  std::optional<double> found = {};  // value before it was set; nullopt: not read
};

struct CameraState {
  int width_px = 0, height_px = 0;
  double frames_per_s = 0.0;  // 0: unknown
  std::string format, clock;  // clock: source of the time stamps, as text
  std::vector<ControlState> controls;
  std::vector<std::string> notes;  // other settings that the driver refused or changed
};

struct CameraPicture {
  cv::Mat grey;        // 8-bit, 1 channel, of the configured size; never changed later
  Timestamp captured;  // steady clock, from the driver's time stamp where it has one; strictly increasing
  std::int64_t sequence = 0;  // the driver's picture number; a gap is a dropped picture
};

/// Counts since start().
struct PictureCounts {
  std::int64_t delivered = 0;
  std::int64_t dropped = 0;      // gaps in the driver's numbers
  std::int64_t damaged = 0;      // marked as damaged by the driver, incomplete or undecodable
  std::int64_t repeated = 0;     // repeats of the same picture
  std::int64_t clock_steps = 0;  // jumps of the camera's clock, after which its time stamps were fitted anew
};

class Camera {
 public:
  virtual ~Camera() = default;
  virtual const CameraIdentity& identity() const = 0;
  /// Sets size, rate and format, turns the camera's automatic adjustments off and reads all back. Throws
  /// CameraError: wrong_size if the camera does not give this size, in_use, unplugged. A refused control is
  /// no error: see state.
  virtual CameraState configure(const CameraSettings& settings) = 0;
  /// Starts the pictures. Throws CameraError: in_use, no_bandwidth, unplugged.
  virtual void start() = 0;
  /// State as read back after start(): some cameras forget their settings when they start.
  virtual CameraState state() const = 0;
  /// Waits at most `timeout_s` for the next picture; nullopt if none came. Damaged pictures are left out and
  /// counted. Throws CameraError: unplugged, ended, hung if the pictures of a stream come too late.
  virtual std::optional<CameraPicture> next(double timeout_s) = 0;
  /// Takes one picture (Trigger::software). Throws CameraError if the camera has no such trigger.
  virtual void trigger() = 0;
  virtual void stop() = 0;
  virtual PictureCounts counts() const = 0;
  /// True if the pictures lie in a file or folder: none is missed while nobody asks for it.
  virtual bool isFromFiles() const { return false; }
};

/// Name of a camera: "v4l2:HD Pro Webcam C920#A1B2" with a serial number, "v4l2:USB Camera@1-2" with a port
/// only, else backend and address. It names the same camera after a restart (with a port only: while it stays
/// in that port).
std::string stableName(const CameraIdentity& camera);
/// True if `a` and `b` are the same camera: by serial number, else by model and port, else by address.
bool isSameCamera(const CameraIdentity& a, const CameraIdentity& b);
/// One line: "HD Pro Webcam C920, serial number A1B2 (/dev/video2)".
std::string inWords(const CameraIdentity& camera);
/// Controls that are not locked, one line each: "focus: the camera stays on automatic". Empty if all is
/// locked.
std::vector<std::string> unlockedInWords(const CameraState& state);

}  // namespace facenav::capture
