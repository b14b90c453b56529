#pragma once
// The readers of single formats, behind readCoilSource.

#include "facenav/efield/coil_source.h"

#include <filesystem>

namespace facenav::efield {

CoilSource readCcd(const std::filesystem::path& path);
CoilSource readTcd(const std::filesystem::path& path);
CoilSource readPotentialNifti(const std::filesystem::path& path);

/// Value of "key=" in a list of pairs "a=1;b=2"; empty if there is none.
std::string pairValue(const std::string& pairs, const std::string& key);

}  // namespace facenav::efield
