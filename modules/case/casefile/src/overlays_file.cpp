#include "facenav/casefile/overlays_file.h"

#include <nlohmann/json.hpp>
#include <set>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/plain_words.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

const std::pair<OverlayKind, const char*> kOverlayKinds[] = {{OverlayKind::map, "map"},
                                                             {OverlayKind::mask, "mask"},
                                                             {OverlayKind::tracts, "tracts"},
                                                             {OverlayKind::mesh, "mesh"}};

fs::path overlaysFile(const fs::path& case_folder) { return case_folder / "overlays.json"; }

OverlayEntry readEntry(const JsonReader& json) {
  OverlayEntry entry;
  entry.name = json.at("name").text();
  entry.file = json.at("file").text();
  const fs::path file = entry.file;
  if (file.is_absolute() || file.begin() == file.end() || *file.begin() != "overlays" ||
      entry.file.find("..") != std::string::npos)
    json.at("file").refuse("a file under overlays/ was expected");
  try {
    entry.kind = overlayKindFrom(json.at("kind").text());
    entry.space = overlaySpaceFrom(json.at("space").text());
    entry.opacity = json.at("opacity").number();
    if (json.has("threshold")) entry.threshold = json.at("threshold").number();
    if (json.has("full")) entry.full = json.at("full").number();
    requireSensible(entry);
  } catch (const Error& fault) {
    json.refuse(fault.what());
  }
  if (json.has("unit")) entry.unit = json.at("unit").text();
  if (json.has("shown")) entry.is_shown = json.at("shown").integer() != 0;
  return entry;
}

}  // namespace

std::string toString(OverlayKind kind) {
  for (const auto& [known, word] : kOverlayKinds)
    if (known == kind) return word;
  return {};
}

std::string toString(OverlaySpace space) { return space == OverlaySpace::mni ? "mni" : "native"; }

OverlayKind overlayKindFrom(const std::string& word) {
  for (const auto& [kind, known] : kOverlayKinds)
    if (word == known) return kind;
  throw Error("'" + word + "' is no kind of overlay", {}, "map, mask, tracts or mesh");
}

OverlaySpace overlaySpaceFrom(const std::string& word) {
  if (word == "mni") return OverlaySpace::mni;
  if (word == "native") return OverlaySpace::native;
  throw Error("'" + word + "' is no space", {}, "mni or native");
}

void requireSensible(const OverlayEntry& entry) {
  if (!(entry.opacity >= 0 && entry.opacity <= 1))
    throw Error("an overlay's opacity lies between 0 and 1", {}, "give another");
  if (!(entry.threshold >= 0))
    throw Error("a map's threshold is 0 or more, for both signs", {}, "give another");
  if (entry.kind == OverlayKind::map && !(entry.full > entry.threshold))
    throw Error("a map's colours end above its threshold", {}, "give a lower threshold or a higher end");
}

std::vector<OverlayEntry> readOverlays(const fs::path& case_folder) {
  std::vector<OverlayEntry> entries;
  if (!fs::exists(overlaysFile(case_folder))) return entries;
  for (const JsonReader& json : JsonReader::readFile(overlaysFile(case_folder)).at("overlays").elements())
    entries.push_back(readEntry(json));
  return entries;
}

void writeOverlays(const std::vector<OverlayEntry>& entries, const fs::path& case_folder) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  std::set<std::string> names;
  for (const OverlayEntry& entry : entries) {
    requireSensible(entry);
    requireName(entry.name, "the overlay's name");
    if (!names.insert(entry.name).second)
      throw Error("there is an overlay '" + entry.name + "' already", {}, "give another name");
    list.push_back({{"name", entry.name},
                    {"kind", toString(entry.kind)},
                    {"file", entry.file},
                    {"space", toString(entry.space)},
                    {"opacity", entry.opacity},
                    {"shown", int(entry.is_shown)}});
    if (entry.kind != OverlayKind::map) continue;
    list.back()["threshold"] = entry.threshold;
    list.back()["full"] = entry.full;
    if (!entry.unit.empty()) list.back()["unit"] = entry.unit;
  }
  const Json json{{"overlays", list}};
  writeWholeFile(overlaysFile(case_folder), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n",
                 FileAccess::owner_only);
}

}  // namespace facenav::casefile
