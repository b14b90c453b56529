#pragma once
// PREPARE: the first step of the data flow, used by the verb, the window and the demo: MRI -> case folder.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/methods/registrations.h"

namespace facenav::steps {

struct PrepareRequest {
  std::filesystem::path input, case_folder;
  std::optional<std::string> series_uid;
  std::string head_segmenter, brain_segmenter;  // registered names
  std::string nifti_transform = "automatic";    // or "sform", "qform"
  bool replace = false;
  bool discard_edits = false;  // with replace: even if the brain mask was corrected by hand
  std::string label = {};      // label of the case; empty: none, or that of the replaced case
  bool is_labelled_by_patient =
      false;  // label is the name in the DICOM files, else the Patient ID, else none
};
struct PrepareOutcome {
  casefile::CaseStore store;
  std::vector<std::string> description, findings;  // in plain words for the radiographer
  std::optional<double> brain_ml;
  std::optional<surface::NavigationCheck> navigation_check;
};
/// Prepares INPUT and writes the case folder, whole or not at all. Throws Error.
PrepareOutcome prepareCase(const Registrations& methods, const PrepareRequest& request, TaskMonitor& monitor);

}  // namespace facenav::steps
