#pragma once
// The outline of a case for a support bundle: which files it has, which steps made it, what its sessions went
// through. No images, no poses, no dates, and no word that a person typed.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/scrubbed_words.h"

namespace facenav::app {

/// Adds what may tell who the patient or the staff is, from all JSON below the folder of a case or of the
/// configuration, and the names of the folders on the way there.
void addSecretsBelow(const std::filesystem::path& folder, Scrubber& scrubber);
/// The outline. A damaged or missing file is told in it, and the rest goes on.
nlohmann::ordered_json caseOutline(const std::filesystem::path& case_folder, const Scrubber& scrubber);

}  // namespace facenav::app
