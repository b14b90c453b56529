#pragma once
// The sources that openPulseSource() chooses from.

#include <memory>
#include <optional>
#include <string>

#include "facenav/links/pulse_source.h"

namespace facenav::links {

struct NetworkAddress {
  bool is_tcp = false;
  std::string host = "0.0.0.0";
  int port = 0;
};
std::unique_ptr<PulseSource> makeNetworkSource(const std::string& name, const NetworkAddress& address,
                                               double dead_time_s);

enum class SerialSignal { byte, cts, dsr };
struct SerialPort {
  std::string device;
  int baud = 9600;
  SerialSignal signal = SerialSignal::byte;
};
std::unique_ptr<PulseSource> makeSerialSource(const std::string& name, const SerialPort& port,
                                              double dead_time_s);

struct LslMarkers {
  std::string stream;  // its name; empty: any stream of markers
  std::string marker;  // the marker that is a pulse; empty: each one
};
/// Source for an LSL stream. Throws Error if liblsl is not installed.
std::unique_ptr<PulseSource> makeLslSource(const std::string& name, const LslMarkers& markers,
                                           double dead_time_s);

/// Source for a sound; `input`: an ALSA device or a sound file. Throws Error if FaceNav was built without its
/// library.
std::unique_ptr<PulseSource> makeSoundSource(const std::string& name, const std::string& input,
                                             double dead_time_s);

}  // namespace facenav::links
