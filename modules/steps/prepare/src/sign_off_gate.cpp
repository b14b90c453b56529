#include "facenav/prepare/sign_off_gate.h"

#include <algorithm>

#include "facenav/core/error.h"

namespace facenav::steps {
namespace {

/// Describes why there is no valid sign-off.
std::string missingWords(const casefile::SignOffStatus& status) {
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

std::vector<MissingForSignOff> missingForSignOff(const SignOffClaim& claim) {
  std::vector<MissingForSignOff> missing;
  if (claim.is_signed_already) missing.push_back({SignOffGap::signed_already});
  if (claim.has_unsaved_correction) missing.push_back({SignOffGap::unsaved_correction});
  const auto open = std::size_t(std::count(claim.findings_seen.begin(), claim.findings_seen.end(), false)) +
                    (claim.outlines_seen ? 0 : 1);
  if (open > 0) missing.push_back({SignOffGap::unseen, open, claim.findings_seen.size() + 1});
  if (claim.by.empty()) missing.push_back({SignOffGap::no_name});
  return missing;
}

casefile::SignOff signOffChecked(const casefile::CaseStore& store, const casefile::SignOffRequest& request) {
  const auto findings = store.findings();
  const SignOffClaim claim{request.by, true,
                           std::vector<bool>(findings.size(), request.acknowledges_findings), false};
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
  return casefile::signOff(store, request);
}

}  // namespace facenav::steps
