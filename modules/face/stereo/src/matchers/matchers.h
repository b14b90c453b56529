#pragma once
// The dense matchers, made by makeDenseMatcher.

#include <memory>

#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

std::unique_ptr<DenseMatcher> makeFieldMatcher();
std::unique_ptr<DenseMatcher> makeSsdMatcher();
std::unique_ptr<DenseMatcher> makeSgmMatcher();

}  // namespace facenav::stereo
