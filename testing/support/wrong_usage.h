#pragma once
// Expects that the command line tool refuses words as wrong usage.

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "support/command_line.h"

namespace facenav::testing {

/// Expects status 2 and one line that names the problem.
inline void expectWrongUsage(const std::string& words, const std::string& named) {
  const auto result = runFacenav(words);
  EXPECT_EQ(result.status, 2) << words << ": " << result.errors;
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1)
      << words << ": " << result.errors;
  EXPECT_THAT(result.errors, ::testing::HasSubstr(named)) << words;
}

}  // namespace facenav::testing
