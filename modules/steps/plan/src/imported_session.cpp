#include "imported_session.h"

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/sha256.h"
#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/software_version.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/guidance.h"
#include "facenav/plan/plan_edits.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

constexpr const char* kImported = "imported.json";
using Pulses = std::vector<const interop::Item*>;

std::string isoOf(double clock_s) {
  return isoUtc(
      std::chrono::system_clock::time_point(std::chrono::milliseconds(std::llround(clock_s * 1000.0))));
}

/// Seconds that the file's clock is ahead of UTC.
double aheadOf(const OtherImport& order, const ImportPreview& preview) {
  return preview.file.is_clock_utc ? 0.0 : order.utc_offset_h * 3600.0;
}

/// Name of a session's folder, 20260305T102030Z.
std::string folderNameOf(const std::string& iso) {
  std::string name;
  for (const char c : iso.substr(0, 19))
    if (c != '-' && c != ':') name += c;
  return name + "Z";
}

/// The frame Camera of an imported pulse is Mri: no camera saw it.
void setPose(casefile::Pulse& pulse, const RigidTransform<Mri, Coil>& mri_T_coil) {
  pulse.camera_T_mri = RigidTransform<Camera, Mri>();
  pulse.camera_T_coil = *pulse.camera_T_mri * mri_T_coil;
  pulse.status = casefile::PulseStatus::outside;
  pulse.reason = "no target";
  if (!pulse.target) return;
  const Tracked<RigidTransform<Camera, Coil>> coil(*pulse.camera_T_coil, 1.0);
  const Tracked<RigidTransform<Camera, Mri>> head(*pulse.camera_T_mri, 1.0);
  const auto state = guidance::evaluate(*pulse.target, head, coil, guidance::Tolerance{}, 0.0);
  const bool is_on_target = state.state == guidance::State::on_target;
  pulse.status = is_on_target ? casefile::PulseStatus::on_target : casefile::PulseStatus::outside;
  pulse.reason = is_on_target ? "" : "outside the usual tolerance";
  if (!state.values) return;
  pulse.offset =
      casefile::PulseOffset{state.values->distance_mm, state.values->lateral_mm, state.values->depth_mm,
                            state.values->tilt_rad * kDegPerRad, state.values->twist_rad * kDegPerRad};
}

casefile::Pulse pulseOf(const interop::Item& item, int number, double start_s, const OtherImport& order,
                        const ImportPreview& preview, const guidance::TreatmentPlan& plan) {
  casefile::Pulse pulse;
  pulse.number = number;
  pulse.source = preview.file.format + ": " + nameOf(order);
  pulse.reason = item.reason.empty() ? "no pose" : item.reason;
  if (item.clock_s) {
    const double utc_s = *item.clock_s - aheadOf(order, preview);
    pulse.utc = isoOf(utc_s);
    pulse.steady_s = pulse.t_s.emplace(utc_s - start_s);
  } else if (item.onset_s) {
    pulse.steady_s = pulse.t_s.emplace(*item.onset_s);
  }
  if (const auto* target = find(plan, item.target)) {
    pulse.target = *target;
    pulse.target->note.clear();
  }
  if (item.mri_T_coil) setPose(pulse, *item.mri_T_coil);
  pulse.intensity_pct = item.intensity_pct;
  if (item.mep_uv && *item.mep_uv >= 0 && *item.mep_uv <= casefile::kLargestMep_uv)
    pulse.mep_uv = item.mep_uv;
  return pulse;
}

/// A folder for a session that starts then; neither the case has it nor is it one of `taken`.
fs::path freeFolder(const casefile::CaseStore& store, const std::string& first_utc,
                    const std::vector<fs::path>& taken) {
  for (int count = 1;; ++count) {
    const fs::path folder = store.folder() / "sessions" /
                            (folderNameOf(first_utc) + (count == 1 ? "" : "_" + std::to_string(count)));
    if (!fs::exists(folder) && std::find(taken.begin(), taken.end(), folder) == taken.end()) return folder;
  }
}

