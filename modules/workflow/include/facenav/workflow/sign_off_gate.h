#pragma once
// The gate before a sign-off: what is still missing until a named person may take a case's model as seen. The
// window's page and `facenav check --by` ask this one function; casefile/sign_off.h then writes what was
// signed and holds the files to it.

#include <cstddef>
#include <string>
#include <vector>

#include "facenav/casefile/sign_off.h"

namespace facenav::workflow {

/// What a person has stated so far.
struct SignOffClaim {
  std::string by;                       // name or initials of who looked
  bool outlines_seen = false;           // skin and brain on every slice of the montage
  std::vector<bool> findings_seen;      // one for each finding of the case
  bool is_signed_already = false;       // a sign-off of this model holds
  bool has_unsaved_correction = false;  // of the brain: what is shown is not what would be signed
};

enum class SignOffGap { signed_already, unsaved_correction, unseen, no_name };
struct MissingForSignOff {
  SignOffGap gap;
  std::size_t open = 0, all = 0;  // of `unseen`: outlines and findings together
};

/// What is missing, the first to be shown first; empty: may be signed.
std::vector<MissingForSignOff> missingForSignOff(const SignOffClaim& claim);

/// `facenav check --by`: one acknowledgement for all findings; who signs vouches for the outlines. A sign-off
/// that holds may be given again. Throws Error saying what is missing; else as casefile::signOff.
casefile::SignOff signOffChecked(const casefile::CaseStore& store, const casefile::SignOffRequest& request);

}  // namespace facenav::workflow
