#pragma once
// RETURN near home, the way back: imports the file of a session at home (home_case.h, writeSendBack) as a
// session of the clinic's case, marked as one at home. Review, report and lists read it like any other; it
// has no frame-by-frame poses and no pictures.

#include <filesystem>
#include <string>

#include "facenav/casefile/case_store.h"

namespace facenav::steps {

enum class ReturnedOutcome {
  added,      // a new session
  completed,  // the session exists; the file adds later notes
  unchanged   // everything exists already
};
struct ReturnedSession {
  ReturnedOutcome outcome = ReturnedOutcome::added;
  std::filesystem::path folder;  // folder of the session in the case
  int pulses = 0;
};

/// True if the file was made by writeSendBack(). Throws Error if it cannot be read.
bool isReturnedFile(const std::filesystem::path& file);
/// Imports the file. Throws Error: no such file, damaged, of another case, or in conflict with an earlier
/// file of that session; the case is then unchanged.
ReturnedSession importReturned(const casefile::CaseStore& store, const std::filesystem::path& file);
/// Returns "session 20261124T...: 40 pulses, added, at home".
std::string inWords(const ReturnedSession& returned);

}  // namespace facenav::steps
