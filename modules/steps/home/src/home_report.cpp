#include <nlohmann/json.hpp>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/sha256.h"
#include "facenav/core/software_version.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/without_folders.h"
#include "facenav/core/zip_file.h"
#include "facenav/home/home_case.h"
#include "facenav/report/session_report.h"
#include "facenav/report/session_review.h"

namespace facenav::steps {
namespace {

using SummaryJson = nlohmann::ordered_json;

SummaryJson summaryOf(const casefile::CaseStore& store, const casefile::KeptSession& session) {
  int on_target = 0, outside = 0, lost = 0;
  for (const auto& reviewed : session.pulses.pulses) {
    if (reviewed.is_excluded) continue;
    on_target += reviewed.pulse.status == casefile::PulseStatus::on_target;
    outside += reviewed.pulse.status == casefile::PulseStatus::outside;
    lost += reviewed.pulse.status == casefile::PulseStatus::lost;
  }
  SummaryJson json{{"format", "facenav session"},
                   {"version", 1},
                   {"case_id", store.caseId()},
                   {"session", session.name},
                   {"software_version", softwareVersion()},
                   {"pulses_on_target", on_target},
                   {"pulses_outside", outside},
                   {"pulses_lost", lost},
                   {"problems", SummaryJson::array()}};
  for (const auto& problem : session.pulses.problems) json["problems"].push_back(withoutFolders(problem));
  if (session.duration_s) json["duration_s"] = *session.duration_s;
  if (session.guided) {
    json["on_target_s"] = session.guided->on_target_s;
    json["adjust_s"] = session.guided->adjust_s;
    json["lost_s"] = session.guided->lost_s;
  }
  return json;
}

}  // namespace

void writeSendBack(const casefile::CaseStore& store, const std::filesystem::path& session_folder,
                   const std::filesystem::path& file) {
  const auto session = casefile::readSession(session_folder);
  std::map<std::string, std::string> entries;
  entries["report.html"] = report::sessionReport(store, session);  // neither name nor pictures
  entries["pulses.csv"] = casefile::pulsesCsv(session.pulses.pulses);
  for (const char* name : {"events.jsonl", "notes.jsonl", "pulses.jsonl", "protocol.json"})
    if (std::filesystem::exists(session_folder / name)) entries[name] = readWholeFile(session_folder / name);
  SummaryJson summary = summaryOf(store, session);
  for (const auto& [name, content] : entries) summary["sha256"][name] = casefile::sha256OfText(content);
  entries["summary.json"] = summary.dump(1, ' ', false, SummaryJson::error_handler_t::replace) + "\n";
  writeZip(entries, file, FileAccess::owner_only);
}

}  // namespace facenav::steps
