#include "facenav/capture/rig_store.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ctime>

#include "configuration_folder.h"
#include "facenav/capture/stream_logins.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "rig_json.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongestName = 64;

bool isGoodName(const std::string& name) {
  const auto isGood = [](unsigned char c) {
    return std::isalnum(c) || c == ' ' || c == '-' || c == '_' || c == '.' || c >= 0x80;
  };
  return !name.empty() && name.size() <= kLongestName && name.front() != '.' && name.front() != ' ' &&
         name.back() != ' ' && std::all_of(name.begin(), name.end(), isGood);
}

void useRowTimes(NamedRig& rig, const fs::path& file) {
  for (const double row_s : {rig.row_times->left_s, rig.row_times->right_s})
    if (!(std::abs(row_s) * rig.rig.height_px <= cameras::kLongestReadout_s))
      throw Error("row_times: a picture would take longer than 100 ms", file.string(),
                  "remove row_times: they are measured anew");
  rig.rig.left.row_time_s = rig.row_times->left_s;
  rig.rig.right.row_time_s = rig.row_times->right_s;
}

bool takesAlike(const std::optional<RigCamera>& a, const std::optional<RigCamera>& b) {
  return a && b && isSameCamera(a->identity, b->identity) && a->settings.format == b->settings.format &&
         a->settings.frames_per_s == b->settings.frames_per_s;
}

bool takesTheSamePictures(const NamedRig& a, const NamedRig& b) {
  return takesAlike(a.left, b.left) && takesAlike(a.right, b.right) && a.rig.width_px == b.rig.width_px &&
         a.rig.height_px == b.rig.height_px;
}

NamedRig readRigFolder(const fs::path& folder) {
  NamedRig rig = readRigJson(folder / "rig.json");
  rig.name = folder.filename();  // a folder that was renamed has its new name
  rig.rig = cameras::readRig(folder / "stereo.yml");
  if (rig.row_times) useRowTimes(rig, folder / "rig.json");
  for (auto* side : {&rig.left, &rig.right}) {
    if (!*side) continue;
    (*side)->settings.width_px = rig.rig.width_px;
    (*side)->settings.height_px = rig.rig.height_px;
  }
  return rig;
}

/// Adds the row times of the rig in `folder`, if it takes the same pictures.
NamedRig withKnownRowTimes(NamedRig rig, const fs::path& folder) {
  if (rig.row_times || !fs::is_directory(folder)) return rig;
  try {
    const NamedRig before = readRigFolder(folder);
    if (takesTheSamePictures(rig, before)) rig.row_times = before.row_times;
  } catch (const Error&) {  // a damaged rig is replaced as a whole
  }
  return rig;
}

/// Moves passwords of the cameras' addresses to the user's own file: a rig's folder is copied and lent.
void keepPasswordsApart(const NamedRig& rig) {
  for (const auto* side : {&rig.left, &rig.right})
    if (*side && !(*side)->identity.full_address.empty()) StreamLogins().keep((*side)->identity);
}

void rewrite(const NamedRig& rig, const fs::path& folder) {
  keepPasswordsApart(rig);
  writeWholeFile(folder / "rig.json", toRigJson(rig), FileAccess::by_umask);
}

std::string namesIn(const std::vector<RigEntry>& entries) {
  std::string names;
  for (const auto& entry : entries) names += (names.empty() ? "there are: " : ", ") + entry.name;
  return names.empty() ? "there is none yet; make one with: facenav rig new" : names;
}

}  // namespace

RigStore::RigStore(fs::path folder)
    : folder_(folder.empty() ? configurationFolder("name a folder for the rigs with --rigs") / "rigs"
                             : std::move(folder)) {}

fs::path RigStore::folderOf(const std::string& name) const {
  if (!isGoodName(name))
    throw Error("this is no name for a rig", name, "use up to 64 letters, digits, blanks, '-', '_' and '.'");
  return folder_ / name;
}

