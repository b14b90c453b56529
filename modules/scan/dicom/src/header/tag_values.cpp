#include "tag_values.h"

#include <gdcmSequenceOfItems.h>

#include <charconv>
#include <cmath>
#include <cstring>

#include "facenav/dicom/character_set.h"

namespace facenav::dicom {
namespace {

std::string_view rawValue(const gdcm::DataSet& data, gdcm::Tag tag) {
  if (!data.FindDataElement(tag)) return {};
  const gdcm::ByteValue* value = data.GetDataElement(tag).GetByteValue();
  if (!value || !value->GetPointer()) return {};
  return {value->GetPointer(), std::size_t(value->GetLength())};
}

std::string_view trimmed(std::string_view s) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\0' || c == '\t' || c == '\r' || c == '\n'; };
  while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
  while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
  return s;
}

std::vector<double> parseTexts(std::string_view s) {
  std::vector<double> values;
  while (true) {
    const std::size_t end = std::min(s.find('\\'), s.size());
    std::string_view one = trimmed(s.substr(0, end));
    if (!one.empty() && one.front() == '+') one.remove_prefix(1);
    double value = 0;
    const auto [stop, error] = std::from_chars(one.data(), one.data() + one.size(), value);
    if (error != std::errc() || stop != one.data() + one.size() || !std::isfinite(value)) return {};
    values.push_back(value);
    if (end == s.size()) return values;
    s.remove_prefix(end + 1);
  }
}

template <class T>
std::vector<double> parseBinary(std::string_view s) {
  std::vector<double> values;
  for (std::size_t i = 0; i + sizeof(T) <= s.size(); i += sizeof(T)) {
    T value;  // GDCM has converted big endian files to the host's order
    std::memcpy(&value, s.data() + i, sizeof(T));
    if (!std::isfinite(double(value))) return {};
    values.push_back(double(value));
  }
  return values;
}

/// VR of an element without one (implicit little endian), for the binary elements that FaceNav reads (PS3.6).
gdcm::VR implicitVr(gdcm::Tag tag) {
  if (tag.GetGroup() == 0x0028 && tag.GetElement() < 0x0110 && tag.GetElement() != 0x0008 &&
      tag.GetElement() != 0x0030 && tag.GetElement() != 0x0004)
    return gdcm::VR::US;
  if (tag == gdcm::Tag(0x2005, 0x100E)) return gdcm::VR::FL;
  if (tag == gdcm::Tag(0x0018, 0x9082) || tag == gdcm::Tag(0x0018, 0x9087)) return gdcm::VR::FD;
  if (tag == gdcm::Tag(0x0020, 0x9128) || tag == gdcm::Tag(0x0020, 0x9057)) return gdcm::VR::UL;
  if (tag.GetGroup() == 0x6000 && tag.GetElement() == 0x0102) return gdcm::VR::US;
  return gdcm::VR::DS;
}

const gdcm::Tag kCharacterSet(0x0008, 0x0005);

}  // namespace

std::string text(const gdcm::DataSet& data, gdcm::Tag tag) {
  return onOneLine(toUtf8(trimmed(rawValue(data, tag)), rawValue(data, kCharacterSet)));
}

std::string personName(const gdcm::DataSet& data, gdcm::Tag tag) {
  return personNameToUtf8(trimmed(rawValue(data, tag)), rawValue(data, kCharacterSet));
}

std::vector<double> numbers(const gdcm::DataSet& data, gdcm::Tag tag) {
  const std::string_view raw = rawValue(data, tag);
  if (raw.empty()) return {};
  gdcm::VR vr = data.GetDataElement(tag).GetVR();
  if (vr == gdcm::VR::INVALID || vr == gdcm::VR::UN) vr = implicitVr(tag);
  switch (vr) {
    case gdcm::VR::US:
      return parseBinary<std::uint16_t>(raw);
    case gdcm::VR::SS:
      return parseBinary<std::int16_t>(raw);
    case gdcm::VR::UL:
      return parseBinary<std::uint32_t>(raw);
    case gdcm::VR::SL:
      return parseBinary<std::int32_t>(raw);
    case gdcm::VR::FL:
      return parseBinary<float>(raw);
    case gdcm::VR::FD:
      return parseBinary<double>(raw);
    default:
      return trimmed(raw).empty() ? std::vector<double>{} : parseTexts(raw);
  }
}

std::optional<double> number(const gdcm::DataSet& data, gdcm::Tag tag) {
  const auto values = numbers(data, tag);
  return values.empty() ? std::nullopt : std::optional<double>(values.front());
}

int integer(const gdcm::DataSet& data, gdcm::Tag tag, int otherwise) {
  const auto value = number(data, tag);
  return value && std::abs(*value) < 2e9 ? int(*value) : otherwise;
}

std::vector<gdcm::DataSet> items(const gdcm::DataSet& data, gdcm::Tag tag) {
  std::vector<gdcm::DataSet> found;
  if (!data.FindDataElement(tag) || data.GetDataElement(tag).IsEmpty()) return found;
  const gdcm::DataElement& element = data.GetDataElement(tag);
  gdcm::SmartPointer<gdcm::SequenceOfItems> sequence;
  if (dynamic_cast<const gdcm::SequenceOfItems*>(&element.GetValue()) || element.GetVR() == gdcm::VR::INVALID)
    try {
      // Implicit VR: GDCM keeps a sequence of known length as bytes. The walk of the lengths has checked
      // these. The bytes of a UN element were not checked, so they are not opened.
      sequence = element.GetValueAsSQ();
    } catch (const std::exception&) {
      return found;
    }
  for (std::size_t i = 1; sequence && i <= sequence->GetNumberOfItems(); ++i)
    found.push_back(sequence->GetItem(i).GetNestedDataSet());
  return found;
}

std::optional<gdcm::DataSet> item(const gdcm::DataSet& data, gdcm::Tag tag) {
  const auto all = items(data, tag);
  return all.empty() ? std::nullopt : std::optional<gdcm::DataSet>(all.front());
}

}  // namespace facenav::dicom
