#include "facenav/core/error.h"
#include "folders.h"
#include "json_pose.h"
#include "readers.h"
#include "text.h"

// A session of NaviNIBS: SessionConfig.json names the file of each part. Who the patient is stands in it,
// too, and is not read.

namespace facenav::interop {
namespace {

constexpr const char* kConfig = "SessionConfig.json";

/// Folder of the session in the set; an archive may hold the session's folder itself.
std::string folderOfSession(const FileSet& files) {
  std::string folder = "/";
  for (const auto& name : files.names())
    if (lastOf(name) == kConfig && (folder == "/" || name.size() < folder.size() + lastOf(name).size()))
      folder = folderOf(name);
  return folder;
}

}  // namespace

bool isNavinibsSession(const FileSet& files) {
  int count = 0;
  for (const auto& name : files.names()) count += lastOf(name) == kConfig;
  return files.has(kConfig) || count == 1;
}

OtherFile readNavinibsSession(const FileSet& files) {
  const std::string folder = folderOfSession(files);
  const Source source{files.read(folder + kConfig), files.path(folder + kConfig), nullptr};
  const auto config = jsonOf(source, "targets");
  const std::string version = textOr(config, "formatVersion");
  if (version != "0.0.1" && version != "0.0.2")
    refuseFile(source.path, "",
               "is a NaviNIBS session of version '" + version.substr(0, 20) + "'; 0.0.1 and 0.0.2 are read",
               "export its targets as .json");
  OtherFile all;
  for (const char* part : {"targets", "samples"}) {
    const std::string name = folder + textOr(config, part);
    if (textOr(config, part).empty()) continue;
    if (!files.has(name))
      refuseFile(source.path, std::string("key '") + part + "'", "names a file that is not there: " + name);
    OtherFile file = readNavinibsList({files.read(name), files.path(name), nullptr}, part);
    all.items.insert(all.items.end(), file.items.begin(), file.items.end());
    if (const auto on_disk = files.onDisk(name)) all.parts.push_back(*on_disk);
  }
  all.words = "NaviNIBS session";
  all.format = "navinibs";
  all.space_words = "RAS";
  return all;
}

}  // namespace facenav::interop
