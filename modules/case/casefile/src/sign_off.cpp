#include "facenav/casefile/sign_off.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "facenav/casefile/edited_brain.h"
#include "facenav/casefile/sha256.h"
#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/plain_words.h"
#include "facenav/core/whole_file.h"
#include "utc_now.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr char kSignOffFile[] = "sign_off.json", kRejectionFile[] = "rejection.json";

void requireWillingness(const SignOffRequest& request, const std::vector<std::string>& findings) {
  if (request.by.empty())
    throw Error("no name given: say who checked the case", {}, "give a name or initials");
  requireName(request.by, "the name of who checked it");
  requireNote(request.note, "the note");
  if (findings.empty() || request.acknowledges_findings) return;
  throw Error(
      std::to_string(findings.size()) + " finding(s) are not acknowledged, the first: " + findings.front(),
      {}, "look at each, then acknowledge them");
}

void requireUnchanged(const SignOffRequest& request, const std::map<std::string, std::string>& now) {
  if (!request.shown_sha256 || *request.shown_sha256 == now) return;
  throw Error("the case's files changed since they were shown", {},
              "open the case again and check it once more");
}

SignOff readSignOff(const fs::path& path) {
  const JsonReader json = JsonReader::readFile(path);
  SignOff sign_off;
  sign_off.by = json.at("by").text();
  sign_off.utc = json.at("utc").text();
  if (json.has("note")) sign_off.note = json.at("note").text();
  if (json.has("brain_ml")) sign_off.brain_ml = json.at("brain_ml").number();
  for (const auto& finding : json.at("findings_acknowledged").elements())
    sign_off.findings_acknowledged.push_back(finding.text());
  for (const auto& [name, hash] : json.at("seen_sha256").members()) sign_off.seen_sha256[name] = hash.text();
  return sign_off;
}

void write(const SignOff& sign_off, const fs::path& path) {
  nlohmann::ordered_json json;
  json["by"] = sign_off.by;
  json["utc"] = sign_off.utc;
  json["note"] = sign_off.note;
  if (sign_off.brain_ml) json["brain_ml"] = *sign_off.brain_ml;
  json["findings_acknowledged"] = sign_off.findings_acknowledged;
  json["seen_sha256"] = sign_off.seen_sha256;
  writeWholeFile(path, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
}

CaseState stateOf(const CaseStore& store, const SignOffStatus& status) {
  if (status.rejection) return CaseState::rejected;
  if (!status.holds()) return CaseState::prepared;
  return store.targets().targets.empty() ? CaseState::checked : CaseState::planned;
}

std::vector<std::string> differences(const std::map<std::string, std::string>& then,
                                     const std::map<std::string, std::string>& now) {
  std::vector<std::string> names;
  for (const auto& [name, hash] : then)
    if (const auto found = now.find(name); found == now.end() || found->second != hash) names.push_back(name);
  for (const auto& [name, hash] : now)
    if (!then.count(name)) names.push_back(name);
  return names;
}

/// Stamp of all files directly in the case. A file that vanishes meanwhile changes the stamp, as it should.
std::string stampOf(const fs::path& folder) {
  std::map<std::string, std::string> files;
  std::error_code fault;
  for (fs::directory_iterator item(folder, fault), end; !fault && item != end; item.increment(fault)) {
    std::error_code absent;
    files[item->path().filename().string()] =
        std::to_string(fs::is_directory(item->path(), absent) ? 0 : fs::file_size(item->path(), absent)) +
        "@" + std::to_string(fs::last_write_time(item->path(), absent).time_since_epoch().count());
  }
  std::string stamp;
  for (const auto& [name, text] : files) stamp += name + ":" + text + ";";
  return stamp;
}

WorklistEntry entryOf(const fs::path& folder, const std::vector<WorklistEntry>& known) {
  WorklistEntry entry;
  entry.folder = folder;
  entry.stamp = stampOf(folder);
  for (const auto& earlier : known)
    if (earlier.folder == folder && earlier.stamp == entry.stamp) return earlier;
  const std::string stamp = entry.stamp;
  try {
    const auto store = CaseStore::open(folder);
    entry.case_id = store.caseId();
    entry.label = store.label();
    entry.created_utc = store.createdUtc();
    entry.findings = store.findings();
    const auto status = signOffStatus(store);
    if (status.holds()) entry.checked_by = status.last->by;
    if (status.rejection) entry.rejection = status.rejection->by + ": " + status.rejection->reason;
    entry.state = stateOf(store, status);
  } catch (const Error& error) {
    entry = {};
    entry.folder = folder;
    entry.stamp = stamp;
    entry.problem = error.what();
  }
  return entry;
}

}  // namespace

