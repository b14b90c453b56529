#pragma once
// The functions of liblsl (Lab Streaming Layer, C interface) that a marker stream needs, loaded at run time.
// The build does not need liblsl.

#include <cstdint>
#include <string>

namespace facenav::links {

struct LslLibrary {
  using Info = void*;
  using Inlet = void*;
  double (*local_clock)();
  std::int32_t (*resolve_byprop)(Info*, std::uint32_t, const char* property, const char* value,
                                 std::int32_t minimum, double timeout_s);
  std::int32_t (*get_channel_count)(Info);
  void (*destroy_streaminfo)(Info);
  Inlet (*create_inlet)(Info, std::int32_t buffer_s, std::int32_t chunk, std::int32_t recover);
  void (*destroy_inlet)(Inlet);
  double (*pull_sample_str)(Inlet, char** texts, std::int32_t count, double timeout_s, std::int32_t* fault);
  double (*time_correction)(Inlet, double timeout_s, std::int32_t* fault);
  void (*destroy_string)(char*);

  /// Loads the library once. Throws Error if it is not installed, or is too old.
  static const LslLibrary& get();
};

}  // namespace facenav::links
