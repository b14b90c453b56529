#include "facenav/core/software_version.h"

namespace facenav {
inline namespace core {

std::string softwareVersion() { return FACENAV_VERSION; }

}  // namespace core
}  // namespace facenav
