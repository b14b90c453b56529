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

}  // namespace facenav::pacs
