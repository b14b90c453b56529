#include "spdx.h"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "facenav/core/licences.h"
#include "facenav/core/software_version.h"
#include "facenav/core/utc_time.h"
#include "software_commit.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFaceNav = "SPDXRef-Package-facenav";

/// Time of the build as SPDX writes it, without parts of a second.
std::string createdUtc() {
  auto time = std::chrono::system_clock::now();
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH"); epoch && *epoch)
    time = std::chrono::system_clock::from_time_t(std::time_t(std::strtoll(epoch, nullptr, 10)));
  return isoUtc(time).substr(0, 19) + "Z";
}

/// The identifier of a part: letters, digits, '.' and '-' only.
std::string spdxIdOf(const LicensedPart& part) {
  std::string id = "SPDXRef-Package-";
  for (const char c : part.package)
    id += std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' ? c : '-';
  return id;
}

std::string relationOf(PartUse use) {
  switch (use) {
    case PartUse::linked:
    case PartUse::linked_in_lab:
      return "DYNAMIC_LINK";
    case PartUse::compiled_in:
      return "CONTAINS";
    default:
      return "DEPENDS_ON";
  }
}

/// A version in a package URL: ':' and '+' are written as %3A and %2B.
std::string inUrl(const std::string& version) {
  std::string out;
  for (const char c : version) out += c == ':' ? "%3A" : c == '+' ? "%2B" : std::string(1, c);
  return out;
}

Json packageOf(const LicensedPart& part) {
  Json json{{"SPDXID", spdxIdOf(part)}, {"name", part.name}};
  if (!part.version.empty()) json["versionInfo"] = part.version;
  json["downloadLocation"] = "NOASSERTION";
  json["filesAnalyzed"] = false;
  json["licenseConcluded"] = part.licence;
  json["licenseDeclared"] = part.licence;
  json["copyrightText"] = "NOASSERTION";
  const std::string version = part.version.empty() ? "" : "@" + inUrl(part.version);
  const Json reference{{"referenceCategory", "PACKAGE-MANAGER"},
                       {"referenceType", "purl"},
                       {"referenceLocator", "pkg:deb/debian/" + inUrl(part.package) + version}};
  json["externalRefs"] = Json::array({reference});
  return json;
}

/// Licences that are not in SPDX's list, with their words: all of ours are in the public domain.
Json ownLicences() {
  std::set<std::string> names;
  for (const LicensedPart& part : licensedParts())
    if (part.licence.rfind("LicenseRef-", 0) == 0) names.insert(part.licence);
  Json list = Json::array();
  for (const std::string& name : names)
    list.push_back({{"licenseId", name}, {"extractedText", "This software is in the public domain."}});
  return list;
}

}  // namespace

std::string spdxDocument() {
  Json packages = Json::array(), relations = Json::array();
  packages.push_back({{"SPDXID", kFaceNav},
                      {"name", "facenav"},
                      {"versionInfo", softwareVersion()},
                      {"downloadLocation", "NOASSERTION"},
                      {"filesAnalyzed", false},
                      {"licenseConcluded", "Apache-2.0"},
                      {"licenseDeclared", "Apache-2.0"},
                      {"copyrightText", "NOASSERTION"},
                      {"sourceInfo", "commit " + std::string(softwareCommit())}});
  relations.push_back({{"spdxElementId", "SPDXRef-DOCUMENT"},
                       {"relationshipType", "DESCRIBES"},
                       {"relatedSpdxElement", kFaceNav}});
  for (const LicensedPart& part : licensedParts()) {
    packages.push_back(packageOf(part));
    relations.push_back({{"spdxElementId", kFaceNav},
                         {"relationshipType", relationOf(part.use)},
                         {"relatedSpdxElement", spdxIdOf(part)}});
  }
  const std::string name = "facenav-" + softwareVersion();
  const Json document{
      {"spdxVersion", "SPDX-2.3"},
      {"dataLicense", "CC0-1.0"},
      {"SPDXID", "SPDXRef-DOCUMENT"},
      {"name", name},
      {"documentNamespace", "https://spdx.org/spdxdocs/" + name + "-" + softwareCommit()},
      {"creationInfo", {{"created", createdUtc()}, {"creators", Json::array({"Tool: " + name})}}},
      {"packages", packages},
      {"hasExtractedLicensingInfos", ownLicences()},
      {"relationships", relations}};
  return document.dump(1) + "\n";
}

}  // namespace facenav::app
