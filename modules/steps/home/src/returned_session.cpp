#include "facenav/home/returned_session.h"

#include <chrono>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/sha256.h"
#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/number_text.h"
#include "facenav/core/software_version.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/whole_folder.h"
#include "facenav/core/zip_file.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

constexpr const char *kSummary = "summary.json", *kSentFormat = "facenav session";
constexpr int kSentVersion = 1;
constexpr const char* kAskAgain = "ask for the file again";

constexpr const char* kNotes = "notes.jsonl";  // clinic and home both add to it
/// Files of a session that only grow, and those that are replaced whole.
const std::set<std::string> kGrowing{"events.jsonl", "pulses.jsonl"},
    kWhole{"report.html", "protocol.json", kNotes};

struct SentSession {
  std::string name;
  int on_target = 0, outside = 0, lost = 0;
  nlohmann::ordered_json summary;
  ZipEntries files;  // those stored in the session's folder
};

void requireUnchanged(const ZipEntries& entries, const JsonReader& summary, const fs::path& file) {
  if (!summary.has("sha256")) return;  // older files lack it: the archive has its own checksums
  for (const auto& [name, stated] : summary.at("sha256").members()) {
    const auto entry = entries.find(name);
    if (entry == entries.end()) throw Error("'" + name + "' is missing in it", file.string(), kAskAgain);
    if (casefile::sha256OfText(entry->second) != stated.text())
      throw Error("'" + name + "' in it has changed since it was made", file.string(), kAskAgain);
  }
}

SentSession sentSession(const fs::path& file) {
  const auto entries = readZip(file);
  const auto found = entries.find(kSummary);
  if (found == entries.end())
    throw Error("is no session that FaceNav sent back", file.string(),
                "choose the file that was saved at home");
  const JsonReader json = JsonReader::readText(found->second, file);
  if (json.at("format").text() != kSentFormat) json.at("format").refuse("is no session of FaceNav");
  if (json.at("version").integer() != kSentVersion)
    throw Error("the session is of another version of FaceNav", file.string(), "update FaceNav");
  SentSession sent;
  sent.name = json.at("session").text();
  const bool is_plain = sent.name.find_first_of("/\\") == std::string::npos && sent.name.size() < 40;
  if (!is_plain || !secondsOfUtc(sent.name.substr(0, 16)))
    json.at("session").refuse("is no name of a session");
  sent.on_target = json.at("pulses_on_target").integer();
  sent.outside = json.at("pulses_outside").integer();
  sent.lost = json.at("pulses_lost").integer();
  requireUnchanged(entries, json, file);
  for (const char* needed : {"events.jsonl", "pulses.jsonl"})
    if (!entries.count(needed))
      throw Error("'" + std::string(needed) + "' is missing in it", file.string(), kAskAgain);
  for (const auto& [name, content] : entries)
    if (kGrowing.count(name) || kWhole.count(name)) sent.files[name] = content;
  sent.summary = nlohmann::ordered_json::parse(found->second);
  return sent;
}

void requireSameCase(const casefile::CaseStore& store, const SentSession& sent, const fs::path& file) {
  const auto& id = sent.summary.find("case_id");
  if (id != sent.summary.end() && id->is_string() && *id == store.caseId()) return;
  throw Error("is of another case (" +
                  (id != sent.summary.end() && id->is_string() ? id->get<std::string>().substr(0, 60)
                                                               : std::string("none is named")) +
                  "), this one is " + store.caseId(),
              file.string(), "choose that case; nothing was imported");
}

std::string contentOf(const fs::path& file) { return fs::exists(file) ? readWholeFile(file) : std::string(); }

/// Relation of a session in the case to the one that was sent.
enum class Kinship { same, sent_is_longer, sent_is_shorter, other };

Kinship kinshipOf(const fs::path& folder, const SentSession& sent) {
  bool is_longer = false, is_shorter = false;
  for (const auto& name : kGrowing) {
    const auto entry = sent.files.find(name);
    const std::string ours = contentOf(folder / name),
                      theirs = entry == sent.files.end() ? std::string() : entry->second;
    const std::size_t common = std::min(ours.size(), theirs.size());
    if (ours.compare(0, common, theirs, 0, common) != 0) return Kinship::other;
    is_longer |= theirs.size() > ours.size();
    is_shorter |= theirs.size() < ours.size();
  }
  if (is_longer && is_shorter) return Kinship::other;
  return is_longer ? Kinship::sent_is_longer : is_shorter ? Kinship::sent_is_shorter : Kinship::same;
}

/// Merges the lines of both, each once.
std::string joined(const std::string& ours, const std::string& theirs) {
  std::string all = ours;
  if (!all.empty() && all.back() != '\n') all += '\n';
  std::set<std::string> known;
  std::istringstream before(all), after(theirs);
  for (std::string line; std::getline(before, line);) known.insert(line);
  for (std::string line; std::getline(after, line);)
    if (!line.empty() && known.insert(line).second) all += line + "\n";
  return all;
}

std::string notesOf(const SentSession& sent) {
  const auto notes = sent.files.find(kNotes);
  return notes == sent.files.end() ? std::string() : notes->second;
}

