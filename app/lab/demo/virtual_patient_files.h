#pragma once
// The virtual patient's MRI as files: the brainbrowser T1 that facenav.sh fetched, converted once to NIfTI
// and to a DICOM series under the cache folder.

#include "context.h"

namespace facenav::app {

struct VirtualPatientFiles {
  std::filesystem::path nifti, dicom_folder;
};

/// Converts what is missing. If the fetched files are absent, throws an Error that says how to get them.
VirtualPatientFiles virtualPatientFiles(const Context& context);

}  // namespace facenav::app
