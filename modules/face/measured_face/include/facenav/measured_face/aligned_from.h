#pragma once
// AlignedFrom: which pictures a face was measured on.

#include <optional>
#include <string>

namespace facenav::measured_face {

/// The capture's pair with projected dots, its plain pair, or a film.
enum class AlignedFrom { dots, plain, film };
const char* nameOf(AlignedFrom from);  // "dots", "plain", "film", as in alignment.json
/// Inverse of nameOf(); returns nothing for another name.
std::optional<AlignedFrom> alignedFrom(const std::string& name);

}  // namespace facenav::measured_face
