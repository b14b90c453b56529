#pragma once
// Words that may leave this computer or stand in a report: the folders of the paths in them are taken out.
// The names of folders may be those of a patient or of a user. The last name of a path stays.

#include <string>

namespace facenav {
inline namespace core {

/// "in /home/doe/a.csv: damaged" becomes "in a.csv: damaged". Takes every path, and folders with blanks in an
/// absolute one. Words between relative paths of one clause go too. "3/10", "mm/s", dates and "/dev/video2"
/// stay.
std::string withoutFolders(const std::string& words);

}  // namespace core
}  // namespace facenav
