#pragma once
// `facenav import CASE FIELD --target NAME`: an electric field of another program (plan/imported_field.h).

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "context.h"
#include "facenav/plan/imported_field.h"

namespace facenav::app {

struct ImportFieldRequest {
  steps::FieldImport order;
  bool is_dry_run = false, is_json = false;
};

/// Adds --target, --didt and --surface.
void addImportFieldOptions(CLI::App& verb, ImportFieldRequest& request);
/// Takes the field, or with is_dry_run only says what it is. Throws Error as steps::importField does.
void importFieldFile(const Context& context, const std::filesystem::path& case_folder,
                     const ImportFieldRequest& request);

/// An imported field in words, one fact a line, each line with its end.
std::string inLines(const steps::ImportedField& field);
nlohmann::ordered_json importedJson(const steps::ImportedField& field);

}  // namespace facenav::app
