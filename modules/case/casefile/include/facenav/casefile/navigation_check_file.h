#pragma once
// navigation_check.json of a case: the import check's findings, landmarks (Mri mm) and measures, as prepare
// made them. Older cases have none.

#include <optional>

#include "facenav/casefile/case_store.h"
#include "facenav/surface/navigation_check.h"

namespace facenav::casefile {

/// Writes the whole file, 0600.
void writeNavigationCheck(const surface::NavigationCheck& check, const std::filesystem::path& path);
/// Reads the file. Throws Error naming file and key.
surface::NavigationCheck readNavigationCheck(const std::filesystem::path& path);
/// Reads the case's navigation check; nothing if it has none.
std::optional<surface::NavigationCheck> navigationCheckOf(const CaseStore& store);

}  // namespace facenav::casefile
