#pragma once
// case.json: schema version, id, provenance, findings, and the files that make up the case.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/core/json_reader.h"

namespace facenav::casefile {

constexpr int kSchemaVersion = 1;

struct CaseJson {
  std::string case_id, created_utc;
  std::string label;                         // empty: none; the key is then left out
  std::string modality, orientation_source;  // of the MRI; NIfTI cannot store them
  std::vector<std::string> files;            // files that must exist, relative to the case
  std::vector<std::string> findings;
  std::vector<Provenance> provenance;
  std::optional<BrainQuality> brain_quality;
};

/// Throws Error if this case.json is of a newer schema version, before anything is done to its case. A file
/// that cannot be read passes.
void requireNotNewer(const std::filesystem::path& path);
/// Reads case.json. Throws Error naming file and key, or, for another schema version, what to do.
CaseJson readCaseJson(const std::filesystem::path& path);
void writeCaseJson(const CaseJson& content, const std::filesystem::path& path);
/// Reads the settings that differ from the defaults, by key, including those that this version does not know.
SettingValues readSettings(const JsonReader& json);
/// Makes an id of 16 random hex digits.
std::string makeCaseId();

}  // namespace facenav::casefile
