// Files of coils that differ from the usual ones: one coil in two formats, other systems' lines, two maps.

#include <gmock/gmock.h>
#include <zlib.h>

#include <fstream>

#include "facenav/efield/built_in_coils.h"
#include "facenav/efield/coil_file.h"
#include "facenav/efield/thinned_coil.h"
#include "unit/target/efield/made_coil_files.h"

namespace facenav::efield {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class OddCoilFileTest : public CoilFiles {};

TEST_F(OddCoilFileTest, OneCoilAsDipolesAndAsACompressedGridAgrees) {
  const auto by_dipoles = fieldCoil(write("d70.ccd", ccdOf(figureEight70())).string());
  const auto content = niftiOf(sampled(figureEight70(), 3));
  const auto path = folder_.path() / "d70.nii.gz";
  gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_EQ(gzwrite(file, content.data(), unsigned(content.size())), int(content.size()));
  gzclose(file);
  const auto by_grid = fieldCoil(path.string());
  EXPECT_LT(relativeErrorInSphere(by_grid.dipoles, by_dipoles.dipoles), 0.01);
  EXPECT_EQ(by_grid.dipoles.largest_didt_A_per_us, by_dipoles.dipoles.largest_didt_A_per_us);
  EXPECT_TRUE(by_grid.notes.empty());
}

TEST_F(OddCoilFileTest, OddCcdFilesAreReadOrRefusedInOneLine) {
  const std::string rows = "0.04 0 -0.01 0 0 -0.03\n-0.04 0 -0.01 0 0 0.03\n";
  const auto dipolesIn = [&](const std::string& content) {
    return readCoilSource(write("odd.ccd", content)).dipoles.positions_mm.cols();
  };
  EXPECT_EQ(dipolesIn("\xef\xbb\xbf# coil\n2\n# rows\n" + rows), 2) << "byte order mark";
  EXPECT_EQ(dipolesIn("# coil\r2\r# rows\r0.04 0 -0.01 0 0 -0.03\r-0.04 0 -0.01 0 0 0.03\r"), 2) << "CR";
  EXPECT_EQ(dipolesIn("# a\n# b\n# c\n2\n#x y z\n# mx\n" + rows + "# end\n"), 2) << "more comments";
  EXPECT_EQ(dipolesIn(rows), 2) << "rows alone";
  EXPECT_THAT(refusal("comma.ccd", "# c\r\n1\r\n# d\r\n0,04 0 0 0 0 1\r\n"),
              AllOf(HasSubstr("'0,04' is no number"), HasSubstr("line 4")));
  EXPECT_THAT(refusal("unit.ccd", "# c\n1\n# d\n0.04m 0 0 0 0 1\n"), HasSubstr("'0.04m' is no number"));
  EXPECT_THAT(refusal("late.ccd", "# c\n1\n# d\n0 0 0 0 0 1 # first\n"), HasSubstr("line 4"));
}

TEST_F(OddCoilFileTest, AGridWithTwoMapsSaysWhichOneIsUsed) {
  const auto grid = sampled(figureEight70(), 5);
  auto content = niftiOf(grid);
  const auto put = [&](std::size_t at, auto value) { std::memcpy(&content[at], &value, sizeof value); };
  put(252, short(1));  // a qform without turn
  put(268, -140.f), put(272, -100.f), put(276, -10.f);
  EXPECT_TRUE(readCoilSource(write("same.nii", content)).notes.empty());
  put(276, -15.f);
  const auto source = readCoilSource(write("two.nii", content));
  EXPECT_THAT(source.notes, ::testing::ElementsAre(HasSubstr("differ by up to 5.0 mm: the sform is used")));
  EXPECT_EQ(source.grids[0].coil_from_voxel.translation().z(), -10);
}

}  // namespace
}  // namespace facenav::efield
