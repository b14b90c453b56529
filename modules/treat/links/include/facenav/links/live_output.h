#pragma once
// LiveOutput: where poses, state and pulses of a running session go while it runs. An output works on a
// thread of its own: publish() hands a frame over and returns at once, whatever the receivers do. An older
// frame that was not sent yet is dropped, never queued. A pose that is lost has no value in any output.

#include <Eigen/Geometry>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/links/live_order.h"
#include "facenav/links/pulse_trigger.h"

namespace facenav::interop {
class InvesaliusSpace;
}

namespace facenav::links {

/// A pose by its name, "CoilToMri": it maps coordinates (mm) in Coil to coordinates in Mri.
struct LivePose {
  std::string name;
  std::optional<Eigen::Isometry3d> pose;  // nothing: lost
  std::string status = "OK";              // a lost pose: "MISSING", "OUT_OF_VIEW", "INVALID"
  std::string coil = {};                  // name of the coil whose pose it is; empty: the head's
};

/// Distance of the coil from its target.
struct LiveGuidance {
  double distance_mm = 0, lateral_mm = 0, depth_mm = 0, tilt_deg = 0, twist_deg = 0;
};

struct LiveFrame {
  std::int64_t number = -1;
  std::chrono::system_clock::time_point utc;  // capture of the frame
  std::vector<LivePose> poses;
  std::string state = "lost";  // "on_target", "adjust", "lost"
  std::string instruction;     // in words
  std::string target;          // name; empty: none
  std::optional<LiveGuidance> guidance;
  std::optional<Eigen::Isometry3d> mri_T_target;  // of the chosen target; nothing: none
  /// Space of the case's image for InVesalius; null: not known.
  std::shared_ptr<const interop::InvesaliusSpace> image;
};
/// Copy in which every pose is lost.
LiveFrame withoutPoses(const LiveFrame& frame, const std::string& status);

/// Makes the content that a receiver asked for: type "IMAGE", "POLYDATA" or "POINT" and a name; nothing if
/// there is none. It is called on a thread of its own and may take seconds.
using LiveContent =
    std::function<std::optional<std::vector<std::uint8_t>>(const std::string& type, const std::string& name)>;

/// State of an output, for people and for tests.
struct LiveReport {
  std::vector<std::string> receivers;  // "127.0.0.1:50112, header 1"
  std::uint64_t sent = 0;              // frames given to a receiver
  std::uint64_t dropped = 0;           // frames that a slow receiver was not given
  std::uint64_t replaced = 0;          // frames overwritten by newer ones before the output took them
  std::size_t most_waiting = 0;        // largest number of bytes that ever waited for one receiver
};

class LiveOutput {
 public:
  /// Stops the output; receivers are told that every pose is lost.
  virtual ~LiveOutput() = default;
  /// Words it was opened with: "igtl:18944".
  virtual std::string name() const = 0;
  /// Hands the frame over. Never waits for a receiver; may be called by any one thread.
  virtual void publish(std::shared_ptr<const LiveFrame> frame) = 0;
  /// Hands a pulse over, from any thread.
  virtual void publish(const PulseTrigger& pulse) = 0;
  virtual LiveReport report() const = 0;
};

/// Opens the output that the words name and starts it:
///   igtl[:[ADDRESS:]PORT]   an OpenIGTLink server (default: 127.0.0.1, port 18944; port 0: any free one)
///   osc:[HOST:]PORT         OSC bundles over UDP (default: to 127.0.0.1)
///   json:[HOST:]PORT        one line of JSON a datagram over UDP (default: to 127.0.0.1)
///   lsl[:STREAM]            an LSL stream of markers, pulses and changes of the state (default: FaceNav)
///   invesalius:[HOST:]PORT[:robot=ADDRESS]  InVesalius's relay (default: on 127.0.0.1); with an address, its
///                           program for robots is asked to connect to the robot there
/// `content` may be empty. `incoming`: what an OpenIGTLink server takes from its clients; by default nothing.
/// Throws Error for other words, or a port that is in use.
std::unique_ptr<LiveOutput> openLiveOutput(const std::string& words, LiveContent content = {},
                                           const LiveIncoming& incoming = {});
/// Throws Error unless openLiveOutput would understand the words.
void requireLiveOutput(const std::string& words);
/// Lists the words, for help texts.
std::string liveOutputWords();
/// Port of an OpenIGTLink server unless another is given.
constexpr int kIgtlPort = 18944;

}  // namespace facenav::links
