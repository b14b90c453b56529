// OSC bundles (Open Sound Control 1.0) and lines of JSON.

#include <nlohmann/json.hpp>

#include "big_endian.h"
#include "datagram_output.h"
#include "facenav/core/utc_time.h"
#include "facenav/links/igtl_content.h"

namespace facenav::links {
namespace {

/// Adds a text as OSC has it: ended by a zero, filled up to a multiple of four bytes.
void putOscText(BigEndianWriter& writer, const std::string& text) {
  writer.putText(text, (text.size() / 4 + 1) * 4);
}

/// One message: address, types, and the arguments already written.
class OscMessage {
 public:
  explicit OscMessage(std::string address) : address_(std::move(address)) {}
  OscMessage& operator<<(int value) {
    types_ += 'i';
    arguments_.put(std::uint64_t(std::uint32_t(value)), 4);
    return *this;
  }
  OscMessage& operator<<(double value) {
    types_ += 'f';
    arguments_.putFloat(value);
    return *this;
  }
  OscMessage& operator<<(const std::string& text) {
    types_ += 's';
    putOscText(arguments_, text);
    return *this;
  }
  void addTo(BigEndianWriter& bundle) const {
    BigEndianWriter whole;
    putOscText(whole, address_);
    putOscText(whole, types_);
    whole.bytes.insert(whole.bytes.end(), arguments_.bytes.begin(), arguments_.bytes.end());
    bundle.put(whole.bytes.size(), 4);
    bundle.bytes.insert(bundle.bytes.end(), whole.bytes.begin(), whole.bytes.end());
  }

 private:
  std::string address_, types_ = ",";
  BigEndianWriter arguments_;
};

BigEndianWriter bundleAt(std::chrono::system_clock::time_point utc) {
  constexpr std::uint64_t kSecondsFrom1900To1970 = 2208988800;
  BigEndianWriter bundle;
  putOscText(bundle, "#bundle");
  bundle.put(igtlStamp(utc) + (kSecondsFrom1900To1970 << 32), 8);
  return bundle;
}

std::string textOf(const BigEndianWriter& writer) {
  return {reinterpret_cast<const char*>(writer.bytes.data()), writer.bytes.size()};
}

/// The upper three rows of the pose's matrix, row by row.
nlohmann::json rowsOf(const Eigen::Isometry3d& pose) {
  auto rows = nlohmann::json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) rows.push_back(pose.matrix()(row, column));
  return rows;
}

std::string lineOf(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

nlohmann::json stateOf(const LiveFrame& frame) {
  return {{"frame", frame.number},
          {"utc", isoUtc(frame.utc)},
          {"state", frame.state},
          {"instruction", frame.instruction},
          {"target", frame.target}};
}

}  // namespace

std::string oscBundle(const LiveFrame& frame) {
  auto bundle = bundleAt(frame.utc);
  for (const auto& each : frame.poses) {
    const auto place = placeOf(each.pose.value_or(Eigen::Isometry3d::Identity()));
    OscMessage message("/facenav/pose/" + each.name);
    message << int(each.pose.has_value());
    for (int i = 0; i < 3; ++i) message << place.position_mm[i];
    for (int i = 0; i < 3; ++i) message << place.rotation.vec()[i];
    (message << place.rotation.w()).addTo(bundle);
  }
  (OscMessage("/facenav/state") << frame.state << frame.instruction << frame.target).addTo(bundle);
  if (const auto& g = frame.guidance)
    (OscMessage("/facenav/guidance") << g->distance_mm << g->lateral_mm << g->depth_mm << g->tilt_deg
                                     << g->twist_deg)
        .addTo(bundle);
  return textOf(bundle);
}

std::string oscBundle(const PulseTrigger& pulse) {
  auto bundle = bundleAt(pulse.utc);
  (OscMessage("/facenav/pulse") << pulse.source << pulse.intensity_pct.value_or(-1.0)).addTo(bundle);
  return textOf(bundle);
}

std::string jsonLine(const LiveFrame& frame) {
  nlohmann::json poses = nlohmann::json::object();
  for (const auto& each : frame.poses)
    poses[each.name] = {{"valid", each.pose.has_value()},
                        {"status", each.status},
                        {"rows", each.pose ? rowsOf(*each.pose) : nlohmann::json()}};
  for (const auto& each : frame.poses)
    if (!each.coil.empty()) poses[each.name]["coil"] = each.coil;
  nlohmann::json json = stateOf(frame);
  json["poses"] = poses;
  json["guidance"] = nullptr;
  if (const auto& g = frame.guidance)
    json["guidance"] = {{"distance_mm", g->distance_mm},
                        {"lateral_mm", g->lateral_mm},
                        {"depth_mm", g->depth_mm},
                        {"tilt_deg", g->tilt_deg},
                        {"twist_deg", g->twist_deg}};
  return lineOf(json);
}

std::string jsonStateLine(const LiveFrame& frame) { return lineOf(stateOf(frame)); }

std::string jsonLine(const PulseTrigger& pulse) {
  nlohmann::json json{{"pulse", true}, {"utc", isoUtc(pulse.utc)}, {"source", pulse.source}};
  if (pulse.intensity_pct) json["intensity_pct"] = *pulse.intensity_pct;
  return lineOf(json);
}

}  // namespace facenav::links
