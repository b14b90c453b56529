#include "lsl_library.h"

#include <dlfcn.h>

#include "facenav/core/error.h"

namespace facenav::links {
namespace {

constexpr const char* kFile = "liblsl.so.2";

template <class Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  if (!function) throw Error(std::string("lacks the function ") + name, kFile, "install a newer liblsl");
}

LslLibrary load() {
  void* library = ::dlopen(kFile, RTLD_NOW | RTLD_LOCAL);
  if (!library) throw Error("LSL is not installed", kFile, "install liblsl, or use another source of pulses");
  LslLibrary lsl{};
  find(library, "lsl_local_clock", lsl.local_clock);
  find(library, "lsl_resolve_byprop", lsl.resolve_byprop);
  find(library, "lsl_get_channel_count", lsl.get_channel_count);
  find(library, "lsl_destroy_streaminfo", lsl.destroy_streaminfo);
  find(library, "lsl_create_inlet", lsl.create_inlet);
  find(library, "lsl_destroy_inlet", lsl.destroy_inlet);
  find(library, "lsl_pull_sample_str", lsl.pull_sample_str);
  find(library, "lsl_time_correction", lsl.time_correction);
  find(library, "lsl_destroy_string", lsl.destroy_string);
  return lsl;
}

}  // namespace

const LslLibrary& LslLibrary::get() {
  static const LslLibrary library = load();  // a failed load is tried again at the next call
  return library;
}

}  // namespace facenav::links
