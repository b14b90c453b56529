#include "facenav/dicom/image_kind.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <optional>
#include <vector>

namespace facenav::dicom {
namespace {

using Words = std::vector<std::string>;

/// Values of Image Type in capitals, without blanks, '_' and '-' in them: "T1 MAP" and "T1_MAP" are T1MAP.
Words valuesOf(const std::string& image_type) {
  Words values(1);
  for (const char c : image_type) {
    if (c == '\\')
      values.emplace_back();
    else if (std::isalnum(static_cast<unsigned char>(c)) || c == '*')
      values.back() += char(std::toupper(static_cast<unsigned char>(c)));
  }
  return values;
}

/// Words of a description in small letters: runs of letters, digits, '*' and '+'.
Words wordsOf(const std::string& description) {
  Words words(1);
  for (const char c : description) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '*')
      words.back() += char(std::tolower(static_cast<unsigned char>(c)));
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool isOneOf(const std::string& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* w) { return word == w; });
}

/// The kind that one value of Image Type states; magnitude for M and the like; nullopt if it states none.
std::optional<ImageKind> stated(const std::string& value) {
  if (isOneOf(value, {"P", "PHASE", "PHASEMAP", "PFFE", "PIR", "PSE", "VELOCITYMAP"}))
    return ImageKind::phase;
  if (isOneOf(value, {"R", "REAL", "RFFE", "RIR", "RSE"})) return ImageKind::real;
  if (isOneOf(value, {"I", "IMAGINARY", "IFFE", "IIR", "ISE"})) return ImageKind::imaginary;
  if (isOneOf(value, {"T1MAP", "QT1", "T1MAPPING"})) return ImageKind::t1_map;
  if (isOneOf(value, {"T2MAP", "T2STARMAP", "T2*MAP"})) return ImageKind::t2_map;
  if (isOneOf(value, {"R1MAP", "R2MAP", "R2STARMAP", "R2*MAP", "R1", "R2", "R2STAR"}))
    return ImageKind::rate_map;
  if (isOneOf(value, {"PDMAP", "PROTONDENSITYMAP", "RHOMAP"})) return ImageKind::density_map;
  if (isOneOf(value, {"B0MAP", "B1MAP", "FIELDMAP", "FLIPANGLEMAP", "B0", "B1"})) return ImageKind::field_map;
  if (isOneOf(value, {"MTRMAP", "MTR", "MTSATMAP", "PARAMETERMAP"})) return ImageKind::other_map;
  if (isOneOf(value, {"UNI", "UNIDEN", "UNIIMAGES"})) return ImageKind::uniform;
  if (value == "LOCALIZER") return ImageKind::localizer;
  if (isOneOf(value, {"M", "MAGNITUDE", "MFFE", "MIR", "MSE"})) return ImageKind::magnitude;
  return std::nullopt;
}

/// Kind of a map by the description: "t1 map", "t1map", "qt1", "r1_map", "gre_field_mapping", ..
std::optional<ImageKind> mapNamed(const Words& words) {
  const struct {
    const char* quantity;
    ImageKind kind;
  } kMaps[] = {
      {"t1", ImageKind::t1_map},       {"t2", ImageKind::t2_map},       {"t2star", ImageKind::t2_map},
      {"t2*", ImageKind::t2_map},      {"r1", ImageKind::rate_map},     {"r2", ImageKind::rate_map},
      {"r2s", ImageKind::rate_map},    {"r2star", ImageKind::rate_map}, {"r2*", ImageKind::rate_map},
      {"pd", ImageKind::density_map},  {"b1", ImageKind::field_map},    {"b0", ImageKind::field_map},
      {"field", ImageKind::field_map}, {"mtsat", ImageKind::other_map}, {"mtr", ImageKind::other_map}};
  const auto isMapWord = [](const std::string& word) { return isOneOf(word, {"map", "maps", "mapping"}); };
  for (std::size_t i = 0; i < words.size(); ++i)
    for (const auto& map : kMaps) {
      const std::string quantity = map.quantity;
      if (words[i] == quantity && i + 1 < words.size() && isMapWord(words[i + 1])) return map.kind;
      if (words[i].rfind(quantity, 0) == 0 && isMapWord(words[i].substr(quantity.size()))) return map.kind;
      if (words[i] == "q" + quantity || (words[i] == quantity && quantity[0] == 'r' && words.size() == 1))
        return map.kind;
    }
  return std::nullopt;
}

