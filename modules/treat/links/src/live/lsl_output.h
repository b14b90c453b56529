#pragma once
// LslOutput: a marker stream of LSL (type Markers, text, irregular) with each pulse and each change of state
// or target, in the words of the JSON output. No poses. Stamps are LSL's clock at the event's own time.

#include "lsl_library.h"
#include "threaded_output.h"

namespace facenav::links {

class LslOutput : public ThreadedOutput {
 public:
  /// Throws Error if liblsl is not installed, or cannot make the stream.
  LslOutput(const std::string& name, const std::string& stream);
  ~LslOutput() override;

 private:
  void work() override;
  void finish(const LiveFrame& frame) override { send(frame); }
  void send(const LiveFrame& frame);
  void push(std::string text, Timestamp at);
  void tell();

  const LslLibrary& lsl_;
  std::string stream_;
  LslLibrary::Outlet outlet_ = nullptr;
  std::string told_state_, told_target_;
  std::int32_t listens_ = -1;
};

}  // namespace facenav::links
