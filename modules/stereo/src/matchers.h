#pragma once
// The two dense matchers, made by makeDenseMatcher.

#include <memory>

#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

std::unique_ptr<DenseMatcher> makeSsdMatcher();
std::unique_ptr<DenseMatcher> makeSgbmMatcher();

}  // namespace facenav::stereo
