#pragma once
// Exports in which every slice carries a study, series and frame-of-reference UID of its own.

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "dicom_bytes.h"
#include "facenav/dicom/import_volume.h"
#include "support/test_data.h"

namespace facenav::testing {

inline std::vector<dicom::SeriesInfo> list(const std::filesystem::path& folder) {
  TaskMonitor monitor;
  return dicom::listSeries(folder, monitor);
}
inline volume::Volume load(const dicom::SeriesInfo& info) {
  TaskMonitor monitor;
  return dicom::loadSeries(info, monitor);
}
inline dicom::ImportedVolume import(const std::filesystem::path& folder,
                                    const std::optional<std::string>& id = std::nullopt) {
  TaskMonitor monitor;
  return dicom::importVolume(folder, id, monitor);
}

/// Oblique slice, so that every flip or rotation is detected.
inline Slice oblique() {
  Slice s;
  const Eigen::AngleAxisd turn(0.3, Eigen::Vector3d(0.2, 0.5, 0.8).normalized());
  s.row = turn * Eigen::Vector3d(0, 1, 0);
  s.column = turn * Eigen::Vector3d(0, 0, -1);
  s.series_time = "101500";
  s.frame_uid = "1.9";
  return s;
}

/// Gives every slice UIDs of its own: `root`.1, `root`.2, ..
inline std::vector<Slice> apart(std::vector<Slice> slices, const std::string& root = "2.25.77") {
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const std::string tail = "." + std::to_string(k + 1);
    slices[k].study_uid = root + ".1" + tail;
    slices[k].series_uid = root + ".2" + tail;
    slices[k].frame_uid = root + ".3" + tail;
    slices[k].sop_uid = root + ".4" + tail;
  }
  return slices;
}

inline std::vector<Slice> both(std::vector<Slice> a, const std::vector<Slice>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline void expectSameVolume(const volume::Volume& a, const volume::Volume& b) {
  EXPECT_EQ(a.grid.size, b.grid.size);
  EXPECT_EQ(a.grid.mri_from_voxel.matrix(), b.grid.mri_from_voxel.matrix());  // to the bit
  EXPECT_TRUE(a.voxels == b.voxels);
}

/// Loads `slices` as one series under one UID.
inline volume::Volume properVolume(const std::vector<Slice>& slices) {
  const TemporaryFolder folder;
  writeSlices(folder.path(), slices);
  return load(list(folder.path()).at(0));
}

/// Copies the slices at the same positions, with other values.
inline std::vector<Slice> again(std::vector<Slice> slices) {
  for (Slice& s : slices)
    for (int& value : s.values) value = 4095 - value;
  return slices;
}

}  // namespace facenav::testing
