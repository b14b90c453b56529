#pragma once
// LiveOutputs: the outputs of a session (OpenIGTLink, OSC, JSON, LSL, InVesalius), opened and closed by their
// words at any time. It outlives sessions, so that clients stay connected between them. All functions are
// thread-safe.

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "facenav/links/live_output.h"
#include "facenav/session/navigation_state.h"

namespace facenav::steps {

class LiveOutputs {
 public:
  /// Opens an output by its words. `incoming`: what an OpenIGTLink server takes from its clients. Throws
  /// Error if it cannot be opened, or is open already.
  void open(const std::string& words, const links::LiveIncoming& incoming = {});
  /// Closes the output of these words, or all; receivers are told that every pose is lost.
  void close(const std::string& words);
  void close();
  bool isEmpty() const;
  /// Words of the open outputs.
  std::vector<std::string> names() const;
  /// One line each: "igtl: 127.0.0.1:50112, header 1".
  std::vector<std::string> receivers() const;
  std::vector<links::LiveReport> reports() const;

  /// Sets the case whose MRI, surfaces and targets receivers may ask for; empty: none.
  void setCase(const std::filesystem::path& folder);
  /// Hands a state, or a pulse, to every output. Returns at once.
  void publish(const session::NavigationState& state);
  void publish(const links::PulseTrigger& pulse);

 private:
  using Outputs = std::vector<std::shared_ptr<links::LiveOutput>>;
  std::optional<std::vector<std::uint8_t>> content(const std::string& type, const std::string& name) const;

  mutable std::mutex mutex_;
  std::filesystem::path case_folder_;
  std::shared_ptr<const interop::InvesaliusSpace> image_;  // of the case's MRI
  Outputs outputs_;  // last: until they end, their threads may ask for content of the case
};

/// Content that a receiver asked for, from the case: IMAGE "MRI", POLYDATA "Scalp" or "Cortex", POINT
/// "Targets" (the points on the cortex). Nothing for other names, or what the case does not have. An empty
/// name is the first of its type. Throws Error if the case cannot be read.
std::optional<std::vector<std::uint8_t>> caseContent(const std::filesystem::path& folder,
                                                     const std::string& type, const std::string& name);

}  // namespace facenav::steps
