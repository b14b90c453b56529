// NIfTI files whose maps or units are wrong: the true reason is named.

#include <gmock/gmock.h>
#include <nifti1_io.h>

#include "facenav/core/error.h"
#include "facenav/volume/nifti.h"
#include "raw_nifti.h"
#include "support/test_data.h"
#include "volumes.h"

namespace facenav::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Shears the sform's first axis by 3 degrees; the qform stays.
void shear(Raw& raw) {
  for (float* row : {raw.header.srow_x, raw.header.srow_y, raw.header.srow_z}) row[0] += 0.052f * row[1];
}

std::string niftiFaultOf(const std::filesystem::path& path) {
  try {
    volume::readNifti(path);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(OddNifti, AShearedSformOffersTheQform) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  shear(raw);
  raw.save();
  EXPECT_THAT(niftiFaultOf(path), AllOf(HasSubstr("sform are sheared by"), HasSubstr("take the qform")));
  EXPECT_TRUE(
      volume::readNifti(path, volume::NiftiTransform::qform).volume.grid.matches(numberedVolume().grid));
  raw.header.qform_code = 0;
  raw.save();
  EXPECT_THAT(niftiFaultOf(path), AllOf(HasSubstr("sheared"), Not(HasSubstr("qform"))));
}

/// Multiplies all lengths of the header and writes `units` into it.
void rescale(Raw& raw, float factor, int units) {
  for (int axis = 1; axis <= 3; ++axis) raw.header.pixdim[axis] *= factor;
  for (float* row : {raw.header.srow_x, raw.header.srow_y, raw.header.srow_z})
    for (int c = 0; c < 4; ++c) row[c] *= factor;
  raw.header.qoffset_x *= factor, raw.header.qoffset_y *= factor, raw.header.qoffset_z *= factor;
  raw.header.xyzt_units = char(units);
}

TEST(OddNifti, WrongUnitsAreNamedAsUnits) {
  const struct {
    float factor;
    int units;
    const char* words;
  } kCases[] = {{0.001f, NIFTI_UNITS_UNKNOWN, "names no unit of length, its values look like metres"},
                {1000.f, NIFTI_UNITS_MM, "the unit in its header is mm, its values look like micrometres"},
                {1.f, NIFTI_UNITS_METER, "the unit in its header is metre, its values look like mm"},
                {1.f, NIFTI_UNITS_MICRON, "the unit in its header is micrometre, its values look like mm"}};
  const TemporaryFolder folder;
  for (const auto& each : kCases) {
    const auto path = folder.path() / "a.nii";
    volume::writeNifti(numberedVolume(), path);
    Raw raw(path);
    rescale(raw, each.factor, each.units);
    raw.save();
    EXPECT_THAT(niftiFaultOf(path), HasSubstr(each.words));
  }
}

TEST(OddNifti, Nifti2IsNamed) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  writeWholeFile(path, std::string("\x1C\x02\0\0n+2\0\r\n\x1A\n", 12) + std::string(600, '\0'));
  EXPECT_THAT(niftiFaultOf(path), HasSubstr("is NIfTI-2"));
}

TEST(OddNifti, MapsThatDisagreeAreSaidInMillimetres) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  raw.header.qoffset_x += 5;
  raw.save();
  const auto read = volume::readNifti(path);
  ASSERT_TRUE(read.warning);
  EXPECT_THAT(*read.warning, HasSubstr("disagree by up to 5.0 mm; the sform is used"));
}

}  // namespace
}  // namespace facenav::testing
