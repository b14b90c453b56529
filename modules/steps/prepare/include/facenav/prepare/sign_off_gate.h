#pragma once
// The gate before a sign-off: lists what is missing until a named person may sign off a case's model. The
// window's page and `facenav check --by` call the same function. casefile/sign_off.h then writes the sign-off
// and checks the files against it.

#include <cstddef>
#include <string>
#include <vector>

#include "facenav/casefile/sign_off.h"

namespace facenav::steps {

/// Confirmations of a person so far.
struct SignOffClaim {
  std::string by;                       // name or initials of the person
  bool outlines_seen = false;           // skin and brain on every slice of the montage
  std::vector<bool> findings_seen;      // one for each finding of the case
  bool is_signed_already = false;       // there is a valid sign-off of this model
  bool has_unsaved_correction = false;  // the shown brain mask is not the one that would be signed
  bool is_not_usable = false;           // by the import check: signing needs a reason
  std::string reason = {};              // note of the sign-off
};

enum class SignOffGap { signed_already, unsaved_correction, unseen, no_name, no_reason };
struct MissingForSignOff {
  SignOffGap gap;
  std::size_t open = 0, all = 0;  // of `unseen`: outlines and findings together
};

/// True if the import check calls the scan not usable. A case without a check (made by an older version) is
/// not.
bool isNotUsable(const casefile::CaseStore& store);

/// Lists what is missing, in the order to show it; empty: may be signed.
std::vector<MissingForSignOff> missingForSignOff(const SignOffClaim& claim);

/// Signs off for `facenav check --by`: one acknowledgement covers all findings, and the person who signs
/// vouches for the outlines. A valid sign-off may be repeated. A scan that is not usable needs a note. Throws
/// Error that lists what is missing; otherwise as casefile::signOff.
casefile::SignOff signOffChecked(const casefile::CaseStore& store, const casefile::SignOffRequest& request);

/// The gate before a treatment, read from the files as they are now. Throws Error that lists what is missing
/// if the case is neither signed off nor overridden.
void requireSignOff(const casefile::CaseStore& store, bool is_overridden);

}  // namespace facenav::steps
