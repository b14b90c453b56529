// The data set of `facenav export --as nibs-bids` as BIDS's own validator judges it (npm
// bids-validator 1.15.0).

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/ball_case.h"
#include "support/ball_targets.h"
#include "support/command_line.h"
#include "support/made_session.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;

/// The validator's path: $FACENAV_BIDS_VALIDATOR, or what the shell finds; empty if it is not installed.
std::string validator() {
  if (const char* path = std::getenv("FACENAV_BIDS_VALIDATOR")) return path;
  const auto found = runProgram("/bin/sh", "-c 'command -v bids-validator'", 20);
  return found.status == 0 ? found.output.substr(0, found.output.find('\n')) : std::string();
}

TEST(BidsValidator, FindsNoErrorInAnExportedCase) {
  if (validator().empty())
    GTEST_SKIP() << "bids-validator is not installed: npm install --global bids-validator@1.15.0";
  const TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", ballWithBrain(), {}, false);
  const auto target = targetOnTop("M1 \"hand\"");
  guidance::TreatmentPlan plan;
  plan.targets = {target};
  store.setTargets(plan);
  writeMadeSession(store.folder(), target, {});
  const auto set = (folder.path() / "set").string();
  const auto exported =
      runFacenav("export '" + store.folder().string() + "' --as nibs-bids -o '" + set + "'");
  ASSERT_EQ(exported.status, 0) << exported.errors;
  const auto judged = runProgram(validator(), "--json '" + set + "'", 120);
  const auto json = nlohmann::json::parse(judged.output);
  EXPECT_TRUE(json["issues"]["errors"].empty()) << json["issues"]["errors"].dump(1);
  EXPECT_EQ(json["summary"]["subjects"].size(), 1u);
}

}  // namespace
}  // namespace facenav::testing
