#pragma once
// DatagramOutput: sends each frame and pulse as one UDP datagram, as an OSC bundle or a line of JSON.

#include "threaded_output.h"

namespace facenav::links {

enum class DatagramFormat { osc, json };

struct PlaceToSend {
  std::string host = "127.0.0.1";
  int port = 0;
};

/// OSC bundle of the frame; its time tag is the frame's time.
std::string oscBundle(const LiveFrame& frame);
std::string oscBundle(const PulseTrigger& pulse);
/// Line of JSON, with its line end.
std::string jsonLine(const LiveFrame& frame);
std::string jsonLine(const PulseTrigger& pulse);
/// The line without poses and guidance: when, state, instruction, target.
std::string jsonStateLine(const LiveFrame& frame);

class DatagramOutput : public ThreadedOutput {
 public:
  /// Throws Error if the host is not known.
  DatagramOutput(const std::string& name, DatagramFormat format, const PlaceToSend& place);
  ~DatagramOutput() override;

 private:
  void work() override;
  void finish(const LiveFrame& frame) override { send(frame); }
  void send(const LiveFrame& frame);
  bool sendText(const std::string& text);

  DatagramFormat format_;
  int socket_ = -1;
};

}  // namespace facenav::links
