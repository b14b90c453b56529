#include "facenav/prepare/sign_off_gate.h"

#include <algorithm>

#include "facenav/casefile/navigation_check_file.h"
#include "facenav/core/error.h"

namespace facenav::steps {
namespace {

/// Describes why there is no valid sign-off.
std::string missingWords(const casefile::SignOffStatus& status) {
  if (status.rejection)
    return "the scan was rejected by " + status.rejection->by + ": " + status.rejection->reason;
  const std::string not_saved = "a correction of the brain is not saved";
  if (!status.last) return status.has_draft ? not_saved : "nobody has signed it off";
  std::string why = status.has_draft ? not_saved : "";
  if (!status.has_draft)
    for (const auto& name : status.changed) why += (why.empty() ? "" : ", ") + name;
  return "sign-off of " + status.last->by + " void: " + why + (status.has_draft ? "" : " changed");
}

}  // namespace

void requireSignOff(const casefile::CaseStore& store, bool is_overridden) {
  if (is_overridden) return;
  const auto status = casefile::signOffStatus(store);
  if (status.holds()) return;
  throw Error("the case is not signed off", missingWords(status), "have it checked (Prepare, step 4)");
}

bool isNotUsable(const casefile::CaseStore& store) {
  const auto check = casefile::navigationCheckOf(store);
  return check && check->verdict() == surface::Verdict::not_usable;
}

std::vector<MissingForSignOff> missingForSignOff(const SignOffClaim& claim) {
  std::vector<MissingForSignOff> missing;
  if (claim.is_signed_already) missing.push_back({SignOffGap::signed_already});
  if (claim.has_unsaved_correction) missing.push_back({SignOffGap::unsaved_correction});
  const auto open = std::size_t(std::count(claim.findings_seen.begin(), claim.findings_seen.end(), false)) +
                    (claim.outlines_seen ? 0 : 1);
  if (open > 0) missing.push_back({SignOffGap::unseen, open, claim.findings_seen.size() + 1});
  if (claim.by.empty()) missing.push_back({SignOffGap::no_name});
  if (claim.is_not_usable && claim.reason.empty()) missing.push_back({SignOffGap::no_reason});
  return missing;
}

casefile::SignOff signOffChecked(const casefile::CaseStore& store, const casefile::SignOffRequest& request) {
  const auto findings = store.findings();
  const SignOffClaim claim{
      request.by,  true,  std::vector<bool>(findings.size(), request.acknowledges_findings),
      false,       false, isNotUsable(store),
      request.note};
  const auto missing = missingForSignOff(claim);
  const auto find = [&](SignOffGap gap) {
    return std::find_if(missing.begin(), missing.end(), [&](const auto& m) { return m.gap == gap; });
  };
  if (find(SignOffGap::no_name) != missing.end())
    throw Error("no name given: say who checked the case", {}, "give a name or initials with --by");
  if (const auto unseen = find(SignOffGap::unseen); unseen != missing.end())
    throw Error(
        std::to_string(unseen->open) + " finding(s) are not acknowledged, the first: " + findings.front(), {},
        "look at each, then acknowledge them");
  if (find(SignOffGap::no_reason) != missing.end())
    throw Error("the import check calls this scan not usable: say why it is signed off all the same", {},
                "give the reason with --note, or reject the scan with --reject");
  return casefile::signOff(store, request);
}

}  // namespace facenav::steps