std::string toString(CaseState state) {
  switch (state) {
    case CaseState::prepared:
      return "prepared";
    case CaseState::checked:
      return "checked";
    case CaseState::planned:
      return "planned";
    case CaseState::rejected:
      return "rejected";
  }
  return {};
}

/// Hashes of what a person looks at: the outlines of the masks and the surfaces made from them.
std::map<std::string, std::string> seenFiles(const CaseStore& store) {
  std::map<std::string, std::string> seen;
  for (const char* name : {"head_mask.nii.gz", "brain_mask.nii.gz", "scalp.vtp", "brain.vtp"})
    if (fs::exists(store.folder() / name)) seen[name] = sha256OfFile(store.folder() / name);
  return seen;
}

SignOff signOff(const CaseStore& store, const SignOffRequest& request) {
  const auto findings = store.findings();
  requireWillingness(request, findings);
  if (hasBrainDraft(store))
    throw Error("a correction of the brain is not saved", store.folder().string(),
                "save or discard it first (window: Prepare, step 3)");
  SignOff sign_off{request.by, utcNow(), request.note, findings, std::nullopt, seenFiles(store)};
  requireUnchanged(request, sign_off.seen_sha256);
  if (const auto brain = store.brainMask()) sign_off.brain_ml = brain->volume_ml();
  write(sign_off, store.folder() / kSignOffFile);
  fs::remove(store.folder() / kRejectionFile);  // after the sign-off: a crash between leaves it rejected
  return sign_off;
}

Rejection rejectScan(const CaseStore& store, const std::string& by, const std::string& reason) {
  if (by.empty()) throw Error("no name given: say who rejects the scan", {}, "give a name or initials");
  if (reason.empty())
    throw Error("no reason given: say why the scan is rejected", {}, "give it in a few words");
  requireName(by, "the name of who rejects");
  requireNote(reason, "the reason");
  const Rejection rejection{by, utcNow(), reason};
  const nlohmann::ordered_json json{{"by", by}, {"utc", rejection.utc}, {"reason", reason}};
  writeWholeFile(store.folder() / kRejectionFile,
                 json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
  return rejection;
}

SignOffStatus signOffStatus(const CaseStore& store) {
  SignOffStatus status;
  status.has_draft = hasBrainDraft(store);
  if (const fs::path rejected = store.folder() / kRejectionFile; fs::exists(rejected)) {
    const JsonReader json = JsonReader::readFile(rejected);
    status.rejection = Rejection{json.at("by").text(), json.at("utc").text(), json.at("reason").text()};
  }
  const fs::path path = store.folder() / kSignOffFile;
  if (!fs::exists(path)) return status;
  status.last = readSignOff(path);
  status.changed = differences(status.last->seen_sha256, seenFiles(store));
  return status;
}

std::optional<SignOff> validSignOff(const CaseStore& store) {
  const auto status = signOffStatus(store);
  return status.holds() ? status.last : std::nullopt;
}

CaseState stateOf(const CaseStore& store) { return stateOf(store, signOffStatus(store)); }

void recordOverride(const CaseStore& store, const std::string& by, const std::string& reason,
                    const std::string& software_version) {
  if (by.empty() || reason.empty())
    throw Error("an override needs a name and a reason", {}, "give both, or have the case checked");
  requireName(by, "the name of who overrides");
  requireNote(reason, "the reason");
  store.addProvenance(
      {"override", software_version, {{"by", by}, {"reason", reason}, {"utc", utcNow()}}, {}});
}

std::vector<WorklistEntry> listCases(const fs::path& folder, const std::vector<WorklistEntry>& known) {
  std::error_code fault;
  fs::directory_iterator content(folder, fault);
  if (fault)
    throw Error("the folder of cases cannot be read (" + fault.message() + ")", folder.string(),
                "check the path");
  std::vector<WorklistEntry> entries;
  for (const auto& item : content)
    if (fs::is_regular_file(item.path() / "case.json", fault)) entries.push_back(entryOf(item.path(), known));
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    if (a.problem.empty() != b.problem.empty()) return a.problem.empty();
    return a.created_utc != b.created_utc ? a.created_utc > b.created_utc : a.folder < b.folder;
  });
  return entries;
}

}  // namespace facenav::casefile
