#pragma once
// case.json: schema version, id, provenance, findings, and the files the case consists of.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/core/json_reader.h"

namespace facenav::casefile {

constexpr int kSchemaVersion = 1;

struct CaseJson {
  std::string case_id, created_utc;
  std::string label;                         // empty: none, and no key in the file
  std::string modality, orientation_source;  // of the MRI; NIfTI has no place for them
  std::vector<std::string> files;            // that must be there, relative to the case
  std::vector<std::string> findings;
  std::vector<Provenance> provenance;
  std::optional<BrainQuality> brain_quality;
};

/// Throws Error naming file and key; another schema version than ours is refused with the remedy.
CaseJson readCaseJson(const std::filesystem::path& path);
void writeCaseJson(const CaseJson& content, const std::filesystem::path& path);
/// Of what differed from the defaults, by key; of settings that this version does not know, too.
SettingValues readSettings(const JsonReader& json);
/// 16 random hex digits.
std::string makeCaseId();

}  // namespace facenav::casefile
