// A fake liblsl.so.2: one marker stream, whose samples the test sends, and outlets, whose samples it keeps.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

namespace {

std::mutex g_mutex;
std::condition_variable g_changed;
struct Sample {
  double stamp_s;
  std::string text;
};
std::deque<Sample> g_samples;
bool g_has_stream = true, g_has_own = false;
int g_own = 0;  // its place stands for the description of FaceNav's own stream
bool g_is_followed = false;
constexpr double kBehind_s = 1000.0;
double g_behind_s = kBehind_s;      // the stream's clock is behind this machine's
double g_correction_s = kBehind_s;  // the correction that is returned
bool g_has_correction = true;

std::vector<Sample> g_pushed;  // by an outlet
std::string g_outlet;  // its name, type, channels, rate, format, source, as "FaceNav|Markers|1|0|3|.."
bool g_is_heard = false;
constexpr double kAhead_s = 500.0;  // LSL's clock is ahead of the steady clock

double local_s() {
  return kAhead_s +
         std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

extern "C" {

/// Sends, for the test, a sample that was made `age_s` ago by the stream's clock.
void fake_lsl_send_text(double age_s, const char* text) {
  const std::lock_guard lock(g_mutex);
  g_samples.push_back({local_s() - g_behind_s - age_s, text});
  g_changed.notify_all();
}
void fake_lsl_send_late(double age_s) { fake_lsl_send_text(age_s, "pulse"); }
void fake_lsl_send() { fake_lsl_send_late(0); }
/// Shows FaceNav's own stream before the other one.
void fake_lsl_show_own(int has_own) { g_has_own = has_own != 0; }
/// Sets whether somebody listens to the outlet.
void fake_lsl_listen(int is_heard) { g_is_heard = is_heard != 0; }
/// How the newest outlet was made; empty: there is none now.
const char* fake_lsl_outlet() {
  const std::lock_guard lock(g_mutex);
  return g_outlet.c_str();
}
/// Number of samples that were pushed, and one of them with its stamp.
int fake_lsl_pushed() {
  const std::lock_guard lock(g_mutex);
  return int(g_pushed.size());
}
double fake_lsl_pushed_at(int index, const char** text) {
  const std::lock_guard lock(g_mutex);
  *text = g_pushed[std::size_t(index)].text.c_str();
  return g_pushed[std::size_t(index)].stamp_s;
}
/// Sets the stream's clock and the result of lsl_time_correction, which fails without `has_correction`.
void fake_lsl_set_clock(double behind_s, double correction_s, int has_correction) {
  const std::lock_guard lock(g_mutex);
  g_behind_s = behind_s, g_correction_s = correction_s, g_has_correction = has_correction != 0;
}
void fake_lsl_reset_clock() { fake_lsl_set_clock(kBehind_s, kBehind_s, 1); }
/// Returns true if an inlet is connected and receives samples.
int fake_lsl_is_followed() {
  const std::lock_guard lock(g_mutex);
  return g_is_followed ? 1 : 0;
}
void fake_lsl_show(int has_stream) { g_has_stream = has_stream != 0; }

double lsl_local_clock() { return local_s(); }
std::int32_t lsl_resolve_byprop(void** infos, std::uint32_t, const char* property, const char* value,
                                std::int32_t least, double) {
  const bool is_type = std::strcmp(property, "type") == 0 && std::strcmp(value, "Markers") == 0;
  std::int32_t found = 0;
  if (g_has_own && is_type) infos[found++] = &g_own;
  const bool is_asked_for = is_type || (std::strcmp(property, "name") == 0 && std::strcmp(value, "tms") == 0);
  if (is_asked_for && g_has_stream && found < least) infos[found++] = &g_samples;  // the first answers count
  return found;
}
const char* lsl_get_source_id(void* info) { return info == &g_own ? "facenav-markers" : "tms-device"; }
void* lsl_create_streaminfo(const char* name, const char* type, std::int32_t channels, double rate_hz,
                            std::int32_t format, const char* source) {
  const std::lock_guard lock(g_mutex);
  g_outlet = std::string(name) + "|" + type + "|" + std::to_string(channels) + "|" +
             std::to_string(int(rate_hz)) + "|" + std::to_string(format) + "|" + source;
  return &g_outlet;
}
void* lsl_get_desc(void* info) { return info; }
void* lsl_append_child_value(void* parent, const char* name, const char* value) {
  const std::lock_guard lock(g_mutex);
  g_outlet += std::string("|") + name + "=" + value;
  return parent;
}
void* lsl_create_outlet(void* info, std::int32_t, std::int32_t) {
  const std::lock_guard lock(g_mutex);
  g_pushed.clear();
  return info;
}
void lsl_destroy_outlet(void*) {
  const std::lock_guard lock(g_mutex);
  g_outlet.clear();
}
std::int32_t lsl_push_sample_strt(void*, const char** texts, double stamp_s) {
  const std::lock_guard lock(g_mutex);
  g_pushed.push_back({stamp_s, texts[0]});
  return 0;
}
std::int32_t lsl_have_consumers(void*) { return g_is_heard ? 1 : 0; }
std::int32_t lsl_get_channel_count(void*) { return 2; }
void lsl_destroy_streaminfo(void*) {}
void* lsl_create_inlet(void* info, std::int32_t, std::int32_t, std::int32_t) {
  const std::lock_guard lock(g_mutex);
  g_samples.clear();  // an inlet receives only later samples
  return info;
}
void lsl_destroy_inlet(void*) {
  const std::lock_guard lock(g_mutex);
  g_is_followed = false;
}
double lsl_time_correction(void*, double, std::int32_t* fault) {
  const std::lock_guard lock(g_mutex);
  *fault = g_has_correction ? 0 : -1;  // as after its time-out
  return g_has_correction ? g_correction_s : 0.0;
}
double lsl_pull_sample_str(void*, char** texts, std::int32_t count, double timeout_s, std::int32_t* fault) {
  std::unique_lock lock(g_mutex);
  g_is_followed = true;
  *fault = 0;
  if (!g_changed.wait_for(lock, std::chrono::duration<double>(timeout_s), [] { return !g_samples.empty(); }))
    return 0;
  for (std::int32_t i = 0; i < count; ++i) texts[i] = ::strdup(i == 0 ? g_samples.front().text.c_str() : "");
  const double stamp = g_samples.front().stamp_s;
  g_samples.pop_front();
  return stamp;
}
void lsl_destroy_string(char* text) { std::free(text); }
}
