#pragma once
// The software bill of materials of FaceNav as SPDX 2.3 in JSON (spdx.github.io/spdx-spec/v2.3), from core's
// table of parts.

#include <string>

namespace facenav::app {

/// Describes FaceNav and each part of licensedParts(). The time of creation is SOURCE_DATE_EPOCH where that
/// is set.
std::string spdxDocument();

}  // namespace facenav::app
