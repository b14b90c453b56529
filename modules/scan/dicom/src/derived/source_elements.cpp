#include "source_elements.h"

#include <array>
#include <ctime>
#include <random>

#include "facenav/core/error.h"
#include "facenav/core/software_version.h"
#include "header/patient_identity.h"
#include "header/put_values.h"
#include "header/tag_values.h"

namespace facenav::dicom {
namespace {

using gdcm::VR;

struct CopiedElement {
  gdcm::Tag tag;
  VR::VRType vr;
};

/// Copies the bytes of plain values, also of sources without VRs.
template <class Elements>
void copyElements(const gdcm::DataSet& from, const Elements& elements, gdcm::DataSet& to) {
  for (const CopiedElement& element : elements) {
    if (!from.FindDataElement(element.tag)) continue;
    const gdcm::ByteValue* value = from.GetDataElement(element.tag).GetByteValue();
    put(to, element.tag, element.vr,
        value && value->GetPointer() ? std::string(value->GetPointer(), value->GetLength()) : std::string());
  }
}

void putUnlessThere(gdcm::DataSet& to, gdcm::Tag tag, VR::VRType vr, const char* value) {
  if (!to.FindDataElement(tag)) put(to, tag, vr, value);
}

std::string nowAs(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::localtime_r(&now, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, format, &parts)};
}

}  // namespace

std::string newUid() {
  std::random_device random;
  std::array<std::uint32_t, 4> words;
  for (auto& word : words) word = random();
  words[1] = (words[1] & 0xFFFF0FFFu) | 0x00004000u;  // version 4
  words[2] = (words[2] & 0x3FFFFFFFu) | 0x80000000u;  // variant
  std::string digits;
  for (bool is_zero = false; !is_zero;) {  // long division by ten
    std::uint64_t rest = 0;
    is_zero = true;
    for (auto& word : words) {
      const std::uint64_t value = rest << 32 | word;
      word = std::uint32_t(value / 10);
      rest = value % 10;
      is_zero = is_zero && word == 0;
    }
    digits.insert(digits.begin(), char('0' + rest));
  }
  return "2.25." + digits;
}

void requireOneIdentity(const std::vector<SliceHeader>& source) {
  constexpr const char* kRemedy = "give the series as the archive sent it";
  for (const SliceHeader& header : source) {
    const std::string file = header.file.string();
    if (header.patient.name.empty() && header.patient.id.empty())
      throw Error("names no patient, so that an archive could not file what is made from it", file, kRemedy);
    if (!isSamePatient(header.patient, source.front().patient))
      throw Error("the images of the series name several patients", file, kRemedy);
    if (header.study_uid.empty()) throw Error("names no study (0020,000D)", file, kRemedy);
  }
}

void copyPatientAndStudy(const gdcm::DataSet& from, const SeriesInfo& series, gdcm::DataSet& to) {
  static const CopiedElement kCopied[] = {
      {{0x0008, 0x0005}, VR::CS}, {{0x0008, 0x0020}, VR::DA}, {{0x0008, 0x0030}, VR::TM},
      {{0x0008, 0x0050}, VR::SH}, {{0x0008, 0x0090}, VR::PN}, {{0x0008, 0x1030}, VR::LO},
      {{0x0010, 0x0010}, VR::PN}, {{0x0010, 0x0020}, VR::LO}, {{0x0010, 0x0021}, VR::LO},
      {{0x0010, 0x0030}, VR::DA}, {{0x0010, 0x0032}, VR::TM}, {{0x0010, 0x0040}, VR::CS},
      {{0x0010, 0x1000}, VR::LO}, {{0x0010, 0x1001}, VR::PN}, {{0x0010, 0x1010}, VR::AS},
      {{0x0010, 0x1020}, VR::DS}, {{0x0010, 0x1030}, VR::DS}, {{0x0012, 0x0062}, VR::CS},
      {{0x0012, 0x0063}, VR::LO}, {{0x0020, 0x000D}, VR::UI}, {{0x0020, 0x0010}, VR::SH}};
  copyElements(from, kCopied, to);
  constexpr std::size_t kAge = 4;  // "042Y"; archives refuse another form, which some anonymisers write
  if (text(to, {0x0010, 0x1010}).size() != kAge) to.Remove({0x0010, 0x1010});
  if (series.joined) put(to, {0x0020, 0x000D}, VR::UI, series.joined->study_uid);
  for (const CopiedElement& needed : std::initializer_list<CopiedElement>{{{0x0008, 0x0020}, VR::DA},
                                                                          {{0x0008, 0x0030}, VR::TM},
                                                                          {{0x0008, 0x0050}, VR::SH},
                                                                          {{0x0008, 0x0090}, VR::PN},
                                                                          {{0x0010, 0x0010}, VR::PN},
                                                                          {{0x0010, 0x0020}, VR::LO},
                                                                          {{0x0010, 0x0030}, VR::DA},
                                                                          {{0x0010, 0x0040}, VR::CS},
                                                                          {{0x0020, 0x0010}, VR::SH}})
    putUnlessThere(to, needed.tag, needed.vr, "");  // type 2: may be empty, not absent
}

