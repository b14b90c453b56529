#include "facenav/casefile/case_coil.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

std::filesystem::path coilFileIn(const std::filesystem::path& folder, const std::string& outline) {
  const auto file = folder / "given.json";
  std::ofstream(file) << R"({"name": "round 90", "contact_outline_mm": )" << outline << "}";
  return file;
}

TEST(CaseCoil, IsAFigureOfEightUntilOneIsSet) {
  const testing::TemporaryFolder folder;
  EXPECT_TRUE(coilOf(folder.path()).is_default);
  EXPECT_EQ(coilOf(folder.path()).plate.outline_mm.size(), guidance::figureOfEight().outline_mm.size());
  setCoil(folder.path(), coilFileIn(folder.path(), "[[-45, -45], [45, -45], [45, 45], [-45, 45]]"));
  std::filesystem::remove(folder.path() / "given.json");  // the case has its own copy
  const CaseCoil coil = coilOf(folder.path());
  EXPECT_FALSE(coil.is_default);
  EXPECT_EQ(coil.name, "round 90");
  ASSERT_EQ(coil.plate.outline_mm.size(), 4u);
  EXPECT_EQ(coil.plate.outline_mm[2], Eigen::Vector2d(45, 45));
}

TEST(CaseCoil, ADamagedFileIsRefusedAndTheOldCoilStays) {
  const testing::TemporaryFolder folder;
  setCoil(folder.path(), coilFileIn(folder.path(), "[[-45, -45], [45, -45], [45, 45], [-45, 45]]"));
  const std::string before = readWholeFile(folder.path() / "coil.json");
  EXPECT_THROW(setCoil(folder.path(), coilFileIn(folder.path(), "[[-45, -45], [45, -45]]")), Error);
  EXPECT_THROW(setCoil(folder.path(), folder.path() / "nothing.json"), Error);
  EXPECT_EQ(readWholeFile(folder.path() / "coil.json"), before);
}

}  // namespace
}  // namespace facenav::casefile
