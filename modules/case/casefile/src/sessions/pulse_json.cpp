#include "pulse_json.h"

#include <nlohmann/json.hpp>

#include "facenav/core/error.h"

namespace facenav::casefile {
namespace {

using Json = nlohmann::ordered_json;

template <class To, class From>
Json matrixOf(const RigidTransform<To, From>& to_T_from) {
  const Eigen::Matrix4d matrix = to_T_from.matrix();
  Json numbers = Json::array();
  for (int i = 0; i < 16; ++i) numbers.push_back(matrix(i / 4, i % 4));
  return numbers;
}

template <class To, class From>
RigidTransform<To, From> transformFrom(const JsonReader& json) {
  const auto numbers = json.numbers(16);
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = numbers[std::size_t(i)];
  try {
    return RigidTransform<To, From>::fromMatrix(matrix);
  } catch (const Error& fault) {
    json.refuse(fault.what());
  }
}

Json pointOf(const Point<Mri>& point) { return {point.mm.x(), point.mm.y(), point.mm.z()}; }
Point<Mri> pointFrom(const JsonReader& json) {
  const auto mm = json.numbers(3);
  return {mm[0], mm[1], mm[2]};
}

/// Visits the optional numbers of a pulse with their names in the file, for writing and reading.
template <class PulseType, class Visitor>
void visitNumbers(PulseType& pulse, Visitor&& visit) {
  visit("gap_mm", pulse.gap_mm);
  visit("predicted_error_mm", pulse.predicted_error_mm);
  visit("intensity_pct", pulse.intensity_pct);
  visit("e_target_v_per_m", pulse.e_target_v_per_m);
  visit("mep_uv", pulse.mep_uv);
  visit("latency_ms", pulse.latency_ms);
  visit("gap_stereo_mm", pulse.gap_stereo_mm);
  visit("error_bound_mm", pulse.error_bound_mm);
}

void addOffset(const PulseOffset& offset, Json& json) {
  json["distance_mm"] = offset.distance_mm;
  json["lateral_mm"] = offset.lateral_mm;
  json["depth_mm"] = offset.depth_mm;
  json["tilt_deg"] = offset.tilt_deg;
  json["twist_deg"] = offset.twist_deg;
}

PulseOffset offsetFrom(const JsonReader& line) {
  return {line.at("distance_mm").number(), line.at("lateral_mm").number(), line.at("depth_mm").number(),
          line.at("tilt_deg").number(), line.at("twist_deg").number()};
}

}  // namespace

nlohmann::ordered_json targetJson(const guidance::Target& target) {
  return {{"name", target.name},
          {"mri_T_target", matrixOf(target.mri_T_target)},
          {"cortex_point_mm", pointOf(target.cortex_point)},
          {"scalp_point_mm", pointOf(target.scalp_point)}};
}

guidance::Target targetFrom(const JsonReader& json) {
  return {json.at("name").text(),
          transformFrom<Mri, frames::Target>(json.at("mri_T_target")),
          pointFrom(json.at("cortex_point_mm")),
          pointFrom(json.at("scalp_point_mm")),
          {}};
}

std::string toString(PulseStatus status) {
  switch (status) {
    case PulseStatus::on_target:
      return "on_target";
    case PulseStatus::outside:
      return "outside";
    case PulseStatus::lost:
      return "lost";
  }
  FACENAV_EXPECT(false, "unknown pulse status");
}

PulseStatus pulseStatusFrom(const std::string& word) {
  for (const PulseStatus status : {PulseStatus::on_target, PulseStatus::outside, PulseStatus::lost})
    if (toString(status) == word) return status;
  throw Error("on_target, outside or lost was expected, not '" + word + "'");
}

std::optional<RigidTransform<Mri, Coil>> Pulse::mri_T_coil() const {
  if (!camera_T_mri || !camera_T_coil) return std::nullopt;
  return camera_T_mri->inverse() * *camera_T_coil;
}

std::string toJsonLine(const Pulse& pulse) {
  Json json;
  json["pulse"] = pulse.number;
  if (pulse.t_s) json["t_s"] = *pulse.t_s;
  json["steady_s"] = pulse.steady_s;
  json["utc"] = pulse.utc;
  json["source"] = pulse.source;
  json["status"] = toString(pulse.status);
  json["reason"] = pulse.reason;
  if (pulse.is_in_pause) json["in_pause"] = 1;
  if (!pulse.coil.empty()) json["coil"] = pulse.coil;
  if (pulse.target) json["target"] = targetJson(*pulse.target);
  if (pulse.camera_T_mri) json["camera_T_mri"] = matrixOf(*pulse.camera_T_mri);
  if (pulse.camera_T_coil) json["camera_T_coil"] = matrixOf(*pulse.camera_T_coil);
  if (pulse.frames) {
    json["frames"] = *pulse.frames;
    json["fraction"] = pulse.fraction;
  }
  if (pulse.offset) addOffset(*pulse.offset, json);
  visitNumbers(pulse, [&](const char* name, const std::optional<double>& value) {
    if (value) json[name] = *value;
  });
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Pulse pulseFrom(const JsonReader& line) {
  Pulse pulse;
  pulse.number = line.at("pulse").integer();
  if (line.has("t_s")) pulse.t_s = line.at("t_s").number();
  pulse.steady_s = line.at("steady_s").number();
  pulse.utc = line.at("utc").text();
  pulse.source = line.at("source").text();
  pulse.status = pulseStatusFrom(line.at("status").text());
  pulse.reason = line.at("reason").text();
  pulse.is_in_pause = line.has("in_pause") && line.at("in_pause").integer() != 0;
  if (line.has("coil")) pulse.coil = line.at("coil").text();
  if (line.has("target")) pulse.target = targetFrom(line.at("target"));
  if (line.has("camera_T_mri")) pulse.camera_T_mri = transformFrom<Camera, Mri>(line.at("camera_T_mri"));
  if (line.has("camera_T_coil")) pulse.camera_T_coil = transformFrom<Camera, Coil>(line.at("camera_T_coil"));
  if (line.has("frames")) {
    const auto frames = line.at("frames").numbers(2);
    pulse.frames = {std::int64_t(frames[0]), std::int64_t(frames[1])};
    pulse.fraction = line.at("fraction").number();
  }
  if (line.has("distance_mm")) pulse.offset = offsetFrom(line);
  visitNumbers(pulse, [&](const char* name, std::optional<double>& value) {
    if (line.has(name)) value = line.at(name).number();
  });
  return pulse;
}

}  // namespace facenav::casefile
