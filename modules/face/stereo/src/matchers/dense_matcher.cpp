#include "facenav/stereo/dense_matcher.h"

#include "facenav/core/error.h"
#include "matchers.h"

namespace facenav::stereo {

std::vector<std::string> denseMatcherNames() { return {kDefaultMatcher, "ssd", "sgm"}; }

std::string denseMatcherList() {
  std::string list;
  for (const std::string& name : denseMatcherNames()) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::unique_ptr<DenseMatcher> makeDenseMatcher(const std::string& name) {
  if (name == kDefaultMatcher) return makeFieldMatcher();
  if (name == "ssd") return makeSsdMatcher();
  if (name == "sgm") return makeSgmMatcher();
  throw Error("unknown dense matcher '" + name + "'", {}, "choose one of: " + denseMatcherList());
}

}  // namespace facenav::stereo
