#pragma once
// SignOff: a named person's word that a case's model was looked at and may be treated on. It is kept as
// sign_off.json in the case and holds for exactly the files that were seen: a mask edited or a model made
// anew afterwards makes it void, and so does a correction of the brain that is under way. The state of a case
// (prepared, checked, planned) follows from it and from the targets; nothing stores a state apart.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"

namespace facenav::casefile {

enum class CaseState { prepared, checked, planned };
/// "prepared", "checked", "planned".
std::string toString(CaseState state);

struct SignOff {
  std::string by, utc, note;                       // by: staff name or initials, never the patient's
  std::vector<std::string> findings_acknowledged;  // all findings of the case, word for word
  std::optional<double> brain_ml;                  // as shown to `by`
  std::map<std::string, std::string> seen_sha256;  // file name in the case -> hash
};

/// File name in the case -> hash of everything that a sign-off vouches for: masks and surfaces.
std::map<std::string, std::string> seenFiles(const CaseStore& store);

struct SignOffRequest {
  std::string by, note;
  bool acknowledges_findings = false;
  /// seenFiles() of when the case was shown; given, the sign-off is refused where a file changed since.
  std::optional<std::map<std::string, std::string>> shown_sha256 = {};
};

/// Writes sign_off.json (whole, 0600). Throws Error: no name given, findings that were not acknowledged,
/// files that are no longer those shown, or a correction of the brain under way.
SignOff signOff(const CaseStore& store, const SignOffRequest& request);
/// Nothing where there is none, or where it no longer holds. Throws Error for a malformed file.
std::optional<SignOff> validSignOff(const CaseStore& store);
/// The last sign-off and whether it still holds.
struct SignOffStatus {
  std::optional<SignOff> last;       // nothing: the case was never signed off
  std::vector<std::string> changed;  // files that changed, came or went since
  bool has_draft = false;            // a correction of the brain is under way (edited_brain.h)

  bool holds() const { return last.has_value() && changed.empty() && !has_draft; }
};
/// Throws Error for a malformed file.
SignOffStatus signOffStatus(const CaseStore& store);
/// planned needs a valid sign-off and a target; a target alone leaves the case prepared.
CaseState stateOf(const CaseStore& store);
/// A treatment on a case that nobody signed off: kept in case.json with name and reason. Throws Error without
/// either.
void recordOverride(const CaseStore& store, const std::string& by, const std::string& reason,
                    const std::string& software_version);

/// One line of the worklist. `problem` says why a case cannot be read; then the rest is empty.
struct WorklistEntry {
  std::filesystem::path folder;
  std::string case_id, label, created_utc;
  CaseState state = CaseState::prepared;
  std::vector<std::string> findings;
  std::string checked_by, problem;
  std::string stamp;  // sizes and times of the case's files: the same stamp, the same entry
};
/// The cases directly in `folder`, newest first, damaged ones last. Throws Error when the folder cannot be
/// read. An entry of `known` (an earlier list) is taken over where nothing in its folder changed, which saves
/// reading and hashing its files.
std::vector<WorklistEntry> listCases(const std::filesystem::path& folder,
                                     const std::vector<WorklistEntry>& known = {});

}  // namespace facenav::casefile
