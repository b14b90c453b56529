// Which kind of image a series is: by the texts of the header, and by its values; and which one is taken for
// it.

#include "facenav/dicom/image_kind.h"

#include <gmock/gmock.h>

#include <random>

#include "dicom_bytes.h"
#include "facenav/core/error.h"
#include "facenav/dicom/import_volume.h"
#include "series/value_check.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

using dicom::ImageKind;
using ::testing::HasSubstr;

TEST(ImageKind, ByImageType) {
  const std::pair<const char*, ImageKind> kCases[] = {
      {"ORIGINAL\\PRIMARY\\M\\NORM\\DIS3D", ImageKind::magnitude},
      {"ORIGINAL\\PRIMARY\\P\\ND", ImageKind::phase},
      {"ORIGINAL\\PRIMARY\\PHASE MAP\\P\\FFE", ImageKind::phase},
      {"ORIGINAL\\PRIMARY\\M_FFE\\M\\FFE", ImageKind::magnitude},
      {"ORIGINAL\\PRIMARY\\R_IR\\R\\IR", ImageKind::real},
      {"ORIGINAL\\PRIMARY\\I\\ND", ImageKind::imaginary},
      {"ORIGINAL\\PRIMARY\\VOLUME\\NONE\\PHASE", ImageKind::phase},
      {"DERIVED\\PRIMARY\\T1 MAP\\ND", ImageKind::t1_map},
      {"DERIVED\\PRIMARY\\M\\T1_MAP", ImageKind::t1_map},
      {"DERIVED\\PRIMARY\\R2_STAR MAP\\ND", ImageKind::rate_map},
      {"DERIVED\\PRIMARY\\FLIP ANGLE MAP\\ND", ImageKind::field_map},
      {"ORIGINAL\\PRIMARY\\M\\ND\\UNI", ImageKind::uniform},
      {"ORIGINAL\\PRIMARY\\LOCALIZER\\M", ImageKind::localizer},
      {"DERIVED\\SECONDARY\\MPR", ImageKind::magnitude},
      {"", ImageKind::magnitude}};
  for (const auto& [type, kind] : kCases)
    EXPECT_STREQ(dicom::idOf(dicom::kindOf(type, "t1_mprage_sag")), dicom::idOf(kind)) << type;
}

TEST(ImageKind, ByDescription) {
  const std::pair<const char*, ImageKind> kCases[] = {
      {"t1_mprage_sag_p2_iso", ImageKind::magnitude},
      {"T1w", ImageKind::magnitude},
      {"t1_mp2rage_sag_p3_iso_UNI_Images", ImageKind::uniform},
      {"t1_mp2rage_sag_p3_iso_UNI-DEN", ImageKind::uniform},
      {"t1_mp2rage_sag_p3_iso_T1_Images", ImageKind::t1_map},
      {"t1_mp2rage_sag_p3_iso_INV1", ImageKind::inversion},
      {"MP2RAGE T1", ImageKind::t1_map},
      {"T1 map", ImageKind::t1_map},
      {"qT1", ImageKind::t1_map},
      {"R1_map", ImageKind::rate_map},
      {"R1", ImageKind::rate_map},
      {"PD map", ImageKind::density_map},
      {"tfl_b1map_sag", ImageKind::field_map},
      {"gre_field_mapping", ImageKind::field_map},
      {"AAHead_Survey", ImageKind::localizer},
      {"loca_3plan_haste", ImageKind::localizer},
      {"MPRAGE phase AP", ImageKind::magnitude},
      {"uni hospital t1 mprage", ImageKind::magnitude}};
  for (const auto& [words, kind] : kCases)
    EXPECT_STREQ(dicom::idOf(dicom::kindOf("ORIGINAL\\PRIMARY\\M\\ND", words)), dicom::idOf(kind)) << words;
  EXPECT_EQ(dicom::kindOf("", "t1_mp2rage_INV1_PHS"), ImageKind::phase);
  EXPECT_EQ(dicom::kindOf("ORIGINAL\\PRIMARY\\P\\ND", "T1 map"), ImageKind::phase) << "Image Type first";
}

enum class Values { magnitude, phase, real, uniform_head };

