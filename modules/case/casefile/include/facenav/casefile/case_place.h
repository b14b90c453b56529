#pragma once
// The place where a case is to be made: may a folder be written there, and has the disk room for it? Asked
// before the work of a minute starts, and again when the case is written.

#include <filesystem>

#include "facenav/volume/volume.h"

namespace facenav::casefile {

/// Throws Error if something lies at `folder` that may not be replaced: no case, or a case without `replace`.
void requireReplaceable(const std::filesystem::path& folder, bool replace);
/// Throws Error if no case can be made at `folder`: requireReplaceable(), or its parent is absent or not
/// writable. Makes a folder there and removes it again.
void requireWritablePlace(const std::filesystem::path& folder, bool replace);
/// Throws Error if the disk is too full for a case of this scan.
void requireSpaceFor(const std::filesystem::path& folder, const volume::Volume& mri);

}  // namespace facenav::casefile