/// Kind by the parts of an MP2RAGE: Siemens names them "_INV1", "_INV2", "_UNI_Images", "_UNI-DEN",
/// "_T1_Images".
std::optional<ImageKind> partOfMp2rage(const Words& words) {
  const auto mp2rage = std::find_if(words.begin(), words.end(), [](const std::string& word) {
    return word.find("mp2rage") != std::string::npos;
  });
  for (auto word = words.begin(); word != words.end(); ++word) {
    const std::string next = word + 1 == words.end() ? "" : *(word + 1);
    if (*word == "uniden" || (*word == "uni" && (mp2rage != words.end() || isOneOf(next, {"den", "images"}))))
      return ImageKind::uniform;
    if (*word == "t1" && mp2rage < word && isOneOf(next, {"", "images", "map"})) return ImageKind::t1_map;
    if (isOneOf(*word, {"inv1", "inv2"})) return ImageKind::inversion;
  }
  return std::nullopt;
}

bool saysLocalizer(const Words& words) {
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    for (const char* start : {"localiz", "localis", "scout", "survey", "smartbrain"})
      if (word.find(start) != std::string::npos) return true;
    return isOneOf(word, {"loc", "loca", "pilot", "3plan", "3plane", "positionierung"});
  });
}

}  // namespace

const char* inWords(ImageKind kind) {
  switch (kind) {
    case ImageKind::magnitude:
      return "magnitude image";
    case ImageKind::uniform:
      return "MP2RAGE UNI";
    case ImageKind::inversion:
      return "one inversion of an MP2RAGE";
    case ImageKind::phase:
      return "phase image";
    case ImageKind::real:
      return "real part";
    case ImageKind::imaginary:
      return "imaginary part";
    case ImageKind::signed_or_uniform:
      return "phase, real part or MP2RAGE UNI by its values";
    case ImageKind::t1_map:
      return "T1 map";
    case ImageKind::t2_map:
      return "T2 map";
    case ImageKind::rate_map:
      return "relaxation rate map (R1, R2)";
    case ImageKind::density_map:
      return "proton density map";
    case ImageKind::field_map:
      return "field map (B0, B1)";
    case ImageKind::other_map:
      return "parameter map";
    case ImageKind::localizer:
      return "localizer";
    case ImageKind::annotated:
      return "annotated image (marks are drawn into its voxels)";
  }
  return "";
}

std::string withArticle(ImageKind kind) {
  const std::string name = inWords(kind);
  return (std::string("aeiouM").find(name[0]) == std::string::npos ? "a " : "an ") + name;  // an MP2RAGE
}

const char* idOf(ImageKind kind) {
  constexpr const char* kIds[] = {"magnitude",   "uniform",           "inversion", "phase",     "real",
                                  "imaginary",   "signed_or_uniform", "t1_map",    "t2_map",    "rate_map",
                                  "density_map", "field_map",         "other_map", "localizer", "annotated"};
  return kIds[std::size_t(kind)];
}

bool isWithoutSkin(ImageKind kind) {
  return kind == ImageKind::phase || kind == ImageKind::real || kind == ImageKind::imaginary ||
         kind == ImageKind::field_map;
}

bool isMap(ImageKind kind) { return kind >= ImageKind::t1_map && kind <= ImageKind::other_map; }

ImageKind kindOf(const std::string& image_type, const std::string& description) {
  const Words values = valuesOf(image_type);
  std::optional<ImageKind> found;
  // The first two values are ORIGINAL or DERIVED, and PRIMARY or SECONDARY. Maps are also marked M.
  for (std::size_t v = 0; v < values.size(); ++v) {
    const auto kind = stated(values[v]);
    if (!kind || (v < 2 && *kind == ImageKind::magnitude)) continue;
    if (!found || *found == ImageKind::magnitude) found = kind;
  }
  if (found && *found != ImageKind::magnitude) return *found;
  const Words words = wordsOf(description);
  // "phase" alone may be the direction of phase encoding.
  const bool says_phase = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return isOneOf(word, {"phs", "pha"});
  });
  if (says_phase && !found) return ImageKind::phase;
  if (const auto part = partOfMp2rage(words)) return *part;
  if (const auto map = mapNamed(words)) return *map;
  return saysLocalizer(words) ? ImageKind::localizer : ImageKind::magnitude;
}

}  // namespace facenav::dicom
