#include "facenav/core/simd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "facenav/core/error.h"

namespace facenav {
namespace {

using ::testing::HasSubstr;

int base() { return 1; }
int avx2() { return 2; }

TEST(Simd, TheFastestSetIsChosenUnlessTheBaseIsAskedFor) {
  EXPECT_EQ(instructionSetFor(true, std::nullopt), InstructionSet::avx2);
  EXPECT_EQ(instructionSetFor(false, std::nullopt), InstructionSet::base);
  EXPECT_EQ(instructionSetFor(true, "base"), InstructionSet::base);
  EXPECT_EQ(instructionSetFor(false, "base"), InstructionSet::base);
}

TEST(Simd, AnUnknownSetIsRefusedByName) {
  try {
    instructionSetFor(true, "sse9");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("'sse9' in FACENAV_SIMD"));
  }
}

TEST(Simd, AKernelIsMadeForTheChosenSetOnly) {
  EXPECT_EQ(chooseKernel(base, avx2), instructionSet() == InstructionSet::avx2 ? 2 : 1);
}

// Runs in a process of its own, since the choice is made once.
TEST(SimdDeathTest, TheEnvironmentForcesTheBaseSet) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        setenv("FACENAV_SIMD", "base", 1);
        std::exit(chooseKernel(base, avx2));
      },
      ::testing::ExitedWithCode(1), "");
}

}  // namespace
}  // namespace facenav
