#pragma once
// Sessions made of another program's pulses.

#include <filesystem>
#include <memory>
#include <vector>

#include "facenav/core/whole_folder.h"
#include "facenav/plan/import_other.h"

namespace facenav::steps {

/// A session folder that is written and not yet visible.
struct NewSession {
  std::filesystem::path folder;
  std::unique_ptr<WholeFolder> whole;
  int pulses = 0;
};

/// Name of the imported file or folder, without the folders above it.
std::string nameOf(const OtherImport& order);

/// Writes a session for each session of the file, under a name that neither the case nor `others` have.
/// Throws Error; nothing is visible before the folders are committed.
std::vector<NewSession> newSessions(const casefile::CaseStore& store, const OtherImport& order,
                                    const ImportPreview& preview, const guidance::TreatmentPlan& plan,
                                    const std::vector<NewSession>& others);
/// Names, as the file has them, of the sessions that were imported before from a file of this content, with
/// this offset of its clock.
std::set<std::string> importedSessions(const casefile::CaseStore& store, const OtherImport& order,
                                       const ImportPreview& preview);

}  // namespace facenav::steps
