#include "facenav/stereo/dense_matcher.h"

#include "facenav/core/error.h"
#include "matchers.h"

namespace facenav::stereo {

std::vector<std::string> denseMatcherNames() { return {"ssd", "sgbm"}; }

std::unique_ptr<DenseMatcher> makeDenseMatcher(const std::string& name) {
  if (name == "ssd") return makeSsdMatcher();
  if (name == "sgbm") return makeSgbmMatcher();
  throw Error("unknown dense matcher '" + name + "'", {}, "choose one of: ssd, sgbm");
}

}  // namespace facenav::stereo
