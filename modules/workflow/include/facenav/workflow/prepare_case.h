#pragma once
// PREPARE: the first step of the data flow, as the verb, the window and the demo run it: MRI -> case folder.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/workflow/registrations.h"

namespace facenav::workflow {

struct PrepareRequest {
  std::filesystem::path input, case_folder;
  std::optional<std::string> series_uid;
  std::string head_segmenter, brain_segmenter;  // registered names
  std::string nifti_transform = "automatic";    // or "sform", "qform"
  bool replace = false;
  bool discard_edits = false;  // with replace: also a case whose brain mask was corrected by hand
  std::string label = {};      // what people call the case; empty: none, or the replaced case's
  bool is_labelled_by_patient =
      false;  // by the name in the DICOM files, else the Patient ID, else not at all
};
struct PrepareOutcome {
  casefile::CaseStore store;
  std::vector<std::string> description, findings;  // plain words for the radiographer
  std::optional<double> brain_ml;
  std::optional<surface::NavigationCheck> navigation_check;
};
/// INPUT -> case folder, whole or not at all. Throws Error.
PrepareOutcome prepareCase(const Registrations& methods, const PrepareRequest& request, TaskMonitor& monitor);

}  // namespace facenav::workflow
