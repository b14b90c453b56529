#pragma once
// RETURN near home, the way back: the file that a session at home sends (home_case.h, writeSendBack) becomes
// a session of the clinic's case, marked as one at home. Review, report and lists read it like any other; it
// has no poses of each frame and no pictures.

#include <filesystem>
#include <string>

#include "facenav/casefile/case_store.h"

namespace facenav::steps {

enum class ReturnedOutcome {
  added,      // a new session
  completed,  // the session was there already; the file adds what was noted later
  unchanged   // everything was there already
};
struct ReturnedSession {
  ReturnedOutcome outcome = ReturnedOutcome::added;
  std::filesystem::path folder;  // of the session in the case
  int pulses = 0;
};

/// True where the file is one of writeSendBack(); false for other files. Throws Error where it cannot be
/// read.
bool isReturnedFile(const std::filesystem::path& file);
/// Throws Error: no such file, damaged, of another case, or at odds with an earlier file of that session; the
/// case is then unchanged.
ReturnedSession importReturned(const casefile::CaseStore& store, const std::filesystem::path& file);
/// "session 20261124T...: 40 pulses, added, at home".
std::string inWords(const ReturnedSession& returned);

}  // namespace facenav::steps
