#include "facenav/core/data_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace facenav {
namespace {

TEST(DataFolder, LiesBesideTheFolderOfTheProgram) {
  EXPECT_EQ(programPath().filename(), "base_test");
  EXPECT_EQ(dataFolder(), programPath().parent_path().parent_path() / "share" / "facenav");
  EXPECT_TRUE(std::filesystem::exists(dataFolder() / "brain_prior" / "weights.fnbp")) << dataFolder();
}

TEST(DataFolder, IsTheOneThatTheEnvironmentNames) {
  ASSERT_EQ(setenv("FACENAV_DATA", "/elsewhere", 1), 0);
  EXPECT_EQ(dataFolder(), "/elsewhere");
  ASSERT_EQ(unsetenv("FACENAV_DATA"), 0);
}

}  // namespace
}  // namespace facenav
