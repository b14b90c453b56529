#pragma once
// InvesaliusOutput: sends poses and target to InVesalius's relay, in the part of the navigation, for programs
// of robots and simulations behind it. It is a client: it connects, and connects again. What a robot says is
// kept as lines. It asks the robot's program to connect to a robot only with an address of one.

#include <map>

#include "relay_connection.h"
#include "relay_messages.h"
#include "threaded_output.h"

namespace facenav::links {

struct RelayPlace {
  std::string host = "127.0.0.1";
  int port = 0;
  std::string robot;  // address of the robot to connect to; empty: none is
};

class InvesaliusOutput : public ThreadedOutput {
 public:
  /// Throws Error if the host is not known. Does not wait for the relay.
  InvesaliusOutput(const std::string& name, const RelayPlace& place);
  ~InvesaliusOutput() override;

 private:
  void work() override;
  void finish(const LiveFrame& frame) override;
  void hear();
  void send(const LiveFrame& frame);
  void sendTarget(const LiveFrame& frame);
  bool isDue(const LiveFrame& frame) const;
  void put(const RelayMessage& message);
  void log(const std::string& words);
  void tell();

  RelayPlace place_;
  RelayConnection relay_;
  int greeted_ = 0;  // the relay's joins that have been answered
  bool has_asked_robot_ = false;
  std::optional<Eigen::Isometry3d> sent_target_;  // in Head
  nlohmann::json sent_visible_;
  Timestamp sent_at_{-1e9}, second_began_{-1e9};
  int lines_ = 0;                            // logged in that second
  std::map<std::string, std::string> said_;  // by the robot: the newest line of each topic
  std::string told_;
};

}  // namespace facenav::links