/// A disc of signal in dark air, or the same as phase, real part, or head of an MP2RAGE UNI; seeded.
void paint(Slice& s, Values what, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> whole(0, 4095);
  std::normal_distribution<double> noise(0, 40);
  s.values.clear();
  for (int j = 0; j < s.rows; ++j)
    for (int i = 0; i < s.columns; ++i) {
      const double r = std::hypot(i - s.columns / 2.0, j - s.rows / 2.0) / (0.4 * s.rows);
      const double signal = r < 1 ? 1500 + 800 * std::cos(9 * r) : 0;
      const double sign = i % 40 < 20 ? 1 : -1;
      if (what == Values::magnitude)
        s.values.push_back(int(std::hypot(signal + noise(random), noise(random))));
      if (what == Values::phase) s.values.push_back(r < 1 ? 2048 + int(noise(random)) : whole(random));
      if (what == Values::real) s.values.push_back(int(sign * signal + noise(random)) & 0xFFFF);
      if (what == Values::uniform_head) s.values.push_back(r < 1 ? int(signal) : whole(random));
    }
}

std::vector<float> valuesOf(Values what) {
  Slice s;
  s.rows = s.columns = 128;
  paint(s, what, 3);
  std::vector<float> values;
  for (const int v : s.values) values.push_back(float(what == Values::real && v > 32767 ? v - 65536 : v));
  return values;
}

TEST(HasDarkAir, TellsAMagnitudeFromPhaseRealPartAndUni) {
  EXPECT_TRUE(dicom::hasDarkAir(valuesOf(Values::magnitude), 128, 128));
  EXPECT_FALSE(dicom::hasDarkAir(valuesOf(Values::phase), 128, 128));
  EXPECT_FALSE(dicom::hasDarkAir(valuesOf(Values::real), 128, 128));
  EXPECT_FALSE(dicom::hasDarkAir(valuesOf(Values::uniform_head), 128, 128));
  auto shifted = valuesOf(Values::magnitude);
  for (float& v : shifted) v -= 1800;
  EXPECT_TRUE(dicom::hasDarkAir(shifted, 128, 128)) << "negative, but dark";
  auto ramp = valuesOf(Values::magnitude);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = float(i % 128);
  EXPECT_TRUE(dicom::hasDarkAir(ramp, 128, 128)) << "no air at all";
  EXPECT_TRUE(dicom::hasDarkAir(std::vector<float>(128 * 128, 7), 128, 128));
}

/// A head-sized series of 1.2 mm.
void writeHead(const std::filesystem::path& folder, const std::string& uid, const std::string& description,
               const std::string& image_type, Values values = Values::magnitude) {
  Slice s;
  s.rows = s.columns = 160;
  s.row_spacing = s.column_spacing = s.thickness = 1.2;
  s.series_uid = uid, s.series_number = uid, s.description = description, s.image_type = image_type;
  s.series_number = uid.substr(uid.find('.') + 1);
  writeSlices(folder, makeSlices(140, s, [&](Slice& slice, int k) { paint(slice, values, unsigned(k)); }));
}

std::vector<dicom::SeriesInfo> listOf(const TemporaryFolder& folder) {
  TaskMonitor monitor;
  return dicom::listSeries(folder.path(), monitor);
}

constexpr char kMagnitude[] = "ORIGINAL\\PRIMARY\\M\\ND", kPhase[] = "ORIGINAL\\PRIMARY\\P\\ND";

TEST(ListSeries, TakesTheMagnitudeBesideItsPhase) {
  const TemporaryFolder folder;
  writeHead(folder.path() / "a", "1.3", "T1 MPRAGE", kPhase, Values::phase);
  writeHead(folder.path() / "b", "1.4", "T1 MPRAGE", kMagnitude);
  const auto series = listOf(folder);
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].series_uid, "1.4");
  EXPECT_TRUE(series[0].is_recommended && series[0].is_fit_for_navigation) << series[0].fitness;
  EXPECT_EQ(series[1].kind, ImageKind::phase);
  EXPECT_EQ(series[1].contrast, "phase image");
  EXPECT_THAT(series[1].fitness, HasSubstr("phase image"));
}

