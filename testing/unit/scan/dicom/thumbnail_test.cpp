// Thumbnails: the middle image in the patient's proportions; nothing, rather than an error, if there is none.

#include "facenav/dicom/thumbnail.h"

#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

/// Slice k is black but for one bright quarter: top left in the middle slice, bottom right in all others.
std::vector<Slice> quarters(const Slice& first) {
  return makeSlices(9, first, [](Slice& s, int k) {
    for (int j = 0; j < s.rows; ++j)
      for (int i = 0; i < s.columns; ++i) {
        const bool is_top_left = j < s.rows / 2 && i < s.columns / 2;
        const bool is_bottom_right = j >= s.rows / 2 && i >= s.columns / 2;
        s.values[std::size_t(j) * s.columns + i] = (k == 4 ? is_top_left : is_bottom_right) ? 1000 : 10;
      }
  });
}

std::optional<dicom::Thumbnail> thumbnailOf(const std::vector<Slice>& slices, int side_px) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  TaskMonitor monitor;
  return dicom::makeThumbnail(dicom::listSeries(folder.path(), monitor).at(0), side_px);
}

TEST(Thumbnail, ShowsTheMiddleSliceInThePatientsProportions) {
  Slice first;
  first.rows = 24;
  first.columns = 20;
  first.row_spacing = 2.0;  // 48 mm high, 20 mm wide
  const auto picture = thumbnailOf(quarters(first), 96);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->height_px, 96);
  EXPECT_EQ(picture->width_px, 40);
  EXPECT_EQ(picture->grey[0], 255);
  EXPECT_EQ(picture->grey.back(), 0);
}

TEST(Thumbnail, Monochrome1IsShownInverted) {
  Slice first;
  first.photometric = "MONOCHROME1";
  const auto picture = thumbnailOf(quarters(first), 24);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->grey[0], 0);
  EXPECT_EQ(picture->grey.back(), 255);
}

TEST(Thumbnail, WhatIsNotLoadableStillHasAPicture) {
  Slice first;
  first.image_type = "ORIGINAL\\PRIMARY\\M\\MOSAIC";
  EXPECT_TRUE(thumbnailOf(quarters(first), 32));
}

TEST(Thumbnail, NothingForColourAndCutOffPixels) {
  Slice colour;
  colour.photometric = "PALETTE COLOR";
  EXPECT_FALSE(thumbnailOf(quarters(colour), 32));
  const TemporaryFolder folder;
  const std::string whole = sliceFile(makeSlices(1)[0]);
  writeBytes(folder.path() / "a", whole.substr(0, whole.size() - 100));
  TaskMonitor monitor;
  EXPECT_FALSE(dicom::makeThumbnail(dicom::listSeries(folder.path(), monitor).at(0), 32));
}

}  // namespace
}  // namespace facenav::testing
