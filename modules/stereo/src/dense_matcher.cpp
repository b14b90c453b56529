#include "facenav/stereo/dense_matcher.h"

#include "facenav/core/error.h"
#include "matchers.h"

namespace facenav::stereo {

std::vector<std::string> denseMatcherNames() { return {"field", "ssd", "sgm", "sgbm"}; }

std::unique_ptr<DenseMatcher> makeDenseMatcher(const std::string& name) {
  if (name == "field") return makeFieldMatcher();
  if (name == "ssd") return makeSsdMatcher();
  if (name == "sgm") return makeSgmMatcher();
  if (name == "sgbm") return makeSgbmMatcher();
  throw Error("unknown dense matcher '" + name + "'", {}, "choose one of: field, ssd, sgm, sgbm");
}

}  // namespace facenav::stereo
