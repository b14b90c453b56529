#pragma once
// Texts of a DICOM file or of an archive's answer as UTF-8: Specific Character Set (0008,0005), PS3.3
// C.12.1.1.2 and PS3.5 6.1.

#include <string>
#include <string_view>

namespace facenav::dicom {

/// Converts text to UTF-8. `character_set` as in the file, its values separated by backslashes. Known are
/// single-byte sets, GB18030, GBK and UTF-8, and with escape sequences Japanese, Korean and GB2312. Unknown
/// or invalid text counts as UTF-8 if it is valid UTF-8, otherwise as Latin-1.
std::string toUtf8(std::string_view raw, std::string_view character_set);

/// A person's name (VR PN) in UTF-8, without control characters: its alphabetic group, or the next one that
/// is there.
std::string personNameToUtf8(std::string_view raw, std::string_view character_set);
/// `text` with blanks for control characters, so that it stays on one line.
std::string onOneLine(std::string text);

}  // namespace facenav::dicom
