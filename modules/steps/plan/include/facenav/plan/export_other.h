#pragma once
// PLAN: writes targets, pulses and landmarks of a case as a file for another program (interop).

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/interop/formats.h"

namespace facenav::steps {

struct OtherExport {
  std::string format;                // as in interop::formats()
  std::vector<std::string> targets;  // names; empty: all
  std::string session;               // of the pulses; empty: all sessions where the format holds both
  std::filesystem::path output;      // a file, "-", an existing folder, or empty: the default name here
  bool replaces = false;
  bool has_all_sessions = false;  // the pulses of all sessions also beside chosen targets
};

struct ExportedFile {
  std::filesystem::path path;
  int targets = 0, pulses = 0;
  std::vector<std::string> notes;
};

/// Returns true for a format whose file holds targets or the pulses of one session, never both.
bool holdsOneKind(const std::string& format);
/// Writes the file, whole and for the user alone. Throws Error: no such format, target or session, no target,
/// a file that exists, or a case without an MRI.
ExportedFile exportOther(const casefile::CaseStore& store, const OtherExport& order);

}  // namespace facenav::steps
