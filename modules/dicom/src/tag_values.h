#pragma once
// Values of DICOM elements read with every length checked: GDCM's own Attribute<> trusts the file.
// Texts come back as clean UTF-8 on one line.

#include <gdcmDataSet.h>
#include <gdcmTag.h>

#include <optional>
#include <string>
#include <vector>

namespace facenav::dicom {

/// Trimmed, control characters removed, Latin-1 taken for anything that is not UTF-8. Empty where absent.
std::string text(const gdcm::DataSet& data, gdcm::Tag tag);
/// All numbers of a DS, IS, US, SS, UL, SL, FL or FD element; not finite ones and malformed text give an
/// empty list.
std::vector<double> numbers(const gdcm::DataSet& data, gdcm::Tag tag);
std::optional<double> number(const gdcm::DataSet& data, gdcm::Tag tag);
/// The number as an int, `otherwise` where absent or out of range.
int integer(const gdcm::DataSet& data, gdcm::Tag tag, int otherwise);
/// Number of items of a sequence, 0 where absent.
std::size_t itemCount(const gdcm::DataSet& data, gdcm::Tag tag);
/// The data set of item `index` (from 0) of a sequence; null where there is none.
const gdcm::DataSet* item(const gdcm::DataSet& data, gdcm::Tag tag, std::size_t index = 0);

}  // namespace facenav::dicom