void writeOrigin(const fs::path& folder, const OtherImport& order, const ImportPreview& preview,
                 const std::string& session, const std::string& sha256) {
  const nlohmann::ordered_json json{{"format", "facenav imported session"},
                                    {"version", 1},
                                    {"file", nameOf(order)},
                                    {"from", preview.file.words},
                                    {"session", session},
                                    {"sha256", sha256},
                                    {"utc_offset_h", order.utc_offset_h},
                                    {"imported_utc", isoUtc(std::chrono::system_clock::now())},
                                    {"software_version", softwareVersion()}};
  writeWholeFile(folder / kImported,
                 json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void writeEvents(const fs::path& folder, const OtherImport& order, const ImportPreview& preview,
                 const std::string& first_utc, const std::string& last_utc) {
  std::string lines;
  const auto add = [&](const std::string& utc, const std::string& event, const std::string& detail) {
    const nlohmann::ordered_json line{{"utc", utc}, {"event", event}, {"detail", detail}};
    lines += line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  };
  add(first_utc, "session started", "");
  add(first_utc, "imported", nameOf(order) + " (" + preview.file.words + ")");
  add(last_utc, "session ended", "");
  writeWholeFile(folder / "events.jsonl", lines);
}

NewSession newSession(const casefile::CaseStore& store, const OtherImport& order,
                      const ImportPreview& preview, const guidance::TreatmentPlan& plan,
                      const std::string& name, const Pulses& pulses, const std::string& sha256,
                      const std::vector<fs::path>& taken) {
  std::optional<double> first_s, last_s;
  for (const auto* pulse : pulses) {
    if (!pulse->clock_s) continue;
    const double utc_s = *pulse->clock_s - aheadOf(order, preview);
    first_s = std::min(first_s.value_or(utc_s), utc_s);
    last_s = std::max(last_s.value_or(utc_s), utc_s);
  }
  const std::string now = isoUtc(std::chrono::system_clock::now());
  const std::string first_utc = first_s ? isoOf(*first_s) : now, last_utc = last_s ? isoOf(*last_s) : now;
  NewSession made;
  made.folder = freeFolder(store, first_utc, taken);
  if (!fs::exists(made.folder.parent_path())) makePrivateFolder(made.folder.parent_path());
  made.whole = std::make_unique<WholeFolder>(made.folder, FileAccess::owner_only);
  const fs::path folder = made.whole->temporaryPath();
  casefile::PulseFile file(folder);
  for (const auto* pulse : pulses)
    file.keep(pulseOf(*pulse, ++made.pulses, first_s.value_or(0), order, preview, plan));
  writeEvents(folder, order, preview, first_utc, last_utc);
  writeOrigin(folder, order, preview, name, sha256);
  return made;
}

/// Hash of the file, or of the files that were read of a folder.
std::string hashOf(const OtherImport& order, const ImportPreview& preview) {
  if (!fs::is_directory(order.file)) return casefile::sha256OfFile(order.file);
  std::string hashes;
  for (const auto& part : preview.file.parts) hashes += casefile::sha256OfFile(part);
  return casefile::sha256OfText(hashes);
}

}  // namespace

std::string nameOf(const OtherImport& order) {
  return fs::absolute(order.file / "").lexically_normal().parent_path().filename().string();
}

std::vector<NewSession> newSessions(const casefile::CaseStore& store, const OtherImport& order,
                                    const ImportPreview& preview, const guidance::TreatmentPlan& plan,
                                    const std::vector<NewSession>& others) {
  std::vector<fs::path> taken;
  for (const auto& other : others) taken.push_back(other.folder);
  std::map<std::string, Pulses> by_session;
  for (const auto& [item, fate, reason] : preview.items)
    if (item.kind == interop::Kind::pulse && fate == ItemFate::added)
      by_session[item.session].push_back(&item);
  std::vector<NewSession> made;
  if (by_session.empty()) return made;
  const std::string sha256 = hashOf(order, preview);
  for (const auto& [name, pulses] : by_session) {
    made.push_back(newSession(store, order, preview, plan, name, pulses, sha256, taken));
    taken.push_back(made.back().folder);
  }
  return made;
}

std::set<std::string> importedSessions(const casefile::CaseStore& store, const OtherImport& order,
                                       const ImportPreview& preview) {
  std::set<std::string> names;
  std::optional<std::string> sha256;
  for (const auto& folder : casefile::sessionFolders(store.folder())) {
    if (!fs::exists(folder / kImported)) continue;
    if (!sha256) sha256 = hashOf(order, preview);
    try {
      const auto origin = JsonReader::readFile(folder / kImported);
      const bool is_same_clock =
          !origin.has("utc_offset_h") || origin.at("utc_offset_h").number() == order.utc_offset_h;
      if (origin.at("sha256").text() == *sha256 && is_same_clock) names.insert(origin.at("session").text());
    } catch (const Error&) {  // a damaged note hides no session
    }
  }
  return names;
}

}  // namespace facenav::steps