std::vector<RigEntry> RigStore::list() const {
  std::vector<RigEntry> entries;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    const std::string name = entry.path().filename();
    if (!entry.is_directory(ignored) || !isGoodName(name)) continue;
    RigEntry found{name, entry.path(), std::nullopt, ""};
    try {
      found.rig = readRigFolder(entry.path());
    } catch (const Error& error) {
      found.problem = error.what();
    }
    entries.push_back(std::move(found));
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return entries;
}

NamedRig RigStore::read(const std::string& name) const {
  const fs::path folder = folderOf(name);
  if (!fs::is_directory(folder)) throw Error("there is no such rig", folder.string(), namesIn(list()));
  return readRigFolder(folder);
}

void RigStore::write(const NamedRig& rig, Existing existing) const {
  const fs::path folder = folderOf(rig.name);
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    throw Error("the folder for rigs cannot be made (" + error.message() + ")", folder_.string(),
                "choose another");
  keepPasswordsApart(rig);
  WholeFolder whole(folder, FileAccess::by_umask, existing);
  writeWholeFile(whole.temporaryPath() / "rig.json", toRigJson(withKnownRowTimes(rig, folder)),
                 FileAccess::by_umask);
  cameras::writeRig(rig.rig, whole.temporaryPath() / "stereo.yml");
  whole.commit();
}

void RigStore::note(const std::string& name, const RigCheckNote& check) const {
  NamedRig rig = read(name);
  rig.last_check = check;
  rewrite(rig, folderOf(name));
}

void RigStore::noteRowTimes(const std::string& name, const MeasuredRowTimes& row_times) const {
  NamedRig rig = read(name);
  rig.row_times = row_times;
  rewrite(rig, folderOf(name));
}

std::unique_ptr<CameraPairSource> openRig(const CameraBackends& backends, const NamedRig& rig) {
  if (!rig.left || !rig.right)
    throw Error("the rig knows no cameras: it was made from files alone", rig.name,
                "make it again with --left-camera and --right-camera");
  const bool is_quick = rig.left->identity.backend == "v4l2" && rig.right->identity.backend == "v4l2";
  const auto found = listCameras(backends, is_quick ? Search::quick : Search::everywhere);
  auto left = openCamera(backends, findCamera(found, rig.left->identity));
  auto right = openCamera(backends, findCamera(found, rig.right->identity));
  return openCameraPair(rig.rig, std::move(left), std::move(right),
                        {rig.left->settings, rig.right->settings});
}

std::vector<std::string> changedSettings(const CameraPairSource& source) {
  std::vector<std::string> changed;
  for (const auto& [side, state] :
       {std::pair("left", source.leftState()), std::pair("right", source.rightState())})
    for (const auto& words : unlockedInWords(state))
      changed.push_back(std::string(side) + " camera, " + words);
  return changed;
}

std::vector<std::string> restoredSettings(const CameraPairSource& source) {
  constexpr double kSame = 0.01;  // relative: cameras round to their own steps
  std::vector<std::string> restored;
  for (const auto& [side, state] :
       {std::pair("left", source.leftState()), std::pair("right", source.rightState())})
    for (const auto& control : state.controls) {
      if (control.lock != ControlState::Lock::locked || !control.found || !control.actual) continue;
      if (std::abs(*control.found - *control.actual) <= kSame * std::max(1.0, std::abs(*control.actual)))
        continue;
      const std::string unit = control.unit.empty() ? "" : " " + control.unit;
      restored.push_back(std::string(side) + " camera, " + control.name +
                         formatted(": was %g", *control.found) + unit +
                         formatted(", is %g", *control.actual) + unit + " again");
    }
  return restored;
}

RigCheckNote noteOfNow(const std::string& state, const std::string& words) {
  const std::time_t now = std::time(nullptr);
  char utc[32];
  std::strftime(utc, sizeof utc, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return {utc, state, words};
}

}  // namespace facenav::capture
