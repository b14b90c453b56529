#include "facenav/coil_library/coil_library.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/plain_words.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/whole_folder.h"
#include "facenav/guidance/coil_plate.h"

namespace facenav::coil_library {
namespace fs = std::filesystem;
namespace {

using CoilJson = nlohmann::ordered_json;

constexpr double kDay_s = 86400;
constexpr std::size_t kLongestSlug = 60;

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return text;
}

/// Returns a folder name: "Figure-8 70 mm" -> "figure-8-70-mm".
std::string slugOf(const std::string& name) {
  std::string slug;
  for (const char c : lower(name)) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (is_plain)
      slug += c;
    else if (!slug.empty() && slug.back() != '-')
      slug += '-';
  }
  while (!slug.empty() && slug.back() == '-') slug.pop_back();
  return slug.substr(0, kLongestSlug);
}

LibraryCoil readLibraryCoil(const fs::path& folder) {
  LibraryCoil coil;
  coil.file = folder / "coil.json";
  coil.name = folder.filename().string();
  try {
    coil.card = coil_tracking::readCoilCard(coil.file);
    if (!coil.card.name.empty()) coil.name = coil.card.name;
    coil.model = coil_tracking::readCoil(coil.file);
    coil.model.name = coil.name;
    guidance::readPlate(coil.file);
  } catch (const Error& error) {
    coil.problem = error.what();
  }
  return coil;
}

std::string namesOf(const std::vector<LibraryCoil>& coils) {
  std::string names;
  for (const auto& coil : coils) names += (names.empty() ? "'" : ", '") + coil.name + "'";
  return names;
}

[[noreturn]] void refuseName(const std::string& name, const std::vector<LibraryCoil>& coils,
                             const fs::path& library) {
  throw Error(
      "there is no coil named '" + name + "'", library.string(),
      coils.empty() ? "add one with 'facenav coil add coil.json'" : "choose one of: " + namesOf(coils));
}

LibraryCoil chosenFrom(const std::vector<LibraryCoil>& coils, const std::string& name,
                       const fs::path& library) {
  std::vector<const LibraryCoil*> alike;
  for (const auto& coil : coils) {
    if (coil.name == name || coil.file.parent_path().filename() == name) return coil;
    if (lower(coil.name).rfind(lower(name), 0) == 0) alike.push_back(&coil);
  }
  if (alike.size() != 1 || name.empty()) refuseName(name, coils, library);
  return *alike.front();
}

void requireOwnMarker(const coil_tracking::CoilModel& model, const fs::path& own_folder,
                      const std::vector<LibraryCoil>& coils) {
  for (const auto& other : coils) {
    if (other.file.parent_path() == own_folder || !other.problem.empty()) continue;
    if (coil_tracking::shareMarker(model, other.model))
      throw Error("the coil '" + other.name + "' carries the same marker (" +
                      coil_tracking::markerWords(model.markers.front()) +
                      "): a picture cannot tell them apart",
                  other.file.string(), "print another marker for one of them, or remove that coil first");
  }
}

/// Copies the file that `value` names to the coil's new folder and replaces `value` by the copy's name.
void takeAlong(CoilJson& value, const fs::path& from, const fs::path& to) {
  const fs::path source = from.parent_path() / value.get<std::string>(), name = source.filename();
  writeWholeFile(to / name, readWholeFile(source), FileAccess::by_umask);
  value = name.string();
}

void takeFilesAlong(CoilJson& json, const fs::path& from, const fs::path& to) {
  if (json.contains("mesh")) takeAlong(json["mesh"], from, to);
  if (json.contains("marker") && json["marker"].contains("pattern"))
    takeAlong(json["marker"]["pattern"], from, to);
  if (json.contains("markers"))
    for (auto& marker : json["markers"])
      if (marker.contains("pattern")) takeAlong(marker["pattern"], from, to);
}

void change(CoilJson& json, const CoilChanges& changes) {
  const auto set = [&](const char* key, const std::optional<std::string>& value) {
    if (value) json[key] = *value;
  };
  set("name", changes.name);
  set("make", changes.make);
  set("model", changes.model);
  set("serial", changes.serial);
  if (const auto& focus = changes.focus_mm) json["focus_mm"] = {focus->x(), focus->y(), focus->z()};
}

}  // namespace

fs::path coilLibrary(const fs::path& asked) {
  if (!asked.empty()) return asked;
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (const auto named = variable("FACENAV_COILS"); !named.empty()) return named;
  if (const auto shared = variable("XDG_DATA_HOME"); shared.is_absolute())
    return shared / "facenav" / "coils";
  return variable("HOME") / ".local" / "share" / "facenav" / "coils";
}

std::vector<LibraryCoil> coilsIn(const fs::path& library) {
  std::vector<LibraryCoil> coils;
  std::error_code fault;
  for (fs::directory_iterator at(library, fault), end; !fault && at != end; at.increment(fault))
    if (fs::exists(at->path() / "coil.json")) coils.push_back(readLibraryCoil(at->path()));
  std::sort(coils.begin(), coils.end(), [](const LibraryCoil& a, const LibraryCoil& b) {
    return std::pair(!a.problem.empty(), lower(a.name)) < std::pair(!b.problem.empty(), lower(b.name));
  });
  return coils;
}