TEST(ListSeries, AWeightedImageComesBeforeUniInversionsAndMaps) {
  const TemporaryFolder folder;
  writeHead(folder.path() / "1", "1.1", "mp2rage_T1_Images", kMagnitude);
  writeHead(folder.path() / "2", "1.2", "mp2rage_INV1", kMagnitude);
  writeHead(folder.path() / "3", "1.3", "mp2rage_UNI_Images", kMagnitude, Values::uniform_head);
  auto series = listOf(folder);
  ASSERT_EQ(series.size(), 3u);
  EXPECT_EQ(series[0].kind, ImageKind::uniform) << series[0].description;
  EXPECT_TRUE(series[0].is_recommended);
  EXPECT_THAT(series[0].notes, ::testing::Contains(HasSubstr("UNI")));
  EXPECT_EQ(series[2].kind, ImageKind::t1_map);
  EXPECT_THAT(series[2].fitness, HasSubstr("T1 map"));
  writeHead(folder.path() / "4", "1.4", "t1_mprage", kMagnitude);
  series = listOf(folder);
  EXPECT_EQ(series[0].series_uid, "1.4");
  EXPECT_EQ(series[1].kind, ImageKind::uniform);
}

TEST(ListSeries, AMagnitudeByItsHeaderIsJudgedByItsValues) {
  const TemporaryFolder folder;
  writeHead(folder.path() / "1", "1.1", "t1_mprage", kMagnitude, Values::phase);
  writeHead(folder.path() / "2", "1.2", "t1_mprage", kMagnitude);
  const auto series = listOf(folder);
  EXPECT_EQ(series[0].series_uid, "1.2");
  EXPECT_TRUE(series[0].is_recommended);
  EXPECT_EQ(series[1].kind, ImageKind::signed_or_uniform);
  EXPECT_THAT(series[1].fitness, HasSubstr("phase image"));
}

TEST(ListSeries, ALocalizerOfThreePlanesIsNamedWhateverItIsCalled) {
  const TemporaryFolder folder;
  Slice s;
  s.series_uid = "1.7", s.description = "Planung", s.thickness = 10;
  for (int plane = 0; plane < 3; ++plane) {
    s.row = Eigen::Vector3d::Unit(plane), s.column = Eigen::Vector3d::Unit((plane + 1) % 3);
    writeSlices(folder.path() / std::to_string(plane), makeSlices(5, s));
  }
  const auto series = listOf(folder);
  ASSERT_EQ(series.size(), 3u);
  for (const auto& info : series) {
    EXPECT_EQ(info.kind, ImageKind::localizer);
    EXPECT_THAT(info.fitness, HasSubstr("localizer"));
    EXPECT_FALSE(info.is_recommended);
  }
}

TEST(ListSeries, PhaseSlicesAmongMagnitudeAreNamed) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), makeSlices(40, Slice(), [](Slice& s, int k) {
                s.image_type = k == 10 || k == 11 || k == 30 ? kPhase : kMagnitude;
              }));
  const auto series = listOf(folder);
  const auto magnitude =
      std::find_if(series.begin(), series.end(), [](const auto& s) { return s.slices > 10; });
  ASSERT_NE(magnitude, series.end());
  EXPECT_THAT(magnitude->problem,
              HasSubstr("3 of the 40 images of this series are of another kind (phase image)"));
}

TEST(ImportVolume, APhaseAloneOrAskedForIsRefusedByItsName) {
  const TemporaryFolder folder;
  writeHead(folder.path() / "a", "1.3", "T1 MPRAGE", kPhase, Values::phase);
  TaskMonitor monitor;
  const auto refusal = [&](const std::optional<std::string>& id) {
    try {
      dicom::importVolume(folder.path(), id, monitor);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(refusal(std::nullopt), HasSubstr("phase image"));
  writeHead(folder.path() / "b", "1.4", "T1 MPRAGE", kMagnitude);
  EXPECT_EQ(dicom::importVolume(folder.path(), std::nullopt, monitor).series->series_uid, "1.4");
  EXPECT_THAT(refusal("1.3"), HasSubstr("phase image"));
}

TEST(ImportVolume, AMapAskedForIsReadWithOneLineThatNamesIt) {
  const TemporaryFolder folder;
  writeHead(folder.path(), "1.3", "T1 map", kMagnitude);
  TaskMonitor monitor;
  const auto imported = dicom::importVolume(folder.path(), "1.3", monitor);
  EXPECT_THAT(imported.warnings, ::testing::ElementsAre(HasSubstr("a T1 map, not a T1-weighted image")));
}

}  // namespace
}  // namespace facenav::testing
