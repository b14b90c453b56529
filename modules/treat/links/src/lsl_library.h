#pragma once
// The functions of liblsl (Lab Streaming Layer, C interface) that marker streams need, loaded at run time.
// The build does not need liblsl. The environment variable FACENAV_LSL names another file of the library.

#include <cstdint>
#include <string>

#include "facenav/core/timestamp.h"

namespace facenav::links {

struct LslLibrary {
  using Info = void*;
  using Inlet = void*;
  using Outlet = void*;
  using Description = void*;
  static constexpr std::int32_t kString = 3;  // liblsl's number of the sample format "text"

  double (*local_clock)();
  std::int32_t (*resolve_byprop)(Info*, std::uint32_t, const char* property, const char* value,
                                 std::int32_t minimum, double timeout_s);
  const char* (*get_source_id)(Info);
  std::int32_t (*get_channel_count)(Info);
  void (*destroy_streaminfo)(Info);
  Inlet (*create_inlet)(Info, std::int32_t buffer_s, std::int32_t chunk, std::int32_t recover);
  void (*destroy_inlet)(Inlet);
  double (*pull_sample_str)(Inlet, char** texts, std::int32_t count, double timeout_s, std::int32_t* fault);
  double (*time_correction)(Inlet, double timeout_s, std::int32_t* fault);
  void (*destroy_string)(char*);

  Info (*create_streaminfo)(const char* name, const char* type, std::int32_t channels, double rate_hz,
                            std::int32_t format, const char* source_id);
  Description (*get_desc)(Info);
  Description (*append_child_value)(Description, const char* name, const char* value);
  Outlet (*create_outlet)(Info, std::int32_t chunk, std::int32_t buffer_s);
  void (*destroy_outlet)(Outlet);
  std::int32_t (*push_sample_strt)(Outlet, const char** texts, double stamp_s);
  std::int32_t (*have_consumers)(Outlet);

  /// Loads the library once. Throws Error if it is not installed, or is too old.
  static const LslLibrary& get();
  /// What LSL's clock is ahead of this program's monotonic clock, s; read several times, the quickest reading
  /// counts.
  double ahead_s() const;
  /// Time on LSL's clock of a time on this program's monotonic clock.
  double stampOf(Timestamp at) const { return at.s + ahead_s(); }
};

/// Source id of FaceNav's own marker stream. No FaceNav takes pulses from it: each pulse would come back.
constexpr const char* kOwnLslSource = "facenav-markers";

}  // namespace facenav::links
