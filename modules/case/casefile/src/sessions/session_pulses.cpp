#include "facenav/casefile/session_pulses.h"

#include <nlohmann/json.hpp>
#include <set>

#include "appended_file.h"
#include "facenav/casefile/pulse_field_file.h"
#include "facenav/core/csv_table.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "facenav/guidance/coil_gap.h"
#include "json_lines.h"
#include "pulse_json.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPulses = "pulses.jsonl";
constexpr const char* kEdits = "pulse_edits.jsonl";
constexpr const char* kOldReason = "noted by an earlier version, without the coil's pose";

SessionPulses readKept(const fs::path& folder) {
  SessionPulses read;
  auto lines = readJsonLines(folder / kPulses);
  read.problems = std::move(lines.problems);
  std::set<int> numbers;
  for (const JsonReader& line : lines.lines) {
    try {
      Pulse pulse = pulseFrom(line);
      if (numbers.insert(pulse.number).second) read.pulses.push_back({std::move(pulse), false, {}});
    } catch (const Error& fault) {
      read.problems.push_back(std::string(fault.what()) + ": the pulse is left out");
    }
  }
  return read;
}

/// Parses "3, on_target, 0.8 mm, 2 deg", the note of a pulse in earlier versions.
Pulse pulseOfEvent(int number, const JsonReader& event) {
  Pulse pulse;
  pulse.number = number;
  const auto seconds = secondsOfUtc(event.at("utc").text());
  if (seconds) {
    const std::chrono::duration<double> since_epoch(*seconds);
    pulse.utc = isoUtc(std::chrono::system_clock::time_point(
        std::chrono::duration_cast<std::chrono::system_clock::duration>(since_epoch)));
  }
  const std::string detail = event.at("detail").text();
  const auto says = [&](const char* word) { return detail.find(word) != std::string::npos; };
  pulse.status = says("on_target") ? PulseStatus::on_target
                 : says("adjust")  ? PulseStatus::outside
                                   : PulseStatus::lost;
  pulse.reason = kOldReason;
  return pulse;
}

SessionPulses readOld(const fs::path& folder) {
  SessionPulses read;
  auto lines = readJsonLines(folder / "events.jsonl");
  read.problems = std::move(lines.problems);
  for (const JsonReader& event : lines.lines)
    if (event.has("event") && event.at("event").text() == "pulse")
      read.pulses.push_back({pulseOfEvent(int(read.pulses.size()) + 1, event), false, {}});
  return read;
}

ReviewedPulse* pulseNumbered(SessionPulses& session, int number) {
  for (auto& reviewed : session.pulses)
    if (reviewed.pulse.number == number) return &reviewed;
  return nullptr;
}

std::optional<double> optionalNumber(const JsonReader& line, const char* key) {
  return line.has(key) ? std::optional(line.at(key).number()) : std::nullopt;
}

void applyEdit(const JsonReader& line, SessionPulses& session) {
  const int number = line.at("pulse").integer();
  ReviewedPulse* reviewed = pulseNumbered(session, number);
  if (!reviewed) return;
  const std::string change = line.at("change").text();
  if (change == "mep") {
    reviewed->pulse.mep_uv = optionalNumber(line, "mep_uv");
    reviewed->pulse.latency_ms = optionalNumber(line, "latency_ms");
    session.edited_meps.insert(number);
  } else if (change == "exclude" || change == "include") {
    reviewed->is_excluded = change == "exclude";
    reviewed->note = reviewed->is_excluded ? line.at("reason").text() : "";
  }  // unknown change, of a later version
}

void applyEdits(const fs::path& folder, SessionPulses& session) {
  auto lines = readJsonLines(folder / kEdits);
  for (auto& problem : lines.problems) session.problems.push_back(std::move(problem));
  for (const JsonReader& line : lines.lines) {
    try {
      applyEdit(line, session);
    } catch (const Error& fault) {
      session.problems.push_back(std::string(fault.what()) + ": the change is left out");
    }
  }
}

