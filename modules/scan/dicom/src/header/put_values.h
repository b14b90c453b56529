#pragma once
// Puts values into a data set that is to be written, padded to even length (PS3.5 6.2).

#include <gdcmDataSet.h>
#include <gdcmTag.h>
#include <gdcmVR.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace facenav::dicom {

/// Decimal string of at most 16 characters (PS3.5 6.2), with the highest possible precision.
std::string decimal(double value);
/// Decimal strings with backslashes between them.
std::string decimals(std::initializer_list<double> values);

/// Puts text or bytes; replaces what is there.
void put(gdcm::DataSet& data, gdcm::Tag tag, gdcm::VR::VRType vr, std::string value);
/// Puts a US.
void put(gdcm::DataSet& data, gdcm::Tag tag, std::uint16_t value);
/// Puts a UL.
void putLong(gdcm::DataSet& data, gdcm::Tag tag, std::uint32_t value);
/// Puts a sequence with these items.
void putItems(gdcm::DataSet& data, gdcm::Tag tag, const std::vector<gdcm::DataSet>& items);
/// Puts a sequence of one coded entry (PS3.3 8.8).
void putCode(gdcm::DataSet& data, gdcm::Tag tag, const char* value, const char* scheme, const char* meaning);

/// Writes the data set as a file, explicit VR little endian. Throws Error.
void writeDataSet(const gdcm::DataSet& data, const std::string& path);

}  // namespace facenav::dicom
