#pragma once
// The dense matchers, made by makeDenseMatcher.

#include <memory>

#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

std::unique_ptr<DenseMatcher> makeFieldMatcher();
/// The same on an NVIDIA GPU. Throws Error where none answers or the build has no CUDA.
std::unique_ptr<DenseMatcher> makeCudaFieldMatcher();
bool hasCudaMatcher();
std::unique_ptr<DenseMatcher> makeSsdMatcher();
std::unique_ptr<DenseMatcher> makeSgmMatcher();

}  // namespace facenav::stereo
