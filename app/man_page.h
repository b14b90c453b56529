#pragma once
// Man pages, made from the same description as --help.

#include <CLI/CLI.hpp>
#include <filesystem>

namespace facenav::app {

/// Writes facenav.1 and a page for each verb below it, facenav-prepare.1, into a folder, which is made where
/// absent. Returns the number of pages. Throws Error.
int writeManPages(const CLI::App& program, const std::filesystem::path& folder);

}  // namespace facenav::app
