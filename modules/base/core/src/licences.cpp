#include "facenav/core/licences.h"

#include <algorithm>
#include <sstream>

#include "facenav/core/error.h"
#include "licence_table.h"

namespace facenav {
inline namespace core {
namespace {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

PartUse useNamed(const std::string& words) {
  for (const PartUse use :
       {PartUse::linked, PartUse::linked_in_lab, PartUse::compiled_in, PartUse::data, PartUse::run})
    if (words == toString(use)) return use;
  FACENAV_EXPECT(false, "a part of the table of licences has an unknown use: " + words);
  return PartUse::linked;
}

LicensedPart partOf(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '|');) fields.push_back(trimmed(field));
  FACENAV_EXPECT(fields.size() >= 6, "a row of the table of licences has six fields: " + line);
  LicensedPart part{fields[0], fields[1], fields[3], fields[5], {}, useNamed(fields[2])};
  std::istringstream libraries(fields[4]);
  for (std::string library; libraries >> library;) part.libraries.push_back(library);
  return part;
}

std::vector<LicensedPart> readTable() {
  std::vector<LicensedPart> parts;
  std::istringstream table(licenceTable());
  for (std::string line; std::getline(table, line);)
    if (!line.empty()) parts.push_back(partOf(line));
  return parts;
}

}  // namespace

std::string toString(PartUse use) {
  switch (use) {
    case PartUse::linked:
      return "linked";
    case PartUse::linked_in_lab:
      return "linked in facenav-lab";
    case PartUse::compiled_in:
      return "compiled in";
    case PartUse::data:
      return "data";
    case PartUse::run:
      return "run";
  }
  return {};
}

const std::vector<LicensedPart>& licensedParts() {
  static const std::vector<LicensedPart> kParts = readTable();
  return kParts;
}

std::string upstreamVersion(const std::string& debian_version) {
  std::string version = debian_version.substr(debian_version.find(':') + 1);  // npos + 1 is 0
  version.resize(std::min(version.size(), version.rfind('-')));
  return version.substr(0, version.find_first_of("+~"));
}

}  // namespace core
}  // namespace facenav