ReviewedPulse& find(SessionPulses& session, int number, const fs::path& folder) {
  if (auto* reviewed = pulseNumbered(session, number)) return *reviewed;
  throw Error("there is no pulse " + std::to_string(number), folder.string(),
              session.pulses.empty()
                  ? "the session has no pulses"
                  : "it has pulses " + std::to_string(session.pulses.front().pulse.number) + " to " +
                        std::to_string(session.pulses.back().pulse.number));
}

void requireRange(std::optional<double> value, double most, const char* what, const char* unit, int number,
                  const fs::path& folder) {
  if (!value || (*value >= 0 && *value <= most)) return;  // NaN fails both comparisons
  throw Error(formatted("%s %g %s of pulse %d is not possible", what, *value, unit, number), folder.string(),
              formatted("0 to %g %s is expected", most, unit));
}

std::string textOf(const nlohmann::ordered_json& line) {
  return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void append(const fs::path& folder, const std::string& lines) {
  AppendedFile file(folder / kEdits, "", AppendedFile::Start::old_or_fresh);
  file.append(lines);
  file.sync();
}

std::string field(const std::optional<double>& value, int decimals) {
  return "," + (value ? fixed(*value, decimals) : std::string());
}

std::string poseFields(const Pulse& pulse) {
  const auto mri_T_coil = pulse.mri_T_coil();
  if (!mri_T_coil) return ",,,,,,,";
  std::string fields;
  const Eigen::Vector3d t_mm = mri_T_coil->translation_mm();
  const Eigen::Quaterniond q = mri_T_coil->quaternion();
  for (const double value : {t_mm.x(), t_mm.y(), t_mm.z()}) fields += "," + fixed(value, 4);
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) fields += "," + fixed(value, 9);
  return fields;
}

/// Fills in the computed fields; a value that a pulse's source sent stays.
void addFields(const fs::path& folder, SessionPulses& session) {
  for (auto& [number, field] : readPulseFields(folder)) {
    ReviewedPulse* reviewed = pulseNumbered(session, number);
    if (!reviewed) continue;
    Pulse& pulse = reviewed->pulse;
    if (!pulse.e_target_v_per_m && field.at_target && field.rate_A_per_us)
      pulse.e_target_v_per_m = *field.at_target * *field.rate_A_per_us;
    pulse.field = std::move(field);
  }
}

std::string fieldFields(const std::optional<PulseField>& known) {
  if (!known) return ",,,,,,,,";
  const PulseField& computed = *known;
  std::optional<double> at_rate;
  if (computed.rate_A_per_us) at_rate = computed.peak * *computed.rate_A_per_us;
  std::string fields = field(computed.at_target, 4) + field(at_rate, 2) + "," + fixed(computed.peak, 4);
  for (const double value_mm : computed.peak_place.mm) fields += "," + fixed(value_mm, 1);
  return fields + "," + std::to_string(computed.tier) + "," + csvField(computed.coil);
}

std::string csvLine(const ReviewedPulse& reviewed) {
  const Pulse& pulse = reviewed.pulse;
  std::string line = std::to_string(pulse.number) + field(pulse.t_s, 6) + "," + pulse.utc + "," +
                     csvField(pulse.source) + "," + csvField(pulse.target ? pulse.target->name : "") + "," +
                     toString(pulse.status) + "," + csvField(pulse.reason) + poseFields(pulse);
  if (const auto& offset = pulse.offset)
    for (const double value :
         {offset->distance_mm, offset->lateral_mm, offset->depth_mm, offset->tilt_deg, offset->twist_deg})
      line += "," + fixed(value, 4);
  else
    line += ",,,,,";
  line += field(pulse.gap_mm, 2) + field(pulse.predicted_error_mm, 4) + field(pulse.intensity_pct, 2) +
          field(pulse.e_target_v_per_m, 2) + field(pulse.mep_uv, 2) + field(pulse.latency_ms, 2);
  std::optional<double> lost_pct;
  if (pulse.gap_mm) lost_pct = guidance::fieldLost_pct(*pulse.gap_mm);
  return line + (reviewed.is_excluded ? ",1," : ",0,") + csvField(reviewed.note) + "," +
         csvField(pulse.coil) + field(pulse.gap_stereo_mm, 2) + field(lost_pct, 1) +
         field(pulse.error_bound_mm, 4) + (pulse.is_in_pause ? ",1" : ",0") + fieldFields(pulse.field) + "\n";
}

}  // namespace