void writeSession(const fs::path& folder, const SentSession& sent, const casefile::CaseStore& store) {
  for (const auto& [name, content] : sent.files)
    if (!content.empty() && name != kNotes) writeWholeFile(folder / name, content, FileAccess::owner_only);
  const std::string notes = joined(contentOf(folder / kNotes), notesOf(sent));
  if (!notes.empty()) writeWholeFile(folder / kNotes, notes, FileAccess::owner_only);
  nlohmann::ordered_json returned{{"format", "facenav returned session"},
                                  {"version", 1},
                                  {"case_id", store.caseId()},
                                  {"session", sent.name},
                                  {"imported_utc", isoUtc(std::chrono::system_clock::now())},
                                  {"software_version", softwareVersion()}};
  for (const char* key : {"duration_s", "on_target_s", "adjust_s", "lost_s"})
    if (const auto value = sent.summary.find(key); value != sent.summary.end() && value->is_number())
      returned[key] = *value;
  writeWholeFile(folder / casefile::kReturnedFile, returned.dump(1) + "\n", FileAccess::owner_only);
}

/// Throws Error unless the files have the summary's counts; also used after writing.
int requireCounts(const fs::path& folder, const SentSession& sent, const fs::path& file) {
  int on_target = 0, outside = 0, lost = 0, all = 0;
  for (const auto& [pulse, is_excluded, note] : casefile::readSessionPulses(folder).pulses) {
    ++all;
    on_target += pulse.status == casefile::PulseStatus::on_target;
    outside += pulse.status == casefile::PulseStatus::outside;
    lost += pulse.status == casefile::PulseStatus::lost;
  }
  const bool is_less = on_target < sent.on_target || outside < sent.outside || lost < sent.lost;
  if (!is_less) return all;  // the summary lacks pulses that were excluded at home
  throw Error(
      formatted("holds %d pulses, its summary says %d", all, sent.on_target + sent.outside + sent.lost),
      file.string(), kAskAgain);
}

void addSession(const fs::path& folder, const SentSession& sent, const casefile::CaseStore& store,
                const fs::path& file, ReturnedSession& returned) {
  const bool has_made_sessions = !fs::exists(folder.parent_path());
  if (has_made_sessions) makePrivateFolder(folder.parent_path());
  try {
    WholeFolder fresh(folder, FileAccess::owner_only);
    writeSession(fresh.temporaryPath(), sent, store);
    returned.pulses = requireCounts(fresh.temporaryPath(), sent, file);
    fresh.commit();
  } catch (...) {
    std::error_code ignored;
    if (has_made_sessions) fs::remove(folder.parent_path(), ignored);  // only if it is empty
    throw;
  }
}

/// Replaces the whole folder at once, so that it is never a mixture.
void completeSession(const fs::path& folder, const SentSession& sent, const casefile::CaseStore& store,
                     const fs::path& file, ReturnedSession& returned) {
  WholeFolder fresh(folder, FileAccess::owner_only, Existing::replace);
  fs::copy(folder, fresh.temporaryPath(), fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  writeSession(fresh.temporaryPath(), sent, store);
  returned.pulses = requireCounts(fresh.temporaryPath(), sent, file);
  fresh.commit();
}

}  // namespace

bool isReturnedFile(const fs::path& file) {
  if (readWholeFile(file).rfind("PK", 0) != 0) return false;
  return readZip(file).count(kSummary) == 1;
}

ReturnedSession importReturned(const casefile::CaseStore& store, const fs::path& file) {
  const auto sent = sentSession(file);
  requireSameCase(store, sent, file);
  const fs::path sessions = store.folder() / "sessions";
  ReturnedSession returned;
  for (int count = 1;; ++count) {  // the clinic may have a session of the same second
    const fs::path folder = sessions / (count == 1 ? sent.name : sent.name + formatted("_home%d", count));
    returned.folder = folder;
    if (!fs::exists(folder)) {
      addSession(folder, sent, store, file, returned);
      return returned;
    }
    const bool has_returned = fs::exists(folder / casefile::kReturnedFile);
    const Kinship kinship = kinshipOf(folder, sent);
    const std::string notes = contentOf(folder / kNotes);
    const bool has_news =
        kinship == Kinship::sent_is_longer || (has_returned && joined(notes, notesOf(sent)) != notes);
    if (!has_news && (kinship == Kinship::same || (kinship == Kinship::sent_is_shorter && has_returned))) {
      returned.outcome = ReturnedOutcome::unchanged;
      returned.pulses = int(casefile::readSessionPulses(folder).pulses.size());
      return returned;
    }
    if (has_returned && (kinship == Kinship::same || kinship == Kinship::sent_is_longer)) {
      returned.outcome = ReturnedOutcome::completed;
      completeSession(folder, sent, store, file, returned);
      return returned;
    }
    if (has_returned)
      throw Error("is at odds with an earlier file of the session " + sent.name, file.string(),
                  "keep both files and ask where they come from; nothing was imported");
  }
}

std::string inWords(const ReturnedSession& returned) {
  const std::string what = returned.outcome == ReturnedOutcome::added ? "added to the case"
                           : returned.outcome == ReturnedOutcome::completed
                               ? "was here already; what was noted later is added"
                               : "was here already, nothing changed";
  return "session " + returned.folder.filename().string() +
         formatted(" (at home), %d pulses: ", returned.pulses) + what;
}

}  // namespace facenav::steps