LibraryCoil findCoil(const fs::path& library, const std::string& name) {
  auto coil = chosenFrom(coilsIn(library), name, library);
  if (!coil.problem.empty()) throw Error("this coil cannot be used: " + coil.problem);
  return coil;
}

fs::path coilFileOf(const std::string& words, const fs::path& library) {
  if (fs::is_regular_file(words)) return words;
  const bool is_path = words.find('/') != std::string::npos || fs::path(words).extension() == ".json";
  if (is_path)
    throw Error("file does not exist", words, "give a coil.json, or the name of a coil (facenav coil list)");
  return findCoil(library, words).file;
}

LibraryCoil addCoil(const fs::path& library, const fs::path& coil_json, const CoilChanges& changes,
                    bool replaces) {
  const auto model = coil_tracking::readCoil(coil_json);
  guidance::readPlate(coil_json);
  coil_tracking::readCoilCard(coil_json);
  CoilJson json = CoilJson::parse(readWholeFile(coil_json));
  change(json, changes);
  const std::string name = json.value("name", std::string()), slug = slugOf(name);
  if (!name.empty()) requireName(name, "the coil's name");
  if (slug.empty()) throw Error("the coil has no name", coil_json.string(), "give --name");
  const fs::path folder = library / slug;
  if (fs::exists(folder) && !replaces)
    throw Error("the library has a coil named '" + readLibraryCoil(folder).name + "'", folder.string(),
                "give another --name, or --replace");
  requireOwnMarker(model, folder, coilsIn(library));
  fs::create_directories(library);
  WholeFolder fresh(folder, FileAccess::by_umask, Existing::replace);
  takeFilesAlong(json, coil_json, fresh.temporaryPath());
  writeWholeFile(fresh.temporaryPath() / "coil.json",
                 json.dump(1, ' ', false, CoilJson::error_handler_t::replace) + "\n", FileAccess::by_umask);
  coil_tracking::readCoil(fresh.temporaryPath() / "coil.json");
  coil_tracking::readCoilCard(fresh.temporaryPath() / "coil.json");
  fresh.commit();
  return readLibraryCoil(folder);
}

void removeCoil(const fs::path& library, const std::string& name) {
  const auto coil = chosenFrom(coilsIn(library), name, library);
  std::error_code fault;
  fs::remove_all(coil.file.parent_path(), fault);
  if (fault) throw Error("cannot be removed (" + fault.message() + ")", coil.file.parent_path().string());
}

std::optional<std::string> calibrationReminder(const coil_tracking::CoilCard& card,
                                               std::optional<double> now_s) {
  const double limit_days = settingsOf<CoilRules>().recalibrate_days;
  if (limit_days <= 0) return std::nullopt;
  const std::string name = card.name.empty() ? "this coil" : card.name;
  const char* what_to_do = " (facenav calibrate-coil)";
  if (!card.calibration) return "no calibration of " + name + " is recorded: calibrate it" + what_to_do;
  const auto made_s = secondsOfUtc(card.calibration->utc);
  if (!made_s)
    return "the calibration of " + name + " has no date: calibrate it again if it is old" + what_to_do;
  if (!now_s)
    now_s = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  const double age_days = (*now_s - *made_s) / kDay_s;
  if (age_days <= limit_days) return std::nullopt;
  return "the calibration of " + name + formatted(" is %.0f days old: calibrate it again", age_days) +
         what_to_do;
}

std::optional<std::string> focusCaution(const coil_tracking::CoilCard& card) {
  if (card.isFocusCentred()) return std::nullopt;
  return "the field of " + (card.name.empty() ? "this coil" : card.name) +
         formatted(" is strongest %.0f mm beside its centre: guidance brings the centre to the target",
                   card.focus_mm.head<2>().norm());
}

std::string inWords(const LibraryCoil& coil) {
  if (!coil.problem.empty()) return coil.name + ": cannot be used, " + coil.problem;
  std::string words = coil.name, maker;
  for (const std::string* part : {&coil.card.make, &coil.card.model, &coil.card.serial})
    if (!part->empty()) maker += (maker.empty() ? "" : " ") + *part;
  if (!maker.empty()) words += " (" + maker + ")";
  std::string markers;
  for (const auto& marker : coil.model.markers)
    markers += (markers.empty() ? "; marker " : ", ") + coil_tracking::markerWords(marker);
  words += markers;
  if (const auto& made = coil.card.calibration)
    words += "; calibrated " + (made->utc.empty() ? std::string("(no date)") : made->utc.substr(0, 10)) +
             formatted(", residual %.2f mm, standard error %.2f mm %.2f deg", made->rms_mm, made->sigma_mm,
                       made->sigma_deg);
  return words;
}

}  // namespace facenav::coil_library
