#pragma once
// Lost files: images whose file is empty (a copy that was broken off), that a DICOMDIR lists but the folder
// does not hold, or that the headers count. A scan without them may lack a part of the head.

#include <filesystem>
#include <vector>

#include "facenav/dicom/series.h"
#include "header/slice_header.h"

namespace facenav::dicom {

struct LostFiles {
  std::vector<std::filesystem::path> empty;   // files of 0 bytes
  std::vector<std::filesystem::path> absent;  // listed by a DICOMDIR and not there
};

/// The files that the DICOMDIR `directory` lists and that do not exist. Names are compared as CDs are
/// mounted: any case, with or without ";1". Empty if the DICOMDIR cannot be read: its files are found anyway.
std::vector<std::filesystem::path> absentFilesOf(const std::filesystem::path& directory);

/// Gives each series one note (or one addition to its problem) about the lost files that lie beside its own
/// and are named like them.
void noteLostFiles(std::vector<SeriesInfo>& series, const LostFiles& lost);

/// Compares each series with the number of images that its headers state.
void countStatedImages(std::vector<SeriesInfo>& series, const std::vector<SliceHeader>& headers);

}  // namespace facenav::dicom
