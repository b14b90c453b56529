#include "lsl_library.h"

#include <dlfcn.h>

#include <cstdlib>

#include "facenav/core/error.h"

namespace facenav::links {
namespace {

constexpr const char* kFiles[] = {"liblsl.so.2", "liblsl.so", "liblsl64.so"};
constexpr int kReadings = 5;

/// Opens the library; its file is returned in `file`.
void* openLibrary(std::string& file) {
  const char* named = std::getenv("FACENAV_LSL");
  if (named && *named) {
    file = named;
    return ::dlopen(named, RTLD_NOW | RTLD_LOCAL);
  }
  for (const char* each : kFiles) {
    file = each;
    if (void* library = ::dlopen(each, RTLD_NOW | RTLD_LOCAL)) return library;
  }
  file = kFiles[0];
  return nullptr;
}

struct Finder {
  void* library;
  std::string file;

  template <class Function>
  void operator()(const char* name, Function& function) const {
    function = reinterpret_cast<Function>(::dlsym(library, name));
    if (!function) throw Error(std::string("lacks the function ") + name, file, "install a newer liblsl");
  }
};

LslLibrary load() {
  Finder find{nullptr, {}};
  find.library = openLibrary(find.file);
  if (!find.library)
    throw Error("LSL is not installed", find.file,
                "get the liblsl package of labstreaminglayer.org, or name its file in FACENAV_LSL");
  LslLibrary lsl{};
  find("lsl_local_clock", lsl.local_clock);
  find("lsl_resolve_byprop", lsl.resolve_byprop);
  find("lsl_get_source_id", lsl.get_source_id);
  find("lsl_get_channel_count", lsl.get_channel_count);
  find("lsl_destroy_streaminfo", lsl.destroy_streaminfo);
  find("lsl_create_inlet", lsl.create_inlet);
  find("lsl_destroy_inlet", lsl.destroy_inlet);
  find("lsl_pull_sample_str", lsl.pull_sample_str);
  find("lsl_time_correction", lsl.time_correction);
  find("lsl_destroy_string", lsl.destroy_string);
  find("lsl_create_streaminfo", lsl.create_streaminfo);
  find("lsl_get_desc", lsl.get_desc);
  find("lsl_append_child_value", lsl.append_child_value);
  find("lsl_create_outlet", lsl.create_outlet);
  find("lsl_destroy_outlet", lsl.destroy_outlet);
  find("lsl_push_sample_strt", lsl.push_sample_strt);
  find("lsl_have_consumers", lsl.have_consumers);
  return lsl;
}

}  // namespace

const LslLibrary& LslLibrary::get() {
  static const LslLibrary library = load();  // a failed load is tried again at the next call
  return library;
}

double LslLibrary::ahead_s() const {
  double ahead = 0, quickest = 1e9;
  for (int i = 0; i < kReadings; ++i) {
    const Timestamp before = Timestamp::now();
    const double theirs = local_clock();
    const Timestamp after = Timestamp::now();
    if (after - before >= quickest) continue;
    quickest = after - before;
    ahead = theirs - 0.5 * (before.s + after.s);
  }
  return ahead;
}

}  // namespace facenav::links
