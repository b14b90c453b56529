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
  std::string subject;            // label of the person in a data set; empty: subjectOf(store)
  bool has_all_sessions = false;  // the pulses of all sessions also beside chosen targets
};

struct ExportedFile {
  std::filesystem::path path;
  int targets = 0, pulses = 0;
  std::vector<std::string> notes;
};

/// Returns true for a format whose file holds targets or the pulses of one session, never both.
bool holdsOneKind(const std::string& format);

/// Label of a case in a data set, letters and digits: the case's label if it is a code (it has a digit and no
/// blank), else the start of its random id. So a name does not get into the data.
std::string subjectOf(const casefile::CaseStore& store);

/// Writes the file or folder, whole and for the user alone. Only a folder that FaceNav exported is replaced.
/// Throws Error: no such format, target or session, no target, a file that exists, a subject that is no
/// label, or a case without an MRI.
ExportedFile exportOther(const casefile::CaseStore& store, const OtherExport& order);

}  // namespace facenav::steps
