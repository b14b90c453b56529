#pragma once
// DICOM series on disk -> Volume (through GDCM). The volume is built from Image Position and Orientation
// (Patient) (PS3.3 C.7.6.2), never from file names or slice location alone; rescale applied; LPS flipped to
// RAS here only. Voxel values and world positions equal dcm2niix's, except MONOCHROME1: its bright and dark
// are exchanged, so that air is dark.

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/dicom/image_kind.h"
#include "facenav/dicom/joined_slices.h"
#include "facenav/volume/volume.h"

namespace facenav::dicom {

/// Reason why a series gives no volume, for code; `SeriesInfo::problem` is the text for users.
enum class SeriesProblem {
  none,
  no_volume,   // another kind of object, a localizer, an unsupported modality
  unreadable,  // unsupported voxels or compression
  damaged,     // cut off, slices missing
  geometry,    // positions that form no regular stack
  single_slice,
  several_volumes,  // several at one place
  too_large,
};
/// Id for other programs: "damaged", "single_slice", ..; stays the same when the texts change. Empty for
/// none.
const char* idOf(SeriesProblem problem);

/// One volume of a series, or a series without a loadable volume. A series whose UID covers several volumes
/// (echoes, magnitude and phase, stacks) gives one entry each, distinguished by `part`.
struct SeriesInfo {
  std::string series_uid, study_uid;
  std::string id;                           // value for --series: the UID, with "#2", "#3" for further parts
  std::string description, modality, date;  // date as YYYY-MM-DD or empty; never the patient's name
  std::string part;                         // "echo 4.92 ms", "phase", ..; empty if the UID has one volume
  std::optional<JoinedSlices> joined;       // the slices carry different UIDs and were joined
  bool is_magnitude_part = false;           // the other parts of the UID show that this one is magnitude
  bool has_contrast_agent = false;
  ImageKind kind = ImageKind::magnitude;  // magnitude, phase, map, .., by header and values
  std::string contrast;  // "T1", "T2", "FLAIR", "diffusion", .., "phase image", "T1 map"; empty: unknown
  int series_number = 0;
  std::optional<int> patient;  // 1, 2, .. among the series listed together; see patient.h
  int rows = 0, columns = 0, slices = 0;
  Eigen::Vector3d spacing_mm = Eigen::Vector3d::Zero();  // column, row, slice
  Eigen::Vector3d extent_mm = Eigen::Vector3d::Zero();   // along right, anterior, superior
  std::string plane;  // "axial", "coronal", "sagittal", "axial oblique", ...
  std::vector<std::filesystem::path> files;
  std::vector<std::vector<int>>
      frames;  // per file the frames of this volume; empty: every frame of every file
  bool is_loadable = false;
  SeriesProblem problem_kind = SeriesProblem::none;
  std::string problem;                 // reason as text, if !is_loadable
  std::filesystem::path problem_file;  // the file with the fault, if there is one
  std::vector<std::string> notes;      // duplicates dropped, lossy compression, CT gives the scalp only, ..
  int stated_images = 0, missing_images = 0;  // images that the headers speak of; those not in the folder
  bool is_fit_for_navigation = false;  // by its headers: a T1 of the whole head, voxels of at most 1.2 mm
  std::string fitness;  // that it is, and that the face is judged later; or the reasons against
  // The best T1 for navigation in the list. None if the list has several patients, or if that T1 is one of
  // several readings of the same slices.
  bool is_recommended = false;
  std::filesystem::path thumbnail_file;  // file of the middle image, for thumbnail.h; empty: no image
  int thumbnail_frame = 0;
};

/// Lists every series under `folder` (recursively) or of the one given file, the recommended one first. A
/// DICOMDIR means its folder. Files other than DICOM are skipped. Throws Error when the path does not exist
/// or contains no DICOM.
std::vector<SeriesInfo> listSeries(const std::filesystem::path& folder, TaskMonitor& monitor);

/// Loads the volume. Throws Error naming the file: missing slice, unequal spacing, mixed orientation,
/// truncated pixel data, ...
volume::Volume loadSeries(const SeriesInfo& series, TaskMonitor& monitor);

/// Anonymous tags of a series to be written (the virtual patient, exports).
struct SeriesTags {
  std::string patient_id = "FaceNav-Virtual", patient_name = "Virtual^Patient", description = "T1";
  std::string study_date = "20200101";
};
/// Writes one file a slice, 16-bit MR Image Storage, axis order and obliquity of the volume kept. Values are
/// rounded. Deterministic UIDs derived from the tags. `folder` must be empty or absent.
void writeSeries(const volume::Volume& volume, const std::filesystem::path& folder, const SeriesTags& tags);

}  // namespace facenav::dicom
