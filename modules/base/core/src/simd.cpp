#include "facenav/core/simd.h"

#include <cstdlib>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace {

bool hasAvx2() {
#if defined(FACENAV_HAS_AVX2) && (defined(__x86_64__) || defined(__i386__))
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

std::optional<std::string> wishOfEnvironment() {
  const char* value = std::getenv("FACENAV_SIMD");
  if (!value || !*value) return std::nullopt;
  return value;
}

}  // namespace

InstructionSet instructionSetFor(bool has_avx2, const std::optional<std::string>& wish) {
  if (wish && *wish != "base")
    throw Error("unknown instruction set '" + *wish + "' in FACENAV_SIMD", {}, "set it to base, or unset it");
  return has_avx2 && !wish ? InstructionSet::avx2 : InstructionSet::base;
}

InstructionSet instructionSet() {
  static const InstructionSet set = instructionSetFor(hasAvx2(), wishOfEnvironment());
  return set;
}

}  // namespace core
}  // namespace facenav
