#pragma once
// Entry point for every MRI: reads a DICOM folder or file, or a NIfTI file, into a Volume. Reports what was
// chosen and where left and right come from. Used by `facenav prepare` and the Prepare workspace.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/dicom/series.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/volume.h"

namespace facenav::dicom {

struct ImportedVolume {
  volume::Volume volume;  // RAS mm
  std::vector<std::string>
      description;  // what was read, its left-right evidence; one line each, no patient name
  std::vector<std::string> warnings;  // what the user should know before using it
  std::optional<SeriesInfo> series;   // empty for NIfTI
};

/// Reads `input`: a folder (the recommended series, the only loadable one, or `series_id` as listSeries gives
/// it), one DICOM file (the series of its folder that it belongs to), or a NIfTI file. Throws Error:
/// nothing loadable (naming the reason), several candidates and none recommended, images of several patients
/// and no `series_id`, unknown id, damage.
/// `transform` chooses between a NIfTI's two maps.
ImportedVolume importVolume(const std::filesystem::path& input, const std::optional<std::string>& series_id,
                            TaskMonitor& monitor,
                            volume::NiftiTransform transform = volume::NiftiTransform::automatic);

}  // namespace facenav::dicom
