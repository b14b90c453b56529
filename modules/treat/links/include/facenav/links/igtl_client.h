#pragma once
// IgtlClient: reads the poses that another program serves by OpenIGTLink (Plus, an optical tracker). It works
// on a thread of its own and connects again after the server was away. A pose that the server calls lost,
// that is no rigid motion, or that is old, is not given.

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>

namespace facenav::links {

/// "igtl://HOST[:PORT]/NAME": a server, and the name of the pose to read there.
struct ServedPose {
  std::string host;
  int port = 18944;
  std::string name;  // "Coil1ToTracker"
};
/// Throws Error for other words.
ServedPose servedPoseFrom(const std::string& words);

class IgtlClient {
 public:
  /// Age at which a pose is lost: six frames of a tracker with 60 Hz.
  static constexpr double kAgeLimit_s = 0.1;

  /// Throws Error if the host is not known. Does not wait for the server.
  IgtlClient(const std::string& host, int port);
  ~IgtlClient();
  IgtlClient(const IgtlClient&) = delete;
  IgtlClient& operator=(const IgtlClient&) = delete;

  /// Newest pose of this name, from TRANSFORM, TDATA or QTDATA; nothing if it is lost or older than
  /// kAgeLimit_s.
  std::optional<Eigen::Isometry3d> pose(const std::string& name) const;
  bool isConnected() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::links
