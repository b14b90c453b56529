#pragma once
// Removes the folders of paths from text that leaves this computer or appears in a report. A folder's name
// may be that of a patient or a user. The last name of a path stays.

#include <string>

namespace facenav {
inline namespace core {

/// Removes the folders: "in /home/doe/a.csv: damaged" becomes "in a.csv: damaged". Takes every path, and
/// folders with blanks in an absolute one. Words between relative paths of one clause are removed too.
/// "3/10", "mm/s", dates and "/dev/video2" stay.
std::string withoutFolders(const std::string& words);

}  // namespace core
}  // namespace facenav
