#pragma once
// Chooses the SIMD instructions of the kernels. A kernel is one file of plain loops or intrinsics, compiled
// for the platform's base set (x_kernel_base.cpp) and for AVX2 with FMA (x_kernel_avx2.cpp); CMake's
// facenav_add_kernel gives both files their flags, and chooseKernel takes one of them here, once. Trap: an
// inline function that an AVX2 file includes may be emitted with AVX2 and then linked into the whole program.
// Kernel headers therefore hold plain data and raw pointers, and only the base file includes this one.

#include <optional>
#include <string>

namespace facenav {
inline namespace core {

enum class InstructionSet { base, avx2 };

/// Instruction set for a processor and a request: "base", or nullopt for the fastest. Throws Error for
/// another request.
InstructionSet instructionSetFor(bool has_avx2, const std::optional<std::string>& wish);

/// AVX2 where compiler and processor have it together with FMA. Decided at the first call and kept. The
/// environment variable FACENAV_SIMD=base forces the base set. Throws Error for another value.
InstructionSet instructionSet();

/// Calls the maker for this processor: `base()` or `avx2()`. To pay for the choice once, keep the result:
/// `static const Kernel& chosen = chooseKernel(baseKernel, avx2Kernel);`
template <class Kernel>
Kernel chooseKernel(Kernel (*base)(), Kernel (*avx2)()) {
  return instructionSet() == InstructionSet::avx2 ? avx2() : base();
}

}  // namespace core
}  // namespace facenav
