#pragma once
// Values of DICOM elements read with every length checked: GDCM's own Attribute<> trusts the file.
// Texts come back as clean UTF-8 on one line.

#include <gdcmDataSet.h>
#include <gdcmTag.h>

#include <optional>
#include <string>
#include <vector>

namespace facenav::dicom {

/// Trimmed, control characters removed, from the data set's own character set. Empty where absent.
std::string text(const gdcm::DataSet& data, gdcm::Tag tag);
/// The first group of a PN that holds anything: the alphabetic, else the ideographic, else the phonetic one
/// (PS3.5 6.2.1); its components separated by ^.
std::string personName(const gdcm::DataSet& data, gdcm::Tag tag);
/// All numbers of a DS, IS, US, SS, UL, SL, FL or FD element; not finite ones and malformed text give an
/// empty list.
std::vector<double> numbers(const gdcm::DataSet& data, gdcm::Tag tag);
std::optional<double> number(const gdcm::DataSet& data, gdcm::Tag tag);
/// The number as an int, `otherwise` where absent or out of range.
int integer(const gdcm::DataSet& data, gdcm::Tag tag, int otherwise);
/// The data sets of a sequence's items; empty where it is absent. Copies share their values.
std::vector<gdcm::DataSet> items(const gdcm::DataSet& data, gdcm::Tag tag);
/// The first of them.
std::optional<gdcm::DataSet> item(const gdcm::DataSet& data, gdcm::Tag tag);

}  // namespace facenav::dicom