void copyMeasurement(const gdcm::DataSet& from, gdcm::DataSet& to) {
  static const CopiedElement kCopied[] = {
      {{0x0008, 0x0022}, VR::DA}, {{0x0008, 0x0032}, VR::TM}, {{0x0018, 0x0010}, VR::LO},
      {{0x0018, 0x0015}, VR::CS}, {{0x0018, 0x0020}, VR::CS}, {{0x0018, 0x0021}, VR::CS},
      {{0x0018, 0x0022}, VR::CS}, {{0x0018, 0x0023}, VR::CS}, {{0x0018, 0x0024}, VR::SH},
      {{0x0018, 0x0025}, VR::CS}, {{0x0018, 0x0080}, VR::DS}, {{0x0018, 0x0081}, VR::DS},
      {{0x0018, 0x0082}, VR::DS}, {{0x0018, 0x0083}, VR::DS}, {{0x0018, 0x0084}, VR::DS},
      {{0x0018, 0x0085}, VR::SH}, {{0x0018, 0x0087}, VR::DS}, {{0x0018, 0x0091}, VR::IS},
      {{0x0018, 0x1030}, VR::LO}, {{0x0018, 0x1314}, VR::DS}, {{0x0018, 0x5100}, VR::CS},
      {{0x0020, 0x0012}, VR::IS}, {{0x0020, 0x1040}, VR::LO}, {{0x0028, 0x2110}, VR::CS},
      {{0x0028, 0x2112}, VR::DS}, {{0x0028, 0x2114}, VR::CS}};
  copyElements(from, kCopied, to);
  putUnlessThere(to, {0x0018, 0x0015}, VR::CS, "HEAD");
  putUnlessThere(to, {0x0018, 0x0020}, VR::CS, "RM");  // an enhanced file states it elsewhere
  putUnlessThere(to, {0x0018, 0x0021}, VR::CS, "NONE");
  putUnlessThere(to, {0x0018, 0x0022}, VR::CS, "");
  putUnlessThere(to, {0x0018, 0x0023}, VR::CS, "");
  putUnlessThere(to, {0x0018, 0x0080}, VR::DS, "");
  putUnlessThere(to, {0x0018, 0x0081}, VR::DS, "");
  putUnlessThere(to, {0x0018, 0x0091}, VR::IS, "");
  putUnlessThere(to, {0x0018, 0x5100}, VR::CS, "");
  putUnlessThere(to, {0x0020, 0x1040}, VR::LO, "");
}

void putOwnIdentity(gdcm::DataSet& to, const char* sop_class, const std::string& series_uid,
                    const char* modality, int series_number) {
  put(to, {0x0008, 0x0016}, VR::UI, sop_class);
  put(to, {0x0008, 0x0018}, VR::UI, newUid());
  const std::string date = nowAs("%Y%m%d"), time = nowAs("%H%M%S");
  for (const std::uint16_t element : {0x0012, 0x0021, 0x0023}) put(to, {0x0008, element}, VR::DA, date);
  for (const std::uint16_t element : {0x0013, 0x0031, 0x0033}) put(to, {0x0008, element}, VR::TM, time);
  put(to, {0x0008, 0x0060}, VR::CS, modality);
  put(to, {0x0008, 0x0070}, VR::LO, "FaceNav");
  put(to, {0x0008, 0x1090}, VR::LO, "FaceNav");
  put(to, {0x0018, 0x1020}, VR::LO, softwareVersion().substr(0, 64));
  put(to, {0x0020, 0x000E}, VR::UI, series_uid);
  put(to, {0x0020, 0x0011}, VR::IS, std::to_string(series_number));
  put(to, {0x0028, 0x0301}, VR::CS, "YES");  // Burned In Annotation
}

void putSourceImage(gdcm::DataSet& to, const SliceHeader& source, int frame) {
  put(to, {0x0008, 0x1150}, VR::UI, source.sop_class);
  put(to, {0x0008, 0x1155}, VR::UI, source.sop_instance);
  if (source.images.size() > 1) put(to, {0x0008, 0x1160}, VR::IS, std::to_string(frame + 1));
  putCode(to, {0x0040, 0xA170}, "121322", "DCM", "Source image for image processing operation");
}

std::string frameOfReferenceOf(const gdcm::DataSet& from, const SeriesInfo& series) {
  if (series.joined && !series.joined->frame_of_reference_uid.empty())
    return series.joined->frame_of_reference_uid;
  return text(from, {0x0020, 0x0052});
}

std::string textFor(const gdcm::DataSet& data, const std::string& text, std::size_t most) {
  const bool is_utf8 = dicom::text(data, {0x0008, 0x0005}).find("ISO_IR 192") != std::string::npos;
  std::string written;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size() && count < most; ++count) {
    std::size_t end = at + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
    const auto first = static_cast<unsigned char>(text[at]);
    if (first >= 0x80)
      written += is_utf8 ? text.substr(at, end - at) : "?";
    else
      written += first < 0x20 || first == 0x7F ? ' ' : first == '\\' ? '/' : char(first);
    at = end;
  }
  return written;
}

}  // namespace facenav::dicom
