#pragma once
// The object types that FaceNav receives and sends, and the transfer syntaxes it reads.

#include <string>
#include <vector>

namespace facenav::pacs {

/// SOP class UIDs: MR and CT images, classic, enhanced and converted.
const std::vector<std::string>& imageClasses();
/// All transfer syntaxes that the importer reads. An offer with a single syntax preserves the archive's own
/// compression.
const std::vector<std::string>& imageSyntaxes();
/// Sets of transfer syntaxes to offer, one after the other until the archive can send: those in which it says
/// that it holds the images, if any; all; the compressed ones; each of these alone. An archive that cannot
/// decompress fails if it takes a plain form because that was offered, too.
std::vector<std::vector<std::string>> syntaxesToTry(const std::vector<std::string>& held);

}  // namespace facenav::pacs
