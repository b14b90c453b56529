#pragma once
// FaceNav's version, as written into provenance records.

#include <string>

namespace facenav {
inline namespace core {

std::string softwareVersion();

}  // namespace core
}  // namespace facenav
