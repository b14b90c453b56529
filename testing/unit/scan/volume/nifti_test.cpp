#include "facenav/volume/nifti.h"

#include <gmock/gmock.h>
#include <nifti1.h>
#include <nifti1_io.h>
#include <sys/stat.h>

#include <cstring>
#include <fstream>
#include <functional>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/nifti_forms.h"
#include "raw_nifti.h"
#include "support/matchers.h"
#include "support/nibabel.h"
#include "support/test_data.h"
#include "volumes.h"

namespace facenav::testing {
namespace {

TEST(Nifti, RoundTripKeepsValuesAndPlaces) {
  const TemporaryFolder folder;
  for (const char* name : {"a.nii", "a.nii.gz"}) {
    volume::writeNifti(numberedVolume(), folder.path() / name);
    const auto read = volume::readNifti(folder.path() / name);
    EXPECT_EQ(read.volume.voxels, numberedVolume().voxels);
    EXPECT_TRUE(read.volume.grid.matches(numberedVolume().grid));
    EXPECT_EQ(read.volume.orientation_source, "sform");
    EXPECT_FALSE(read.warning) << *read.warning;
  }
}

/// Other programs read an exported mask at the same positions, by sform and by qform.
TEST(Nifti, NibabelReadsMasksBackAtTheSamePlaces) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "mask.nii.gz";
  volume::Mask mask{numberedVolume().grid, std::vector<std::uint8_t>(5 * 6 * 7, 0)};
  const Eigen::Vector3i marked[] = {{0, 2, 5}, {4, 0, 1}};
  for (const auto& v : marked) mask.voxels[mask.grid.index(v[0], v[1], v[2])] = 1;
  volume::writeMask(mask, path);
  const auto places = pointsByNibabel(path,
                                      "import numpy\n"
                                      "voxels = numpy.asarray(image.dataobj)\n"
                                      "assert set(numpy.unique(voxels)) == {0, 1}\n"
                                      "for affine in image.get_sform(), image.get_qform():\n"
                                      "  for v in numpy.argwhere(voxels):\n"
                                      "    print(*nibabel.affines.apply_affine(affine, v))\n");
  ASSERT_EQ(places.size(), 4u);
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_LT((places[i] - mask.grid.toMri(marked[i % 2].cast<double>()).mm).norm(), 1e-4) << i;
}

TEST(Nifti, ValueTypeIsTheSmallestThatHoldsAll) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  for (const auto& [value, type] :
       {std::pair{-5.f, DT_INT16}, {60000.f, DT_UINT16}, {0.5f, DT_FLOAT32}, {1e6f, DT_FLOAT32}}) {
    auto volume = numberedVolume();
    volume.voxels[3] = value;
    volume::writeNifti(volume, path);
    EXPECT_EQ(Raw(path).header.datatype, type) << value;
    EXPECT_EQ(volume::readNifti(path).volume.voxels, volume.voxels);
  }
}

TEST(Nifti, QformServesWithoutSformAndIsNamed) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  raw.header.sform_code = 0;
  raw.save();
  const auto read = volume::readNifti(path);
  EXPECT_EQ(read.volume.orientation_source, "qform");
  EXPECT_TRUE(read.volume.grid.matches(numberedVolume().grid));
}

TEST(Nifti, DisagreementOfSformAndQformIsSaid) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  raw.header.srow_x[3] += 11.5f;
  raw.save();
  const auto read = volume::readNifti(path);
  ASSERT_TRUE(read.warning);
  EXPECT_THAT(*read.warning, ::testing::HasSubstr("12 mm"));
  EXPECT_NEAR(read.volume.grid.toMri({0, 0, 0}).mm.x(), 1.5, 1e-5);  // from sform
}

/// A file whose sform is `linear` times its qform.
std::filesystem::path fileWithSformTimes(const Eigen::DiagonalMatrix<double, 3>& linear,
                                         const std::filesystem::path& path) {
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  for (int c = 0; c < 3; ++c) {
    raw.header.srow_x[c] *= float(linear.diagonal()[0]);
    raw.header.srow_y[c] *= float(linear.diagonal()[1]);
    raw.header.srow_z[c] *= float(linear.diagonal()[2]);
  }
  raw.save();
  return path;
}

TEST(Nifti, MirrorImagesAndScaledHeadsAreNotChosenInSilence) {
  using volume::NiftiTransform;
  const TemporaryFolder folder;
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1), larger(1.08, 1.08, 1.08);
  for (const auto& linear : {mirror, larger}) {
    const auto path = fileWithSformTimes(linear, folder.path() / "a.nii");
    const auto automatic = volume::readNifti(path);
    EXPECT_EQ(automatic.volume.orientation_source, "sform");
    ASSERT_TRUE(automatic.warning);
    EXPECT_NE(automatic.warning->find("find out which one is right"), std::string::npos)
        << *automatic.warning;
    const auto sform = volume::readNifti(path, NiftiTransform::sform);
    const auto qform = volume::readNifti(path, NiftiTransform::qform);
    EXPECT_EQ(sform.volume.orientation_source, "sform");
    EXPECT_EQ(qform.volume.orientation_source, "qform");
    EXPECT_TRUE(qform.volume.grid.matches(numberedVolume().grid));
    EXPECT_FALSE(sform.volume.grid.matches(numberedVolume().grid));
    ASSERT_TRUE(sform.warning && qform.warning);
    EXPECT_NE(*sform.warning, *qform.warning);
  }
}

