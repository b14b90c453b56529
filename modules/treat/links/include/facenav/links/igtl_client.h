#pragma once
// IgtlClient: reads the poses that another program serves by OpenIGTLink (Plus, an optical tracker). It works
// on a thread of its own and connects again after the server was away. A pose that the server calls lost,
// that is no rigid motion, or that is old, is not given; the reading says why.

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/timestamp.h"

namespace facenav::links {

/// "igtl://HOST[:PORT]/NAME": a server, and the name of the pose to read there.
struct ServedPose {
  std::string host;
  int port = 18944;
  std::string name;  // "Coil1ToTracker"
};
/// Throws Error for other words.
ServedPose servedPoseFrom(const std::string& words);

/// What a client knows of a tool at one moment.
struct IgtlReading {
  std::optional<Eigen::Isometry3d> pose;  // nothing: lost
  /// Why there is no pose: "is mirrored", "no new message for 0.25 s". Empty with a pose, or if the server
  /// itself says that the tool is not seen.
  std::string fault;
  std::uint64_t stamp = 0;  // the server's time stamp, 32.32 bits; 0: it gives none
  Timestamp arrived;
};

/// Says what is wrong with a matrix that should be a rigid motion: "is mirrored", "is scaled by 0.001",
/// "is sheared". Empty: nothing is.
std::string faultOfPose(const Eigen::Isometry3d& pose);

class IgtlClient {
 public:
  /// Age at which a pose is lost, as in a session: a tracker with 10 Hz may miss one message.
  static constexpr double kAgeLimit_s = 0.25;

  /// Throws Error if the host is not known. Does not wait for the server.
  IgtlClient(const std::string& host, int port);
  ~IgtlClient();
  IgtlClient(const IgtlClient&) = delete;
  IgtlClient& operator=(const IgtlClient&) = delete;

  /// Newest pose of this name, from TRANSFORM, TDATA or QTDATA; nothing if it is lost or older than
  /// kAgeLimit_s. The identity is lost: so trackers write a tool that they do not see.
  std::optional<Eigen::Isometry3d> pose(const std::string& name) const;
  /// Reads several tools, of the newest moment that all of them have by the server's time stamps. Without a
  /// common stamp, each one's newest.
  std::vector<IgtlReading> read(const std::vector<std::string>& names) const;
  bool isConnected() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::links
