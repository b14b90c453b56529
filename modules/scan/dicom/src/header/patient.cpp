#include "facenav/dicom/patient.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "facenav/core/error.h"
#include "patient_identity.h"
#include "series/series_scan.h"

namespace facenav::dicom {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  for (std::size_t end = 0; end != std::string::npos; start = end + 1) {
    end = text.find(separator, start);
    parts.push_back(text.substr(start, end == std::string::npos ? end : end - start));
  }
  return parts;
}

std::string withoutBlanksAround(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Name without differences of capitals and trailing separators, which vary between systems of one hospital.
std::string comparableName(const std::string& name) {
  std::string text = name;
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return c == '^' || c == ',' ? ' ' : c < 0x80 ? char(std::tolower(c)) : char(c);
  });
  std::string words;
  for (const std::string& word : split(text, ' '))
    if (!word.empty()) words += (words.empty() ? "" : " ") + word;
  return words;
}

std::string identityOf(const Patient& patient) {
  return patient.id + "\n" + comparableName(patient.name) + "\n" + patient.birth_date;
}

/// Finds series whose images each name a patient who has that one image.
void markScatteredIdentities(std::vector<SliceHeader>& headers) {
  constexpr std::size_t kFewest = 10;  // images; two persons' single images are two persons
  std::map<std::string, std::size_t> images_of;
  std::map<std::pair<std::string, std::string>, std::vector<SliceHeader*>> by_series;
  for (SliceHeader& header : headers) {
    ++images_of[identityOf(header.patient)];
    if (!header.series_uid.empty()) by_series[{header.study_uid, header.series_uid}].push_back(&header);
  }
  for (const auto& [uid, slices] : by_series) {
    const bool are_scattered =
        slices.size() >= kFewest && std::all_of(slices.begin(), slices.end(), [&](const SliceHeader* header) {
          return images_of[identityOf(header->patient)] == 1;
        });
    for (SliceHeader* header : slices) header->has_scattered_identity = are_scattered;
  }
}

}  // namespace

bool isSamePatient(const Patient& a, const Patient& b) { return identityOf(a) == identityOf(b); }

void numberPatients(std::vector<SliceHeader>& headers) {
  markScatteredIdentities(headers);
  std::map<std::string, int> numbers;
  for (SliceHeader& header : headers) {
    const std::string whose =
        header.has_scattered_identity ? "series " + header.series_uid : identityOf(header.patient);
    header.patient_number = numbers.emplace(whose, int(numbers.size()) + 1).first->second;
  }
}

Patient patientOf(const SeriesInfo& series) {
  FACENAV_EXPECT(!series.files.empty(), "a series has files");
  const auto header = readHeaderOf(series.files.front());
  if (!header)
    throw Error("is no DICOM file any more", series.files.front().string(), "read the folder again");
  return header->patient;
}

std::string nameInWords(const Patient& patient) {
  std::string words;
  int count = 0;
  for (const std::string& part : split(patient.name, '^')) {
    const std::string name = withoutBlanksAround(part);
    if (name.empty()) continue;
    words += (count == 0 ? "" : count == 1 ? ", " : " ") + name;
    ++count;
  }
  return words.empty() ? patient.id : words;
}

std::string inWords(const Patient& patient) {
  std::string words = nameInWords(patient);
  if (!patient.birth_date.empty()) words += (words.empty() ? "born " : ", born ") + patient.birth_date;
  if (!patient.sex.empty()) words += (words.empty() ? "" : ", ") + patient.sex;
  if (!patient.id.empty() && nameInWords(patient) != patient.id) words += ", ID " + patient.id;
  return words.empty() ? "no patient named" : words;
}

int patientCount(const std::vector<SeriesInfo>& series) {
  std::set<int> patients;
  for (const SeriesInfo& info : series)
    if (info.patient && info.rows > 0) patients.insert(*info.patient);
  return int(patients.size());
}

}  // namespace facenav::dicom
