#include "facenav/casefile/pulse_field_file.h"

#include <nlohmann/json.hpp>

#include "appended_file.h"
#include "facenav/core/error.h"
#include "json_lines.h"

namespace facenav::casefile {
namespace {

constexpr const char* kFields = "pulse_fields.jsonl";

std::string lineOf(int pulse, const PulseField& field) {
  nlohmann::ordered_json line{{"pulse", pulse}, {"coil", field.coil}, {"tier", field.tier}};
  if (field.at_target) line["at_target"] = *field.at_target;
  line["maximum"] = field.peak;
  const Eigen::Vector3d& p_mm = field.peak_place.mm;
  line["maximum_place_mm"] = {p_mm.x(), p_mm.y(), p_mm.z()};
  if (field.rate_A_per_us) line["rate_a_per_us"] = *field.rate_A_per_us;
  return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

PulseField fieldFrom(const JsonReader& line) {
  PulseField field;
  field.coil = line.at("coil").text();
  field.tier = line.at("tier").integer();
  if (line.has("at_target")) field.at_target = line.at("at_target").number();
  field.peak = line.at("maximum").number();
  const auto p_mm = line.at("maximum_place_mm").numbers(3);
  field.peak_place = {p_mm[0], p_mm[1], p_mm[2]};
  if (line.has("rate_a_per_us")) field.rate_A_per_us = line.at("rate_a_per_us").number();
  return field;
}

}  // namespace

void keepPulseFields(const std::filesystem::path& session_folder, const std::map<int, PulseField>& fields) {
  std::string lines;
  for (const auto& [pulse, field] : fields) lines += lineOf(pulse, field);
  if (lines.empty()) return;
  AppendedFile file(session_folder / kFields, "", AppendedFile::Start::old_or_fresh);
  file.append(lines);
  file.sync();
}

std::map<int, PulseField> readPulseFields(const std::filesystem::path& session_folder) {
  std::map<int, PulseField> fields;
  for (const JsonReader& line : readJsonLines(session_folder / kFields).lines) {
    try {
      fields[line.at("pulse").integer()] = fieldFrom(line);
    } catch (const Error&) {  // computed anew by 'facenav pulses --field'
    }
  }
  return fields;
}

}  // namespace facenav::casefile
