#pragma once
// FaceNav's version, as written into provenance.

#include <string>

namespace facenav::workflow {

std::string softwareVersion();

}  // namespace facenav::workflow
