#pragma once
// Objects for the archive that are made from a patient's series: a copy of its images with something drawn
// into them, segments on them, and a document. They belong to the patient, the study and (images) the frame
// of reference of the source, whose files must be at hand: a case holds no identity. UIDs are new ones
// under 2.25 (PS3.5 B.2). Sources: PS3.3 A.4 and C.8.3.1 (MR Image), A.51 and C.8.20 (Segmentation), A.45.1
// and C.24.2 (Encapsulated PDF), C.7.6.1 (General Image).

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/dicom/series.h"

namespace facenav::dicom {

/// Words and grey values of a derived series. Characters that the source's character set may lack are written
/// as '?'.
struct DerivedSeries {
  std::string description;     // Series Description; its first 64 characters are written
  std::string derivation;      // Derivation Description: what was done to the images
  float black = 0, white = 1;  // values that a viewer shows at first as black and as white
};

/// Writes `drawn` as an MR series derived from `source`, one file an image. Position, orientation and spacing
/// are written as the source's files state them. `drawn` must have the grid of loadSeries(source). Values are
/// kept where they are whole numbers of 16 bits, otherwise they are scaled to 0..4095. Returns the number of
/// files. Throws Error: the source is no MR, names no patient or several, its files changed; `folder` is not
/// empty (unless `replaces`).
int writeDerivedSeries(const SeriesInfo& source, const volume::Volume& drawn, const DerivedSeries& words,
                       const std::filesystem::path& folder, bool replaces, TaskMonitor& monitor);

/// A region on the source's grid.
struct Segment {
  std::string label;  // its first 64 characters are written
  volume::Mask mask;
  bool is_device = false;  // a thing (the coil), not a place in the head
};

/// Writes the segments as a Segmentation object that refers to the source's images, completely or not at all.
/// Throws Error as writeDerivedSeries does (a CT is a source, too), and for a segment without a voxel.
void writeSegmentation(const SeriesInfo& source, const std::vector<Segment>& segments,
                       const std::string& description, const std::filesystem::path& file,
                       TaskMonitor& monitor);

/// Writes a PDF as an Encapsulated PDF object of the source's patient and study, completely or not at all.
/// Throws Error: `pdf` is no PDF; the source names no patient or several.
void writeEncapsulatedPdf(const SeriesInfo& source, const std::string& pdf, const std::string& title,
                          const std::filesystem::path& file);

}  // namespace facenav::dicom