SessionPulses readSessionPulses(const fs::path& session_folder) {
  SessionPulses session =
      fs::exists(session_folder / kPulses) ? readKept(session_folder) : readOld(session_folder);
  applyEdits(session_folder, session);
  addFields(session_folder, session);
  return session;
}

void editPulse(const fs::path& session_folder, const PulseEdit& edit) { editPulses(session_folder, {edit}); }

void editPulses(const fs::path& session_folder, const std::vector<PulseEdit>& edits) {
  SessionPulses session = readSessionPulses(session_folder);
  const std::string utc = isoUtc(std::chrono::system_clock::now());
  std::string lines;
  for (const PulseEdit& edit : edits) {
    ReviewedPulse& reviewed = find(session, edit.number, session_folder);
    const std::string pulse = "pulse " + std::to_string(edit.number);
    if (reviewed.is_excluded == edit.is_excluded)
      throw Error(pulse + (edit.is_excluded ? " is already excluded" : " is not excluded"),
                  session_folder.string());
    if (edit.is_excluded && edit.reason.find_first_not_of(" \t\r\n") == std::string::npos)
      throw Error(pulse + " is excluded only with a reason", session_folder.string(), "give --reason");
    reviewed.is_excluded = edit.is_excluded;
    lines += textOf({{"utc", utc},
                     {"pulse", edit.number},
                     {"change", edit.is_excluded ? "exclude" : "include"},
                     {"reason", edit.reason},
                     {"by", edit.by}});
  }
  if (!lines.empty()) append(session_folder, lines);
}

void editMeps(const fs::path& session_folder, const std::vector<MepEdit>& edits) {
  SessionPulses session = readSessionPulses(session_folder);
  const std::string utc = isoUtc(std::chrono::system_clock::now());
  std::string lines;
  for (const MepEdit& edit : edits) {
    find(session, edit.number, session_folder);
    requireRange(edit.mep_uv, kLargestMep_uv, "an MEP of", "uV", edit.number, session_folder);
    requireRange(edit.latency_ms, 1000, "a latency of", "ms", edit.number, session_folder);
    nlohmann::ordered_json line{{"utc", utc}, {"pulse", edit.number}, {"change", "mep"}};
    if (edit.mep_uv) line["mep_uv"] = *edit.mep_uv;
    if (edit.latency_ms) line["latency_ms"] = *edit.latency_ms;
    line["reason"] = edit.reason;
    line["by"] = edit.by;
    lines += textOf(line);
  }
  if (!lines.empty()) append(session_folder, lines);
}

std::string pulsesCsv(const std::vector<ReviewedPulse>& pulses) {
  std::string csv =
      "pulse,t_s,utc,source,target,status,reason,tx,ty,tz,qw,qx,qy,qz,distance_mm,lateral_mm,depth_mm,"
      "tilt_deg,twist_deg,gap_mm,predicted_error_mm,intensity_pct,e_target_v_per_m,mep_uv,latency_ms,"
      "excluded,note,coil,gap_stereo_mm,field_lost_pct,error_bound_mm,in_pause,"
      "e_target_v_per_m_per_a_per_us,e_max_v_per_m,e_max_v_per_m_per_a_per_us,e_max_x_mm,e_max_y_mm,e_max_z_"
      "mm,"
      "field_tier,field_coil\n";
  for (const ReviewedPulse& reviewed : pulses) csv += csvLine(reviewed);
  return csv;
}

}  // namespace facenav::casefile
