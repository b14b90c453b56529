#pragma once
// MEPs from an XDF recording: for each marker of a pulse, the EMG's peak to peak in a window after it.

#include "facenav/review/mep_import.h"

namespace facenav::steps {

/// Reads the recording. Times are those of FaceNav's own markers (utc) where it has them, else the recorder's
/// clock. Throws Error as readMepFile.
MepFile readXdfMeps(const std::filesystem::path& path, const XdfChoice& choice,
                    const MepImportLimits& limits);

}  // namespace facenav::steps
