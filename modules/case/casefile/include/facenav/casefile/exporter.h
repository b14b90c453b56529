#pragma once
// Exporter: writes a case's content as files for other programs (planning, printing, neuroimaging). Plug-in
// interface; app registers the implementations by name. Everything is in Mri (RAS mm) and written whole,
// 0600.

#include <filesystem>
#include <memory>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/surface/mesh_files.h"

namespace facenav::casefile {

class Exporter {
 public:
  virtual ~Exporter() = default;
  /// Writes into `folder` (created with 0700 if absent) and returns the files written. Throws Error if a file
  /// exists and `replace` is false, or if the case has nothing of the kind.
  virtual std::vector<std::filesystem::path> write(const CaseStore& store,
                                                   const std::filesystem::path& folder, bool replace,
                                                   TaskMonitor& monitor) const = 0;
};

/// Exports scalp, brain (the phi-theta model) and cortex (iso-surface of the brain mask), if the case has
/// them.
std::unique_ptr<Exporter> makeMeshExporter(surface::MeshFormat format);
/// Exports mri.nii.gz, head_mask.nii.gz and, if present, brain_mask.nii.gz.
std::unique_ptr<Exporter> makeNiftiExporter();

}  // namespace facenav::casefile
