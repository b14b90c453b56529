#include "facenav/workflow/software_version.h"

namespace facenav::workflow {

std::string softwareVersion() { return FACENAV_VERSION; }

}  // namespace facenav::workflow
