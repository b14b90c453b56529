#pragma once
// The git commit that this program was built from; the build writes the source (facenav_commit.cmake).

#include <string>

namespace facenav::app {

/// Short hash of the commit that was checked out when the program was built; "unknown" without git.
const char* softwareCommit();
/// Formats version and commit: "0.1.0 (commit 1a2b3c4d)".
std::string versionInWords();

}  // namespace facenav::app
