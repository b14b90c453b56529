#include "lsl_output.h"

#include <algorithm>

#include "datagram_output.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"

namespace facenav::links {
namespace {

constexpr std::int32_t kKept_s = 360;   // liblsl's default
constexpr double kOldestEvent_s = 1.0;  // an older time comes from a wall clock that was set
constexpr double kIrregular_hz = 0.0;

/// The frame's time on the monotonic clock; now where its wall clock was set meanwhile.
Timestamp steadyOf(std::chrono::system_clock::time_point utc) {
  const Timestamp now = Timestamp::now();
  const double age_s = std::chrono::duration<double>(std::chrono::system_clock::now() - utc).count();
  return {age_s >= 0 && age_s < kOldestEvent_s ? now.s - age_s : now.s};
}

}  // namespace

LslOutput::LslOutput(const std::string& name, const std::string& stream)
    : ThreadedOutput(name), lsl_(LslLibrary::get()), stream_(stream) {
  const double ahead_s = lsl_.ahead_s();
  const auto info =
      lsl_.create_streaminfo(stream.c_str(), "Markers", 1, kIrregular_hz, LslLibrary::kString, kOwnLslSource);
  if (!info) throw Error("LSL made no stream", name, "check liblsl");
  const auto about = lsl_.get_desc(info);
  lsl_.append_child_value(about, "manufacturer", "FaceNav");
  lsl_.append_child_value(about, "monotonic_clock_to_lsl_s", fixed(ahead_s, 6).c_str());
  outlet_ = lsl_.create_outlet(info, 0, kKept_s);
  lsl_.destroy_streaminfo(info);
  if (!outlet_) throw Error("LSL opened no stream", name, "check liblsl and the network");
  logInfo(name + formatted(": LSL's clock is %.6f s ahead of FaceNav's", ahead_s));
  tell();
  start();
}

LslOutput::~LslOutput() {
  stop();
  lsl_.destroy_outlet(outlet_);
}

void LslOutput::work() {
  std::vector<pollfd> nothing;
  waitFor(nothing);
  for (const auto& pulse : takePulses()) push(jsonLine(pulse), pulse.at);
  if (const auto frame = takeFrame()) send(*frame);
  tell();
}

void LslOutput::send(const LiveFrame& frame) {
  if (frame.state == told_state_ && frame.target == told_target_) return;
  told_state_ = frame.state;
  told_target_ = frame.target;
  push(jsonStateLine(frame), steadyOf(frame.utc));
}

void LslOutput::push(std::string text, Timestamp at) {
  if (!text.empty() && text.back() == '\n') text.pop_back();
  const char* sample = text.c_str();
  const bool is_sent = lsl_.push_sample_strt(outlet_, &sample, lsl_.stampOf(at)) == 0;
  count(is_sent, !is_sent, 0);
}

/// Keeps the report's line: who listens, and the clock.
void LslOutput::tell() {
  const std::int32_t listens = lsl_.have_consumers(outlet_);
  if (listens == listens_) return;
  listens_ = listens;
  setReceivers({"stream " + stream_ + (listens ? ", listened to" : ", nobody listens")});
}

}  // namespace facenav::links
