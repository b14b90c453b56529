#pragma once
// The support bundle: what helps to find a fault, without images and names, as one ZIP archive of texts.

#include <filesystem>
#include <optional>

#include "facenav/core/zip_file.h"

namespace facenav::app {

struct BundleRequest {
  std::optional<std::filesystem::path> case_folder;
  std::optional<std::filesystem::path> log;  // what a program printed, kept by the user
};

/// Gathers the bundle's files by name. Throws Error: the case's folder or the log does not exist.
ZipEntries supportBundle(const BundleRequest& request);

}  // namespace facenav::app
