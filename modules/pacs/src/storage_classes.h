#pragma once
// The kinds of objects FaceNav takes and sends, and the transfer syntaxes it reads.

#include <string>
#include <vector>

namespace facenav::pacs {

/// SOP class UIDs: MR and CT images, classic, enhanced and converted.
const std::vector<std::string>& imageClasses();
/// Every syntax that the importer reads; one an offer keeps the archive's own compression.
const std::vector<std::string>& imageSyntaxes();

}  // namespace facenav::pacs
