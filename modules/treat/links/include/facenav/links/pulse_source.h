#pragma once
// PulseSource: where pulses come from. Every source passes the contract test in
// testing/support/pulse_source_contract.h. A source only listens: none of them can fire a stimulator.

#include <functional>
#include <memory>
#include <string>

#include "facenav/links/pulse_trigger.h"

namespace facenav::links {

/// Both are called on the source's own thread, and must return at once.
struct PulseListener {
  std::function<void(const PulseTrigger&)> pulse;
  /// What keeps the source from working ("unplugged"), or a message that it could not read, in words. Empty:
  /// it works again.
  std::function<void(const std::string& words)> problem;
};

class PulseSource {
 public:
  /// Stops.
  virtual ~PulseSource() = default;
  /// As the log names it: "udp:5005".
  virtual std::string name() const = 0;
  /// Listens until stop(). Throws Error when the source cannot be opened: a port that is taken, no device.
  virtual void start(PulseListener listener) = 0;
  /// No call follows its return. Safe to call twice.
  virtual void stop() = 0;
};

/// The window's key and button.
class KeyboardSource : public PulseSource {
 public:
  std::string name() const override { return "keyboard"; }
  void start(PulseListener listener) override { listener_ = std::move(listener); }
  void stop() override { listener_ = {}; }
  /// A pulse now; on the caller's thread. Nothing while stopped.
  void press();

 private:
  PulseListener listener_;
};

/// By its words:
///   udp:[ADDRESS:]PORT, tcp:[ADDRESS:]PORT    JSON objects with "pulse": true, one a datagram or line
///   serial:DEVICE[:BAUD]                      each byte is a pulse (9600 baud)
///   serial:DEVICE:cts, serial:DEVICE:dsr      each rising edge of that line
///   lsl[:STREAM]                              each sample of an LSL marker stream (by its name; default:
///   any)
///   sound[:DEVICE]                            each click of the coil on a sound input (ALSA's name of it, as
///   sound:hw:1,0; default: "default"); sound:FILE.wav plays a recorded sound as if it were heard now
/// with ":dead=SECONDS" behind it for another dead time (a pedal on a serial line: 0.15). Without an address
/// a network source listens on all of the machine's. Throws Error for other words.
std::unique_ptr<PulseSource> openPulseSource(const std::string& words);
/// For help texts.
std::string pulseSourceWords();

}  // namespace facenav::links
