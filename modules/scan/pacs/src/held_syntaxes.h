#pragma once
// The compression in which an archive holds a series. Many archives send images as they hold them and choose
// the first form that was offered for an object, so that form must be offered first.

#include <string>
#include <vector>

#include "facenav/pacs/pacs.h"

namespace facenav::pacs {

/// Asks for the Available Transfer Syntax UID (PS3.4 C.4.1.1.3.2) of the series' images. Empty if the archive
/// does not say, or names none that the importer reads. Throws Error if the archive cannot be reached.
std::vector<std::string> heldSyntaxes(const PacsNode& node, const std::string& study_uid,
                                      const std::string& series_uid, TaskMonitor& monitor);

}  // namespace facenav::pacs
