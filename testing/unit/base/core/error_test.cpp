#include "facenav/core/error.h"

#include <gmock/gmock.h>

#include "facenav/core/task_monitor.h"

namespace facenav {
namespace {

using ::testing::HasSubstr;

TEST(Error, NamesPlaceFaultAndRemedyOnOneLine) {
  const Error error("has no key 'T'", "rig/stereo.yml", "calibrate again");
  EXPECT_STREQ(error.what(), "rig/stereo.yml: has no key 'T'; calibrate again");
}

TEST(Error, IsOneLineWhateverItIsGiven) {
  const Error error("two\nlines", "odd\r\nname\t.dcm", "try\nagain");
  EXPECT_EQ(std::string(error.what()).find_first_of("\n\r\t"), std::string::npos);
}

TEST(Expect, ThrowsWithTheConditionAndItsPlace) {
  try {
    FACENAV_EXPECT(1 + 1 == 3, "sums must be right");
    FAIL();
  } catch (const std::logic_error& bug) {
    EXPECT_THAT(bug.what(), HasSubstr("1 + 1 == 3"));
    EXPECT_THAT(bug.what(), HasSubstr("error_test.cpp"));
  }
}

TEST(TaskMonitor, ReportsProgressAndThrowsOnceCancelled) {
  std::string step;
  double fraction = -1;
  TaskMonitor monitor([&](const std::string& name, double done) { step = name, fraction = done; });
  monitor.report("reading", 0.5);
  EXPECT_EQ(step, "reading");
  EXPECT_EQ(fraction, 0.5);
  monitor.cancel();
  EXPECT_THROW(monitor.report("reading", 0.6), Cancelled);
}

}  // namespace
}  // namespace facenav
