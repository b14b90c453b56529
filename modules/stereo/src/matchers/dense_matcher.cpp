#include "facenav/stereo/dense_matcher.h"

#include "facenav/core/error.h"
#include "matchers.h"

namespace facenav::stereo {

std::vector<std::string> denseMatcherNames() {
  std::vector<std::string> names{"field", "ssd", "sgm", "sgbm"};
  if (hasCudaMatcher()) names.push_back("field_cuda");
  return names;
}

std::unique_ptr<DenseMatcher> makeDenseMatcher(const std::string& name) {
  if (name == "field") return makeFieldMatcher();
  if (name == "field_cuda") return makeCudaFieldMatcher();
  if (name == "ssd") return makeSsdMatcher();
  if (name == "sgm") return makeSgmMatcher();
  if (name == "sgbm") return makeSgbmMatcher();
  std::string names;
  for (const std::string& known : denseMatcherNames()) names += (names.empty() ? "" : ", ") + known;
  throw Error("unknown dense matcher '" + name + "'", {}, "choose one of: " + names);
}

}  // namespace facenav::stereo
