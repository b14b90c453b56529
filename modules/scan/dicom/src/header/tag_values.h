#pragma once
// Values of DICOM elements, with every length checked: GDCM's own Attribute<> trusts the file. Texts are
// returned as clean UTF-8 on one line.

#include <gdcmDataSet.h>
#include <gdcmTag.h>

#include <optional>
#include <string>
#include <vector>

namespace facenav::dicom {

/// Text of an element: trimmed, without control characters, converted from the data set's character set.
/// Empty if absent.
std::string text(const gdcm::DataSet& data, gdcm::Tag tag);
/// Name of a PN: its first non-empty group: alphabetic, then ideographic, then phonetic (PS3.5 6.2.1).
/// Components are separated by ^.
std::string personName(const gdcm::DataSet& data, gdcm::Tag tag);
/// All numbers of a DS, IS, US, SS, UL, SL, FL or FD element. Empty for malformed text or a non-finite
/// number.
std::vector<double> numbers(const gdcm::DataSet& data, gdcm::Tag tag);
std::optional<double> number(const gdcm::DataSet& data, gdcm::Tag tag);
/// The number as an int; `otherwise` if absent or out of range.
int integer(const gdcm::DataSet& data, gdcm::Tag tag, int otherwise);
/// The data sets of a sequence's items; empty if absent. Copies share their values.
std::vector<gdcm::DataSet> items(const gdcm::DataSet& data, gdcm::Tag tag);
/// First item of a sequence; nullopt if absent.
std::optional<gdcm::DataSet> item(const gdcm::DataSet& data, gdcm::Tag tag);

}  // namespace facenav::dicom
