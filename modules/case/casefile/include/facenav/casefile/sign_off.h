#pragma once
// SignOff: a named person confirms that they looked at a case's model and that it may be used for treatment.
// It is stored as sign_off.json in the case and valid only for the files that were shown. It becomes void
// when a mask is edited, a model is made again, or a correction of the brain is unfinished. The state of a
// case (prepared, checked, planned) follows from the sign-off and the targets; it is not stored.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"

namespace facenav::casefile {

enum class CaseState { prepared, checked, planned, rejected };
/// Returns "prepared", "checked", "planned" or "rejected".
std::string toString(CaseState state);

struct SignOff {
  std::string by, utc, note;                       // by: staff name or initials, never the patient's
  std::vector<std::string> findings_acknowledged;  // all findings of the case, verbatim
  std::optional<double> brain_ml;                  // as shown to this person
  std::map<std::string, std::string> seen_sha256;  // file name in the case -> hash
};

/// Hashes of all files that a sign-off covers (masks and surfaces), by file name in the case.
std::map<std::string, std::string> seenFiles(const CaseStore& store);

struct SignOffRequest {
  std::string by, note;
  bool acknowledges_findings = false;
  /// Result of seenFiles() when the case was shown. If given, the sign-off is refused where a file has
  /// changed since.
  std::optional<std::map<std::string, std::string>> shown_sha256 = {};
};

/// A person's decision that the scan is not to be used, and that a new one is asked for: rejection.json in
/// the case. A later sign-off takes it back.
struct Rejection {
  std::string by, utc, reason;
};
/// Writes rejection.json (whole, 0600). A sign-off no longer holds. Throws Error without a name or a reason.
Rejection rejectScan(const CaseStore& store, const std::string& by, const std::string& reason);

/// Writes sign_off.json (whole, 0600). Throws Error: no name, findings not acknowledged, files that changed
/// since they were shown, or an unfinished correction of the brain.
SignOff signOff(const CaseStore& store, const SignOffRequest& request);
/// Returns the sign-off; nothing if there is none or it is void. Throws Error for a malformed file.
std::optional<SignOff> validSignOff(const CaseStore& store);
/// The last sign-off and whether it is still valid.
struct SignOffStatus {
  std::optional<SignOff> last;       // nothing: the case was never signed off
  std::vector<std::string> changed;  // files changed, added or removed since
  bool has_draft = false;            // a correction of the brain is unfinished (edited_brain.h)
  std::optional<Rejection> rejection = {};

  bool holds() const { return last.has_value() && changed.empty() && !has_draft && !rejection; }
};
/// Reads the sign-off and compares the files. Throws Error for a malformed file.
SignOffStatus signOffStatus(const CaseStore& store);
/// State of the case. planned needs a valid sign-off and a target; with a target but no sign-off it is only
/// prepared.
CaseState stateOf(const CaseStore& store);
/// Records, in case.json, a treatment on a case without a sign-off, with name and reason. Throws Error if
/// either is missing.
void recordOverride(const CaseStore& store, const std::string& by, const std::string& reason,
                    const std::string& software_version);

/// One line of the worklist. `problem` is why a case cannot be read; the rest is then empty.
struct WorklistEntry {
  std::filesystem::path folder;
  std::string case_id, label, created_utc;
  CaseState state = CaseState::prepared;
  std::vector<std::string> findings;
  std::string checked_by, problem;
  std::string rejection = {};  // who rejected the scan and why
  std::string stamp;           // sizes and times of the case's files: an equal stamp means an equal entry
};
/// Lists the cases directly in `folder`, newest first, damaged ones last. Throws Error when the folder cannot
/// be read. An entry of `known` (an earlier list) is reused if nothing in its folder changed, which saves
/// reading and hashing its files.
std::vector<WorklistEntry> listCases(const std::filesystem::path& folder,
                                     const std::vector<WorklistEntry>& known = {});

}  // namespace facenav::casefile
