#pragma once
// Folders and archives of other programs that hold several files: a data set of NIBS-BIDS, a session of
// NaviNIBS (folder or .navinibs), a session folder of Localite. Known by the files in them.

#include "facenav/interop/formats.h"
#include "file_set.h"

namespace facenav::interop {

/// Reads one session's folder or archive; a folder with one file of a known format is read as this file.
/// Throws Error with one line: none, several persons or sessions to choose from, damaged.
OtherFile readFileSet(const std::filesystem::path& path, const T1* t1);

/// A session of NaviNIBS: SessionConfig.json names the files of its parts.
bool isNavinibsSession(const FileSet& files);
OtherFile readNavinibsSession(const FileSet& files);

/// A session folder of Localite: of each kind of list the fullest one is read.
bool isLocaliteSession(const FileSet& files);
OtherFile readLocaliteSession(const FileSet& files);

}  // namespace facenav::interop
