#include "software_commit.h"

namespace facenav::app {

std::string versionInWords() { return std::string(FACENAV_VERSION) + " (commit " + softwareCommit() + ")"; }

}  // namespace facenav::app
