#include <array>
#include <utility>

#include "facenav/core/tracked.h"

namespace facenav {
inline namespace core {
namespace {

constexpr std::array<std::pair<LostReason, const char*>, 6> kWords{
    {{LostReason::no_face, "no_face"},
     {LostReason::few_features, "few_features"},
     {LostReason::no_marker, "no_marker"},
     {LostReason::high_residual, "high_residual"},
     {LostReason::camera, "camera"},
     {LostReason::stale, "stale"}}};

}  // namespace

std::string toString(LostReason reason) {
  for (const auto& [value, word] : kWords)
    if (value == reason) return word;
  FACENAV_EXPECT(false, "unknown LostReason");
}

LostReason lostReasonFromString(const std::string& word) {
  for (const auto& [value, name] : kWords)
    if (word == name) return value;
  throw Error("unknown reason of loss '" + word + "'", {},
              "use no_face, few_features, no_marker, high_residual, camera or stale");
}

}  // namespace core
}  // namespace facenav
