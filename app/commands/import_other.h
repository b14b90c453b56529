#pragma once
// `facenav import CASE FILE` where FILE is one of another program: options, preview and report.

#include <CLI/CLI.hpp>

#include "context.h"
#include "facenav/plan/import_other.h"

namespace facenav::app {

struct ImportOtherRequest {
  steps::OtherImport order;
  std::string space, form, y_sign, head_frame;
  bool is_dry_run = false, is_json = false;
};

/// Adds --dry-run, --space and what else only other programs' files need.
void addImportOtherOptions(CLI::App& verb, ImportOtherRequest& request);
/// True for a file that is no archive, a folder, and an archive of another program's session. Throws Error if
/// there is none.
bool isOtherFile(const std::filesystem::path& file);
/// Prints what the file holds and takes it, or only prints. Throws Error as steps::importOther does.
void importOtherFile(const Context& context, const std::filesystem::path& case_folder,
                     ImportOtherRequest request);

}  // namespace facenav::app
