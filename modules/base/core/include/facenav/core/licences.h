#pragma once
// The third-party parts of FaceNav with their licences: libraries that it links, headers that it compiles,
// programs and data that it reads. The table is resources/licences/parts.txt; the build adds the versions of
// the Debian packages.

#include <string>
#include <vector>

namespace facenav {
inline namespace core {

enum class PartUse { linked, linked_in_lab, compiled_in, data, run };

/// Returns "linked", "linked in facenav-lab", "compiled in", "data" or "run".
std::string toString(PartUse use);

struct LicensedPart {
  std::string name;
  std::string licence;           // SPDX expression
  std::string package, version;  // Debian package; version: empty if the build could not ask for it
  std::vector<std::string>
      libraries;  // how the names of its library files begin, "libvtk"; only of linked parts
  PartUse use = PartUse::linked;
};

/// All parts, by name, but optional libraries that this build does not link.
const std::vector<LicensedPart>& licensedParts();
/// Version as its makers count it: "9.1.0" of Debian's "1:9.1.0+really9.1.0+dfsg2-5".
std::string upstreamVersion(const std::string& debian_version);

}  // namespace core
}  // namespace facenav
