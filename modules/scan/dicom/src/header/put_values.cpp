#include "put_values.h"

#include <gdcmFile.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmWriter.h>

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::dicom {

std::string decimal(double value) {
  if (std::abs(value) < 1e-12) value = 0;
  std::string text;
  for (int digits = 15; digits > 0; --digits)
    if (text = formatted("%.*g", digits, value); text.size() <= 16) break;
  return text;
}

std::string decimals(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : "\\") + decimal(value);
  return text;
}

void put(gdcm::DataSet& data, gdcm::Tag tag, gdcm::VR::VRType vr, std::string value) {
  const bool is_padded_by_zero = vr == gdcm::VR::UI || vr == gdcm::VR::OB;
  if (value.size() % 2) value += is_padded_by_zero ? '\0' : ' ';
  gdcm::DataElement element(tag, 0, vr);
  element.SetByteValue(value.data(), std::uint32_t(value.size()));
  data.Replace(element);
}

void put(gdcm::DataSet& data, gdcm::Tag tag, std::uint16_t value) {
  put(data, tag, gdcm::VR::US, std::string(reinterpret_cast<const char*>(&value), 2));
}

void putLong(gdcm::DataSet& data, gdcm::Tag tag, std::uint32_t value) {
  put(data, tag, gdcm::VR::UL, std::string(reinterpret_cast<const char*>(&value), 4));
}

void putItems(gdcm::DataSet& data, gdcm::Tag tag, const std::vector<gdcm::DataSet>& items) {
  gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = new gdcm::SequenceOfItems;
  sequence->SetLengthToUndefined();
  for (const gdcm::DataSet& content : items) {
    gdcm::Item item;
    item.SetVLToUndefined();
    item.SetNestedDataSet(content);
    sequence->AddItem(item);
  }
  gdcm::DataElement element(tag);
  element.SetVR(gdcm::VR::SQ);
  element.SetValue(*sequence);
  element.SetVLToUndefined();
  data.Replace(element);
}

void putCode(gdcm::DataSet& data, gdcm::Tag tag, const char* value, const char* scheme, const char* meaning) {
  gdcm::DataSet code;
  put(code, {0x0008, 0x0100}, gdcm::VR::SH, value);
  put(code, {0x0008, 0x0102}, gdcm::VR::SH, scheme);
  put(code, {0x0008, 0x0104}, gdcm::VR::LO, meaning);
  putItems(data, tag, {code});
}

void writeDataSet(const gdcm::DataSet& data, const std::string& path) {
  gdcm::Writer writer;
  writer.GetFile().SetDataSet(data);
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  writer.SetFileName(path.c_str());
  if (!writer.Write()) throw Error("cannot be written", path, "check free disk space and permissions");
}

}  // namespace facenav::dicom
