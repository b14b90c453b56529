#pragma once
// Names what files without a DICOM image are: an archive to unpack, NIfTI, empty files.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/core/error.h"

namespace facenav::dicom {

/// The error for `files`, none of which is DICOM; `where` was given by the user.
Error noDicomIn(const std::vector<std::filesystem::path>& files, const std::string& where);

}  // namespace facenav::dicom
