#pragma once
// SliceHeader: the plain values that FaceNav reads from one DICOM file: position of its image or images in
// the patient (PS3.3 C.7.6.2 for classic files, C.7.6.16 functional groups for enhanced ones), storage of its
// voxels, and attributes that distinguish the volumes of one series. LPS and mm, as in the file.

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bytes/file_layout.h"
#include "facenav/dicom/patient.h"

namespace gdcm {
class DataSet;
}

namespace facenav::dicom {

/// One image: the only one of a classic file, or one frame of an enhanced file.
struct ImagePlace {
  std::optional<Eigen::Vector3d> position_lps_mm;       // centre of the first voxel
  std::optional<Eigen::Matrix<double, 3, 2>> axes_lps;  // directions of increasing column and row index, unit
  std::optional<Eigen::Vector2d> spacing_mm;            // distance between columns, between rows
  double slope = 1.0, intercept = 0.0;
  double echo_time_ms = 0.0;
  std::string unreadable;  // names a value of the three above that is there and is no row of numbers
  std::string kind;        // image type: M, P, ORIGINAL\PRIMARY\..; separates magnitude from phase
  std::string stack;       // enhanced: Stack ID
  int time_index = 0;
};

struct VoxelFormat {
  int rows = 0, columns = 0, frames = 1, samples = 1;
  int bits_allocated = 16, bits_stored = 16, high_bit = 15;
  bool is_signed = false;
  bool has_embedded_overlay = false;  // retired: overlay bits above the stored ones
  std::string photometric;
};

struct SliceHeader {
  std::filesystem::path file;
  FileLayout layout;
  VoxelFormat voxels;
  std::vector<ImagePlace> images;
  std::string sop_class, sop_instance, series_uid, study_uid;
  std::string description, modality, date, image_type, manufacturer, sequence, contrast_agent,
      acquisition_kind;
  double slice_thickness_mm = 0, repetition_time_ms = 0, inversion_time_ms = 0, gantry_tilt_deg = 0;
  int series_number = 0, instance_number = 0;
  // Attributes that may separate scans where the UIDs do not (joined_slices.h):
  std::string frame_of_reference_uid, protocol, series_time, acquisition_time, age_and_weight;
  double flip_angle_deg = 0, slice_gap_mm = 0;  // the gap: Spacing Between Slices, centre to centre
  int acquisition_number = 0;
  int stated_images = 0;  // of the series, by the header; 0: not stated
  Patient patient;
  std::optional<int> patient_number;    // among the files scanned together; see patient_identity.h
  bool has_scattered_identity = false;  // each image of the series names another patient
  bool is_mosaic = false;
  bool is_annotated = false;  // derived, with Burned In Annotation
};

/// Reads the elements before the pixel data, of any DICOM file. Throws Error when it is damaged.
gdcm::DataSet readElements(FilePrefix& file);

/// Reads the header. Throws Error naming the file when it is damaged; std::nullopt when it is not DICOM.
std::optional<SliceHeader> readSliceHeader(FilePrefix& file);

/// Positions of an enhanced file's frames. `classic` holds the top-level values, used where a functional
/// group lacks them.
std::vector<ImagePlace> framePlaces(const gdcm::DataSet& data, const ImagePlace& classic, int frames);

/// Fills the values present in `data` (top level or a functional group's item).
void readPosition(const gdcm::DataSet& data, ImagePlace& place);
void readOrientation(const gdcm::DataSet& data, ImagePlace& place);
void readSpacing(const gdcm::DataSet& data, ImagePlace& place);
void readRescale(const gdcm::DataSet& data, ImagePlace& place);

}  // namespace facenav::dicom
