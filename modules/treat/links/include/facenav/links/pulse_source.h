#pragma once
// PulseSource: where pulses come from. Every source passes the contract test in
// testing/support/pulse_source_contract.h. A source only listens: none of them can fire a stimulator.

#include <functional>
#include <memory>
#include <string>

#include "facenav/links/pulse_trigger.h"

namespace facenav::links {

/// Callbacks of a source. Both run on the source's own thread and must return at once.
struct PulseListener {
  std::function<void(const PulseTrigger&)> pulse;
  /// Receives the fault that stops the source ("unplugged") or a message that it could not read. Empty: it
  /// works again.
  std::function<void(const std::string& words)> problem;
};

class PulseSource {
 public:
  /// Stops the source.
  virtual ~PulseSource() = default;
  /// Name in the log: "udp:5005".
  virtual std::string name() const = 0;
  /// Listens until stop(). Throws Error when the source cannot be opened: a port in use, no device.
  virtual void start(PulseListener listener) = 0;
  /// Stops listening; no callback runs after its return. Safe to call twice.
  virtual void stop() = 0;
};

/// Source for the window's key and button.
class KeyboardSource : public PulseSource {
 public:
  std::string name() const override { return "keyboard"; }
  void start(PulseListener listener) override { listener_ = std::move(listener); }
  void stop() override { listener_ = {}; }
  /// Adds a pulse that was pressed at that time, on the caller's thread. Does nothing while stopped. `coil`:
  /// as in PulseTrigger.
  void press(Timestamp at = Timestamp::now(), const std::string& coil = {});

 private:
  PulseListener listener_;
};

/// Opens the source that the words name:
///   udp:[ADDRESS:]PORT, tcp:[ADDRESS:]PORT    JSON objects with "pulse": true, one a datagram or line;
///                                             "coil": NAME says which of two coils gave it
///   serial:DEVICE[:BAUD]                      each byte is a pulse (9600 baud)
///   serial:DEVICE:cts, serial:DEVICE:dsr      each rising edge of that line
///   lsl[:STREAM[:MARKER]]                     each sample of an LSL marker stream (default: any stream but
///                                             FaceNav's own), or each one with this text
///   sound[:DEVICE]                            each click of the coil on an ALSA input (sound:hw:1,0;
///                                             default: "default")
///   sound:FILE.wav                            each click of the coil in a file, delivered in real time
/// Add ":dead=SECONDS" for another dead time (a pedal on a serial line: 0.15). Without an address, a network
/// source listens on all addresses of the machine. Throws Error for other words.
std::unique_ptr<PulseSource> openPulseSource(const std::string& words);
/// Lists the words, for help texts.
std::string pulseSourceWords();

}  // namespace facenav::links
