#pragma once
// DICOM series on disk -> Volume (through GDCM). The volume is built from Image Position and Orientation
// (Patient) (PS3.3 C.7.6.2), never from file names or slice location alone; rescale applied; LPS flipped to
// RAS here only. Voxel values and world positions equal dcm2niix's.

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/dicom/joined_slices.h"
#include "facenav/volume/volume.h"

namespace facenav::dicom {

/// Why a series gives no volume. Code asks for this; `SeriesInfo::problem` says it to people.
enum class SeriesProblem {
  none,
  no_volume,   // another kind of object, a localizer, a modality that is not read
  unreadable,  // voxels or compression that are not read
  damaged,     // cut off, slices missing
  geometry,    // places that make no regular stack
  single_slice,
  several_volumes,  // at one place
  too_large,
};
/// "damaged", "single_slice", ..: for other programs; it stays the same when the words change. Empty for
/// none.
const char* idOf(SeriesProblem problem);

/// One volume that a series holds, or would hold. A series whose UID covers several (echoes, magnitude and
/// phase, stacks) gives one entry each, told apart by `part`.
struct SeriesInfo {
  std::string series_uid, study_uid;
  std::string id;                           // what --series takes: the UID, with "#2", "#3" for further parts
  std::string description, modality, date;  // date as YYYY-MM-DD or empty; never the patient's name
  std::string part;                    // "echo 4.92 ms", "phase", ..; empty where the UID holds one volume
  std::optional<JoinedSlices> joined;  // the slices carry UIDs of their own and were put together
  bool is_magnitude_part = false;      // told from the UID's other parts as magnitude
  bool has_contrast_agent = false;
  std::string contrast;  // "T1", "T2", "FLAIR", "diffusion", ..; empty where unknown
  int series_number = 0;
  std::optional<int> patient;  // 1, 2, .. among the series listed together. Whose they are: patient.h
  int rows = 0, columns = 0, slices = 0;
  Eigen::Vector3d spacing_mm = Eigen::Vector3d::Zero();  // column, row, slice
  Eigen::Vector3d extent_mm = Eigen::Vector3d::Zero();   // along right, anterior, superior
  std::string plane;  // "axial", "coronal", "sagittal", "axial oblique", ...
  std::vector<std::filesystem::path> files;
  std::vector<std::vector<int>>
      frames;  // per file the frames of this volume; empty: every frame of every file
  bool is_loadable = false;
  SeriesProblem problem_kind = SeriesProblem::none;
  std::string problem;                   // why not, in words, when !is_loadable
  std::filesystem::path problem_file;    // the file at fault, where there is one
  std::vector<std::string> notes;        // duplicates dropped, lossy compression, CT gives the scalp only, ..
  bool is_fit_for_navigation = false;    // a T1 of the whole head with voxels of at most 1.2 mm
  std::string fitness;                   // "fit for navigation", or what stands against it, in words
  bool is_recommended = false;           // the best T1 for navigation among those listed; none where
                                         // these are of several patients or that one is one of several
                                         // readings of the same slices
  std::filesystem::path thumbnail_file;  // its middle image, for thumbnail.h; empty where it holds none
  int thumbnail_frame = 0;
};

/// Every series under `folder` (recursively) or of the one file given, the recommended first. A DICOMDIR
/// stands for its folder. Files that are not DICOM are passed over. Throws Error when the path does not exist
/// or holds no DICOM at all.
std::vector<SeriesInfo> listSeries(const std::filesystem::path& folder, TaskMonitor& monitor);

/// Throws Error naming the file: missing slice, unequal spacing, mixed orientation, truncated pixel data, ...
volume::Volume loadSeries(const SeriesInfo& series, TaskMonitor& monitor);

/// Anonymous tags of a series to be written (the virtual patient, exports).
struct SeriesTags {
  std::string patient_id = "FaceNav-Virtual", patient_name = "Virtual^Patient", description = "T1";
  std::string study_date = "20200101";
};
/// One file a slice, 16-bit MR Image Storage, axis order and obliquity of the volume kept. Values are
/// rounded. Deterministic UIDs derived from the tags. `folder` must be empty or absent.
void writeSeries(const volume::Volume& volume, const std::filesystem::path& folder, const SeriesTags& tags);

}  // namespace facenav::dicom
