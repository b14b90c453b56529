// Objects made from a patient's series: they keep its patient, study and place, and are known as derived.

#include "facenav/dicom/derived_objects.h"

#include <gdcmReader.h>
#include <gmock/gmock.h>

#include "apart_slices.h"
#include "compare_volumes.h"
#include "enhanced_file.h"
#include "facenav/core/error.h"
#include "facenav/dicom/patient.h"
#include "header/tag_values.h"
#include "support/run_program.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::Throws;

gdcm::DataSet elementsOf(const fs::path& file) {
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  EXPECT_TRUE(reader.Read()) << file;
  return reader.GetFile().GetDataSet();
}

/// Elements of a folder's files by their Image Position.
std::map<std::string, gdcm::DataSet> byPosition(const fs::path& folder) {
  std::map<std::string, gdcm::DataSet> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto data = elementsOf(entry.path());
    found[dicom::text(data, {0x0020, 0x0032})] = data;
  }
  return found;
}

class DerivedObjects : public ::testing::Test {
 protected:
  fs::path source() const { return folder_.path() / "source"; }
  fs::path made() const { return folder_.path() / "made"; }

  /// Writes `drawn` as a series derived from the only one of source().
  int derive(const volume::Volume& drawn, float white = 4000) {
    dicom::DerivedSeries words;
    words.description = "FaceNav, not for diagnosis: M1 hand L";
    words.derivation = "FaceNav: target drawn";
    words.white = white;
    return dicom::writeDerivedSeries(list(source()).at(0), drawn, words, made(), false, monitor_);
  }
  std::string refusal(const std::string& patient_of_slice_3, const std::string& modality = "MR") {
    fs::remove_all(source());
    Slice first;
    first.modality = modality;
    writeSlices(source(), makeSlices(10, first, [&](Slice& s, int k) {
                  if (patient_of_slice_3.empty() || k == 3)
                    s.patient_id = s.patient_name = patient_of_slice_3;
                }));
    auto series = list(source()).at(0);
    series.files.clear();
    for (const auto& entry : fs::directory_iterator(source())) series.files.push_back(entry.path());
    try {
      dicom::writeDerivedSeries(series, {}, {}, made(), false, monitor_);
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  }

  TemporaryFolder folder_;
  TaskMonitor monitor_;
};

TEST_F(DerivedObjects, ASeriesKeepsPatientStudyAndPlaceToTheLetter) {
  Slice first = oblique();
  first.patient_name = "M\xFCller^Eva";  // Latin-1
  first.character_set = "ISO_IR 100";
  first.patient_id = "4711";
  first.position = {-101.23456789, 80.1, 33.333333};
  first.row_spacing = 0.9375, first.column_spacing = 0.9375;
  writeSlices(source(), makeSlices(10, first));
  auto drawn = load(list(source()).at(0));
  drawn.voxels[77] = 4001;
  EXPECT_EQ(derive(drawn), 10);

  const auto before = byPosition(source()), after = byPosition(made());
  ASSERT_EQ(after.size(), 10u);
  std::set<std::string> instances;
  for (const auto& [position, data] : after) {
    ASSERT_TRUE(before.count(position)) << position;
    const auto& original = before.at(position);
    for (const auto& tag : {gdcm::Tag(0x0010, 0x0010), gdcm::Tag(0x0010, 0x0020), gdcm::Tag(0x0020, 0x000D),
                            gdcm::Tag(0x0020, 0x0052), gdcm::Tag(0x0020, 0x0037), gdcm::Tag(0x0028, 0x0030),
                            gdcm::Tag(0x0018, 0x0050), gdcm::Tag(0x0008, 0x0020), gdcm::Tag(0x0008, 0x0005)})
      EXPECT_EQ(dicom::text(data, tag), dicom::text(original, tag)) << tag;
    EXPECT_EQ(dicom::text(data, {0x0008, 0x0008}), "DERIVED\\SECONDARY\\OTHER");
    EXPECT_EQ(dicom::text(data, {0x0028, 0x0301}), "YES");
    EXPECT_THAT(dicom::text(data, {0x0020, 0x000E}), StartsWith("2.25."));
    const auto reference = dicom::item(data, {0x0008, 0x2112});
    ASSERT_TRUE(reference);
    EXPECT_EQ(dicom::text(*reference, {0x0008, 0x1155}), dicom::text(original, {0x0008, 0x0018}));
    instances.insert(dicom::text(data, {0x0008, 0x0018}));
  }
  EXPECT_EQ(instances.size(), 10u);
  const auto back = list(made()).at(0);
  EXPECT_EQ(dicom::nameInWords(dicom::patientOf(back)), "Müller, Eva");
  expectSameVolume(load(back), drawn);
}

TEST_F(DerivedObjects, AnyFormOfTheSourceIsRead) {
  const auto joined = apart(makeSlices(12, oblique()));
  Slice inverted = oblique();
  inverted.photometric = "MONOCHROME1";
  Slice implicit = oblique(), big = oblique();
  implicit.syntax = implicitLittle(), big.syntax = explicitBig();
  for (const auto& slices :
       {makeSlices(12, implicit), makeSlices(12, big), makeSlices(12, inverted), joined}) {
    fs::remove_all(source()), fs::remove_all(made());
    writeSlices(source(), slices);
    const auto drawn = load(list(source()).at(0));
    EXPECT_EQ(derive(drawn), 12);
    const auto all = list(made());
    ASSERT_EQ(all.size(), 1u);
    EXPECT_FALSE(all[0].joined) << "one series UID";
    EXPECT_EQ(dicom::patientOf(all[0]).id, "id");
    const auto back = load(all[0]);
    EXPECT_TRUE(back.grid.matches(drawn.grid) && back.voxels == drawn.voxels) << slices[0].photometric;
  }
}

/// A head whose right half (x > 0) is bright, in a sagittal stack: left and right swap in any mistake.
TEST_F(DerivedObjects, RightStaysRightForUsAndForDcm2niix) {
  Slice first;
  first.row = {0, 1, 0}, first.column = {0, 0, -1};  // columns run back, rows down
  first.position = {12, -80, 60};
  writeSlices(source(), makeSlices(12, first, [](Slice& s, int k) {
                s.position.x() = 12 - 2.0 * k;  // LPS: from the left side to the right
                s.thickness = 2;
                std::fill(s.values.begin(), s.values.end(), s.position.x() < 0 ? 900 : 100);
              }));
  auto drawn = load(list(source()).at(0));
  const Eigen::Vector3d mark = drawn.grid.toVoxel(Point<Mri>(-6, 70, 50));  // on the left
  drawn.voxels[drawn.grid.index(int(mark[0] + 0.5), int(mark[1] + 0.5), int(mark[2] + 0.5))] = 4000;
  derive(drawn);
  const auto back = import(made(), list(made()).at(0).id).volume;
  EXPECT_EQ(*volume::valueAt(back, Point<Mri>(-6, 70, 50)), 4000);
  EXPECT_EQ(*volume::valueAt(back, Point<Mri>(6, 70, 50)), 900);
  EXPECT_EQ(*volume::valueAt(back, Point<Mri>(-8, 70, 50)), 100);
  if (!hasProgram("dcm2niix")) return;
  const auto other = dcm2niixVolume(made());
  ASSERT_TRUE(other);
  expectSameInWorld(*other, drawn);
}

TEST_F(DerivedObjects, AnEnhancedFileBecomesImagesAtItsFramesPlaces) {
  Enhanced spec;
  spec.patient_id = "4711";
  writeBytes(source() / "in", enhancedFile(spec));
  auto drawn = load(list(source()).at(0));
  derive(drawn, 8000);
  const auto back = list(made()).at(0);
  EXPECT_EQ(back.slices, 10);
  const auto volume = load(back);
  EXPECT_TRUE(volume.grid.matches(drawn.grid));
  EXPECT_TRUE(volume.voxels == drawn.voxels);
  std::set<std::string> frames;
  for (const auto& [position, data] : byPosition(made()))
    frames.insert(dicom::text(*dicom::item(data, {0x0008, 0x2112}), {0x0008, 0x1160}));
  EXPECT_EQ(frames.size(), 10u);
}

TEST_F(DerivedObjects, FractionsAreScaledWithTheirWindow) {
  Slice first;
  first.slope = 0.37, first.intercept = -20;
  writeSlices(source(), makeSlices(10, first));
  derive(load(list(source()).at(0)), 1495);
  const auto data = byPosition(made()).begin()->second;
  EXPECT_THAT(dicom::text(data, {0x0008, 0x2111}), HasSubstr("values scaled to 0..4095"));
  const double centre = *dicom::number(data, {0x0028, 0x1050}),
               width = *dicom::number(data, {0x0028, 0x1051});
  EXPECT_NEAR(centre - 0.5 - (width - 1) / 2, 20 / 0.37, 2);    // black: 0
  EXPECT_NEAR(centre - 0.5 + (width - 1) / 2, 1515 / 0.37, 2);  // white: 1495
}

TEST_F(DerivedObjects, ImportKnowsItAndRecommendsTheOriginal) {
  Slice first;
  first.rows = first.columns = 160;
  first.row_spacing = first.column_spacing = first.thickness = 1.2;
  const auto slices = makeSlices(140, first);
  writeSlices(source(), slices);
  derive(load(list(source()).at(0)));
  const auto all = list(folder_.path());
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(all[0].is_recommended);
  EXPECT_EQ(all[0].series_uid, "1.2.3.4");
  EXPECT_EQ(all[1].kind, dicom::ImageKind::annotated);
  EXPECT_TRUE(all[1].is_loadable);
  EXPECT_THAT(all[1].fitness, HasSubstr("marks are drawn into its voxels"));
  EXPECT_EQ(all[0].patient, all[1].patient);
  EXPECT_THAT([&] { import(made()); }, Throws<Error>(::testing::Property(
                                           &Error::what, HasSubstr("use the series that it was made from"))));
  EXPECT_EQ(import(made(), all[1].id).volume.grid.size[2], 140);
}

TEST_F(DerivedObjects, WithoutOnePatientNothingIsWritten) {
  EXPECT_THAT(refusal(""), HasSubstr("names no patient"));
  EXPECT_THAT(refusal("another"), HasSubstr("name several patients"));
  EXPECT_THAT(refusal("id", "CT"), HasSubstr("only an MR series"));
  EXPECT_FALSE(fs::exists(made()));
}

TEST_F(DerivedObjects, APdfComesBackByteForByte) {
  writeSlices(source(), makeSlices(3));
  const auto series = list(source()).at(0);
  for (const std::string tail : {"", "x"}) {  // even and odd length
    const std::string pdf = "%PDF-1.4\n" + std::string("\0\xFF\r\n", 4) + "%%EOF\n" + tail;
    const auto file = folder_.path() / ("report" + tail + ".dcm");
    dicom::writeEncapsulatedPdf(series, pdf, "FaceNav session", file);
    const auto data = elementsOf(file);
    EXPECT_EQ(dicom::text(data, {0x0010, 0x0020}), "id");
    EXPECT_EQ(dicom::text(data, {0x0020, 0x000D}), "1.2.3");
    EXPECT_NE(dicom::text(data, {0x0020, 0x000E}), "1.2.3.4");
    const auto* bytes = data.GetDataElement(gdcm::Tag(0x0042, 0x0011)).GetByteValue();
    ASSERT_TRUE(bytes);
    const auto length = std::size_t(*dicom::number(data, {0x0042, 0x0015}));
    EXPECT_EQ(std::string(bytes->GetPointer(), bytes->GetLength()).substr(0, length), pdf);
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    const auto listed = list(file).at(0);
    EXPECT_FALSE(listed.is_loadable);
    EXPECT_EQ(listed.problem, "PDF document, no image");
  }
  EXPECT_THROW(dicom::writeEncapsulatedPdf(series, "<html>", "t", folder_.path() / "no.dcm"), Error);
  EXPECT_FALSE(fs::exists(folder_.path() / "no.dcm"));
}

TEST_F(DerivedObjects, SegmentsLieOnTheImagesThatTheyName) {
  writeSlices(source(), makeSlices(10, oblique()));
  const auto series = list(source()).at(0);
  const auto volume = load(series);
  dicom::Segment spot{"M1 hand L", {volume.grid, std::vector<std::uint8_t>(volume.grid.count(), 0)}, false};
  dicom::Segment coil{"coil", spot.mask, true};
  for (const int k : {3, 4}) spot.mask.voxels[volume.grid.index(7, 11, k)] = 1;
  coil.mask.voxels[volume.grid.index(19, 23, 9)] = 1;  // the last voxel
  const auto file = folder_.path() / "plan.dcm";
  dicom::writeSegmentation(series, {spot, coil}, "FaceNav plan", file, monitor_);
  const auto data = elementsOf(file);
  EXPECT_EQ(dicom::text(data, {0x0010, 0x0020}), "id");
  EXPECT_EQ(dicom::text(data, {0x0020, 0x0052}), "1.9");
  const auto segments = dicom::items(data, {0x0062, 0x0002});
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(dicom::text(segments[0], {0x0062, 0x0005}), "M1 hand L");
  const auto frames = dicom::items(data, {0x5200, 0x9230});
  ASSERT_EQ(frames.size(), 3u) << "one for each segment and image with voxels";
  const auto* bits = data.GetDataElement(gdcm::Tag(0x7FE0, 0x0010)).GetByteValue();
  ASSERT_TRUE(bits);
  const auto images = byPosition(source());
  const std::vector<std::pair<int, Eigen::Vector3d>> expected{
      {1, {7, 11, 3}}, {1, {7, 11, 4}}, {2, {19, 23, 9}}};
  for (std::size_t f = 0; f < 3; ++f) {
    const auto& [segment, voxel] = expected[f];
    EXPECT_EQ(*dicom::number(*dicom::item(frames[f], {0x0062, 0x000A}), {0x0062, 0x000B}), segment);
    int set = 0;
    for (int v = 0; v < 20 * 24; ++v) {
      const std::size_t bit = f * 20 * 24 + std::size_t(v);
      const bool is_set = bits->GetPointer()[bit / 8] >> bit % 8 & 1;
      set += is_set;
      if (is_set) {
        EXPECT_EQ(v, int(voxel[0] + 20 * voxel[1]));
      }
    }
    EXPECT_EQ(set, 1);
    const auto derivation = *dicom::item(frames[f], {0x0008, 0x9124});
    const auto reference = dicom::text(*dicom::item(derivation, {0x0008, 0x2112}), {0x0008, 0x1155});
    const auto place = dicom::numbers(*dicom::item(frames[f], {0x0020, 0x9113}), {0x0020, 0x0032});
    const Eigen::Vector3d ras = volume.grid.toMri(Eigen::Vector3d(0, 0, voxel[2])).mm;
    EXPECT_LT((Eigen::Vector3d(-place[0], -place[1], place[2]) - ras).norm(), 1e-4);
    bool is_named = false;
    for (const auto& [position, image] : images)
      if (dicom::text(image, {0x0008, 0x0018}) == reference) {
        const auto p = dicom::numbers(image, {0x0020, 0x0032});
        is_named =
            (Eigen::Vector3d(p[0], p[1], p[2]) - Eigen::Vector3d(place[0], place[1], place[2])).norm() < 1e-4;
      }
    EXPECT_TRUE(is_named) << "the frame lies on the image that it names";
  }
  EXPECT_EQ(list(file).at(0).problem, "segmentation or registration object, no anatomical image");
  spot.mask.voxels.assign(volume.grid.count(), 0);
  EXPECT_THROW(dicom::writeSegmentation(series, {spot}, "", folder_.path() / "no.dcm", monitor_), Error);
}

TEST_F(DerivedObjects, AnotherProgramFindsNoFault) {
  FACENAV_NEEDS_PROGRAM("dciodvfy");
  writeSlices(source(), makeSlices(3, oblique()));
  derive(load(list(source()).at(0)));
  dicom::writeEncapsulatedPdf(list(source()).at(0), "%PDF-1.4\n", "FaceNav session", made() / "report.dcm");
  const auto grid = load(list(source()).at(0)).grid;
  const volume::Mask all{grid, std::vector<std::uint8_t>(grid.count(), 1)};
  dicom::writeSegmentation(list(source()).at(0), {{"place", all, false}, {"coil", all, true}}, "FaceNav plan",
                           made() / "plan.dcm", monitor_);
  for (const auto& entry : fs::directory_iterator(made())) {
    const auto result = runProgram("dciodvfy", "'" + entry.path().string() + "'");
    EXPECT_THAT(result.errors + result.output, ::testing::Not(HasSubstr("Error"))) << entry.path();
  }
}

}  // namespace
}  // namespace facenav::testing