TEST(Nifti, TheEvidenceNamesWhatWasTakenAndWhetherTheOtherAgrees) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  EXPECT_EQ(volume::readNifti(path).evidence, "sform (scanner); the qform agrees");
  EXPECT_EQ(volume::readNifti(path, volume::NiftiTransform::qform).evidence,
            "qform (scanner), as asked for; the sform agrees");
  Raw raw(path);
  raw.header.qform_code = 0;
  raw.save();
  EXPECT_THROW(volume::readNifti(path, volume::NiftiTransform::qform), Error);
  EXPECT_THROW(volume::niftiTransformNamed("aform"), Error);
}

TEST(Nifti, NeitherSformNorQformIsRefusedSinceLeftAndRightAreUnknown) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  raw.header.sform_code = raw.header.qform_code = 0;
  raw.save();
  EXPECT_THROW(volume::readNifti(path), Error);
}

TEST(Nifti, SlopeAndInterceptAreApplied) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  raw.header.scl_slope = 2;
  raw.header.scl_inter = -3;
  raw.save();
  EXPECT_EQ(volume::readNifti(path).volume.at(1, 2, 3), 2 * 321.f - 3);
}

/// Multiplies all lengths of the header, like a program that uses another unit.
void scaleLengths(nifti_1_header& header, float factor) {
  for (int c = 0; c < 4; ++c)
    header.srow_x[c] *= factor, header.srow_y[c] *= factor, header.srow_z[c] *= factor;
  for (int d = 1; d <= 3; ++d) header.pixdim[d] *= factor;
  header.qoffset_x *= factor, header.qoffset_y *= factor, header.qoffset_z *= factor;
}

TEST(Nifti, LengthsInMetresAndMicrometresBecomeMillimetresInBothMaps) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  for (const auto& [unit, per_mm] : {std::pair{NIFTI_UNITS_METER, 1e-3f}, {NIFTI_UNITS_MICRON, 1e3f}}) {
    volume::writeNifti(numberedVolume(), path);
    Raw raw(path);
    scaleLengths(raw.header, per_mm);
    raw.header.xyzt_units = char(unit);
    raw.save();
    for (const auto choice : {volume::NiftiTransform::sform, volume::NiftiTransform::qform}) {
      const auto grid = volume::readNifti(path, choice).volume.grid;
      EXPECT_TRUE(grid.mri_from_voxel.isApprox(numberedVolume().grid.mri_from_voxel, 1e-5)) << unit;
    }
  }
}

TEST(Nifti, LengthsWithoutAUnitAreMillimetres) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  raw.header.xyzt_units = 0;
  raw.save();
  EXPECT_TRUE(volume::readNifti(path).volume.grid.matches(numberedVolume().grid));
}

TEST(Nifti, AStatisticalMapNamesItsStatisticAndItsSpace) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  EXPECT_EQ(volume::readNifti(path).statistic, "");
  EXPECT_FALSE(volume::readNifti(path).is_template_space);
  for (const auto& [intent, name] : {std::pair{NIFTI_INTENT_TTEST, "t"}, {NIFTI_INTENT_ZSCORE, "z"}}) {
    Raw raw(path);
    raw.header.intent_code = short(intent);
    raw.header.sform_code = NIFTI_XFORM_MNI_152;
    raw.save();
    EXPECT_EQ(volume::readNifti(path).statistic, name);
    EXPECT_TRUE(volume::readNifti(path).is_template_space);
    EXPECT_FALSE(volume::readNifti(path, volume::NiftiTransform::qform).is_template_space);
  }
}

TEST(Nifti, LeftHandedFilesKeepTheirWorld) {
  const TemporaryFolder folder;
  auto volume = numberedVolume();
  volume.grid.mri_from_voxel.linear().col(0) *= -1;  // radiological order: i runs to the left
  volume::writeNifti(volume, folder.path() / "a.nii");
  const auto read = volume::readNifti(folder.path() / "a.nii");
  EXPECT_TRUE(read.volume.grid.matches(volume.grid));
  EXPECT_FALSE(read.warning);
}

TEST(Nifti, DamagedFilesAreRefusedInOneLine) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  const std::string good = readWholeFile(path);
  for (const std::size_t length : {std::size_t(0), std::size_t(100), std::size_t(348), good.size() - 50}) {
    writeWholeFile(path, good.substr(0, length));
    EXPECT_THROW(volume::readNifti(path), Error) << length;
  }
  Raw raw((writeWholeFile(path, good), path));
  raw.header.srow_x[0] = std::nanf("");
  raw.save();
  EXPECT_THROW(volume::readNifti(path), Error);
  EXPECT_THROW(volume::readNifti(folder.path() / "absent.nii"), Error);
}

