#pragma once
// The dense matchers, made by makeDenseMatcher.

#include <memory>

#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

std::unique_ptr<DenseMatcher> makeFieldMatcher();
/// Makes "field" on an NVIDIA GPU. Throws Error without a device or in a build without CUDA.
std::unique_ptr<DenseMatcher> makeCudaFieldMatcher();
bool hasCudaMatcher();
std::unique_ptr<DenseMatcher> makeSsdMatcher();
std::unique_ptr<DenseMatcher> makeSgmMatcher();

}  // namespace facenav::stereo
