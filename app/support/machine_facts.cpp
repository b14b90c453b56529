#include "support/machine_facts.h"

#include <sys/utsname.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "facenav/core/data_folder.h"
#include "facenav/core/licences.h"
#include "software_commit.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// The text behind `key` in the file's first line that begins with it; empty if there is none.
std::string valueIn(const fs::path& file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const auto begin = line.find_first_not_of(" \t:=\"", key.size());
    if (begin == std::string::npos) return {};
    return line.substr(begin, line.find_last_not_of(" \"") - begin + 1);
  }
  return {};
}

std::string firstLine(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// Kernel drivers of the graphics cards: "i915".
std::set<std::string> graphicsDrivers() {
  std::set<std::string> drivers;
  std::error_code fault;
  for (fs::directory_iterator at("/sys/class/drm", fault), end; !fault && at != end; at.increment(fault)) {
    const fs::path driver = fs::read_symlink(at->path() / "device/driver", fault);
    if (!fault) drivers.insert(driver.filename().string());
    fault.clear();
  }
  return drivers;
}

std::vector<std::string> cameraModels() {
  std::vector<std::string> models;
  std::error_code fault;
  for (fs::directory_iterator at("/sys/class/video4linux", fault), end; !fault && at != end;
       at.increment(fault))
    models.push_back(firstLine(at->path() / "name"));
  return models;
}

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

}  // namespace

Json programFacts() {
  Json json{{"version", versionInWords()}};
  for (const char* name : {"facenav-cli", "facenav-gui", "facenav-lab", "facenav-bids"})
    json["programs"][name] = fs::exists(programPath().parent_path() / name);
  json["data"] = {
      {"brain prior", fs::exists(dataFolder() / "brain_prior/weights.fnbp")},
      {"landmarks of the face", fs::exists("/usr/share/dlib/shape_predictor_68_face_landmarks.dat")},
      {"Colin27", fs::exists("/usr/share/mricron/templates/ch2.nii.gz")}};
  for (const LicensedPart& part : licensedParts()) json["parts"][part.name] = part.version;
  return json;
}

Json machineFacts() {
  utsname kernel{};
  ::uname(&kernel);
  return {{"system", valueIn("/etc/os-release", "PRETTY_NAME")},
          {"kernel", std::string(kernel.sysname) + " " + kernel.release},
          {"machine", std::string(kernel.machine)},
          {"processor", valueIn("/proc/cpuinfo", "model name")},
          {"threads", std::thread::hardware_concurrency()},
          {"memory", valueIn("/proc/meminfo", "MemTotal")},
          {"memory available", valueIn("/proc/meminfo", "MemAvailable")},
          {"graphics drivers", graphicsDrivers()},
          {"cameras", cameraModels()},
          {"has X display", isSet("DISPLAY")},
          {"has Wayland display", isSet("WAYLAND_DISPLAY")}};
}

}  // namespace facenav::app