TEST(Nifti, TheLibrarySaysNothingOfADamagedHeader) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  const std::string good = readWholeFile(path);
  const std::function<void(nifti_1_header&)> damages[] = {
      [](auto& header) { header.dim[0] = 9; },   [](auto& header) { header.dim[0] = 0; },
      [](auto& header) { header.dim[1] = 0; },   [](auto& header) { header.datatype = 0; },
      [](auto& header) { header.datatype = 1; }, [](auto& header) { header.datatype = 999; }};
  ::testing::internal::CaptureStderr();
  for (const auto& damage : damages) {
    Raw raw((writeWholeFile(path, good), path));
    damage(raw.header);
    raw.save();
    EXPECT_THROW(volume::readNifti(path), Error);
    EXPECT_THROW(volume::readNiftiForms(path), Error);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Nifti, ValuesWhoseSquareIsNoNumberAndPipesAreRefused) {
  const TemporaryFolder folder;
  auto scan = numberedVolume();
  scan.voxels.back() = 1e30f;
  volume::writeNifti(scan, folder.path() / "a.nii");
  EXPECT_THROW(volume::readNifti(folder.path() / "a.nii"), Error);
  const auto pipe = folder.path() / "pipe.nii";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(volume::readNifti(pipe), Error) << "without waiting for a writer";
}

TEST(Nifti, TruncatedCompressedFileIsRefused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii.gz";
  volume::writeNifti(numberedVolume(), path);
  const std::string good = readWholeFile(path);
  writeWholeFile(path, good.substr(0, good.size() * 3 / 4));
  EXPECT_THROW(volume::readNifti(path), Error);
}

TEST(Nifti, APairOfHeaderAndImageIsReadByEitherName) {
  const TemporaryFolder folder;
  volume::writeNifti(numberedVolume(), folder.path() / "a.nii");
  Raw raw(folder.path() / "a.nii");
  const auto offset = std::size_t(raw.header.vox_offset);
  std::memcpy(raw.header.magic, "ni1", 4);
  raw.header.vox_offset = 0;
  raw.save();
  writeWholeFile(folder.path() / "pair.hdr", raw.bytes.substr(0, offset));
  writeWholeFile(folder.path() / "pair.img", raw.bytes.substr(offset));
  for (const char* name : {"pair.hdr", "pair.img"}) {
    EXPECT_TRUE(volume::isNiftiName(name));
    EXPECT_EQ(volume::readNifti(folder.path() / name).volume.voxels, numberedVolume().voxels) << name;
  }
}

TEST(Nifti, IsToldByTheNameInUpperAndLowerCase) {
  for (const auto& ending : volume::niftiEndings())
    EXPECT_TRUE(volume::isNiftiName("/some.where/t1" + ending));
  EXPECT_TRUE(volume::isNiftiName("T1.NII.GZ"));
  EXPECT_TRUE(volume::isNiftiName("T1.IMG"));
  for (const char* other : {"t1.dcm", "t1", "t1.nii.txt", "t1.gz", ".nii", "a.nii/IM0001"})
    EXPECT_FALSE(volume::isNiftiName(other)) << other;
}

TEST(Nifti, BigEndianFileIsRead) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  const auto offset = std::size_t(raw.header.vox_offset);
  swap_nifti_header(&raw.header, 1);
  for (std::size_t i = offset; i + 1 < raw.bytes.size(); i += 2) std::swap(raw.bytes[i], raw.bytes[i + 1]);
  raw.save();
  EXPECT_EQ(volume::readNifti(path).volume.voxels, numberedVolume().voxels);
}

TEST(Nifti, DimensionsThatLieAreRefusedWithoutAllocating) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  volume::writeNifti(numberedVolume(), path);
  Raw raw(path);
  for (int a = 1; a <= 3; ++a) raw.header.dim[a] = 32000;
  raw.save();
  EXPECT_THROW(volume::readNifti(path), Error);
}

TEST(Nifti, MaskRoundTrip) {
  const TemporaryFolder folder;
  volume::Mask mask{numberedVolume().grid, std::vector<std::uint8_t>(210, 0)};
  mask.voxels[17] = mask.voxels[100] = 1;
  volume::writeMask(mask, folder.path() / "m.nii.gz");
  EXPECT_EQ(volume::readMask(folder.path() / "m.nii.gz").voxels, mask.voxels);
}

TEST(Nifti, RealColin27StandsUprightInRas) {
  FACENAV_NEEDS(colin27());
  const auto volume = volume::readNifti(colin27()).volume;
  // MNI space: the plane x = 0 is the midline, and the left thalamus is brighter than half of all voxels.
  EXPECT_NEAR(volume.grid.toVoxel(Point<Mri>(0, 0, 0))[0] / volume.grid.size[0], 0.5, 0.02);
  EXPECT_GT(volume::sampleLinear(volume, volume.grid.toVoxel(Point<Mri>(-10, -20, 8))),
            volume::percentile(volume, 0.5));
}

}  // namespace
}  // namespace facenav::testing
