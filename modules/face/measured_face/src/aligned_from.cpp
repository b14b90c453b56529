#include "facenav/measured_face/aligned_from.h"

namespace facenav::measured_face {

const char* nameOf(AlignedFrom from) {
  return from == AlignedFrom::dots ? "dots" : from == AlignedFrom::plain ? "plain" : "film";
}

std::optional<AlignedFrom> alignedFrom(const std::string& name) {
  for (const AlignedFrom from : {AlignedFrom::dots, AlignedFrom::plain, AlignedFrom::film})
    if (name == nameOf(from)) return from;
  return std::nullopt;
}

}  // namespace facenav::measured_face
