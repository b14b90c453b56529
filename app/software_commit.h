#pragma once
// The git commit that this program was built from; the build writes the source (facenav_commit.cmake).

namespace facenav::app {

/// Short hash of the commit that was checked out when the program was built; "unknown" without git.
const char* softwareCommit();

}  // namespace facenav::app
