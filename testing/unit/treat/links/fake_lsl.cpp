// A fake liblsl.so.2: one marker stream, whose samples the test sends.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <mutex>

namespace {

std::mutex g_mutex;
std::condition_variable g_changed;
std::deque<double> g_samples;
bool g_has_stream = true;
bool g_is_followed = false;
constexpr double kBehind_s = 1000.0;
double g_behind_s = kBehind_s;      // the stream's clock is behind this machine's
double g_correction_s = kBehind_s;  // the correction that is returned
bool g_has_correction = true;

double steady_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

extern "C" {

/// Sends, for the test, a sample that was made `age_s` ago by the stream's clock.
void fake_lsl_send_late(double age_s) {
  const std::lock_guard lock(g_mutex);
  g_samples.push_back(steady_s() - g_behind_s - age_s);
  g_changed.notify_all();
}
void fake_lsl_send() { fake_lsl_send_late(0); }
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

double lsl_local_clock() { return steady_s(); }
std::int32_t lsl_resolve_byprop(void** infos, std::uint32_t, const char* property, const char* value,
                                std::int32_t, double) {
  const bool is_asked_for = (std::strcmp(property, "type") == 0 && std::strcmp(value, "Markers") == 0) ||
                            (std::strcmp(property, "name") == 0 && std::strcmp(value, "tms") == 0);
  infos[0] = &g_samples;
  return is_asked_for && g_has_stream ? 1 : 0;
}
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
  for (std::int32_t i = 0; i < count; ++i) texts[i] = ::strdup("pulse");
  const double stamp = g_samples.front();
  g_samples.pop_front();
  return stamp;
}
void lsl_destroy_string(char* text) { std::free(text); }
}
