#include "folders.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "nibs_bids.h"
#include "readers.h"
#include "text.h"

namespace facenav::interop {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostTried = 200;  // files of a folder that is none of the known ones

/// The only file of a known format in the folder.
OtherFile readOnlyFile(const FileSet& files, const T1* t1) {
  std::vector<std::string> known;
  std::size_t tried = 0;
  for (const auto& name : files.names()) {
    if (++tried > kMostTried) break;
    if (files.onDisk(name) && fs::file_size(*files.onDisk(name)) > kLargestFile_bytes) continue;
    if (isKnown(files.read(name))) known.push_back(name);
  }
  if (known.size() == 1) {
    OtherFile file = readOtherText({files.read(known[0]), files.path(known[0]), t1});
    if (const auto part = files.onDisk(known[0])) file.parts = {*part};
    return file;
  }
  if (known.empty())
    throw Error("holds no file of a navigator that FaceNav knows", files.root().string(),
                "the manual's page on other programs lists them");
  std::string list;
  for (std::size_t i = 0; i < known.size() && i < 5; ++i) list += (i == 0 ? "" : ", ") + known[i];
  throw Error(formatted("holds %d files that could be meant: ", int(known.size())) + list +
                  (known.size() > 5 ? ", .." : ""),
              files.root().string(), "choose one of them");
}

/// Folders with such a file, "" for the root.
std::set<std::string> foldersWith(const FileSet& files, const std::string& file_name) {
  std::set<std::string> folders;
  for (const auto& name : files.names())
    if (lastOf(name) == file_name) folders.insert(folderOf(name));
  return folders;
}

[[noreturn]] void refuseSessions(const FileSet& files, const std::set<std::string>& sessions) {
  std::string list;
  for (const auto& session : sessions) list += (list.empty() ? "" : ", ") + session;
  throw Error(formatted("holds %d sessions: ", int(sessions.size())) + list.substr(0, 200),
              files.root().string(), "choose the folder of one");
}

/// NIBS-BIDS in or below a folder; nothing if there is none. The data set may begin above or below it.
std::optional<OtherFile> readNibsBelow(const fs::path& folder) {
  const fs::path root = nibsDataSetOf(folder);
  const FileSet files = FileSet::below(root, folder, true);
  const auto markers = nibsMarkers(files);
  if (markers.empty()) return std::nullopt;
  const auto set = nibsDataSetOf((root / markers.front()).parent_path());
  if (set == root || !fs::exists(set / "dataset_description.json")) return readNibsSet(files, markers);
  for (const auto& name : markers)
    if (nibsDataSetOf((root / name).parent_path()) != set)
      refuseFile(folder, "", "holds several data sets of NIBS-BIDS", "choose the folder of one");
  return readNibsBelow(set);
}

OtherFile readSet(const fs::path& path, const T1* t1) {
  if (fs::is_directory(path))
    if (auto file = readNibsBelow(fs::absolute(path / "").lexically_normal().parent_path())) return *file;
  const FileSet files(path);
  if (const auto markers = nibsMarkers(files); !markers.empty()) return readNibsSet(files, markers);
  if (isNavinibsSession(files)) return readNavinibsSession(files);
  for (const char* of_session : {"SessionConfig.json", "Session.xml"})
    if (const auto sessions = foldersWith(files, of_session); sessions.size() > 1 && sessions.count("") == 0)
      refuseSessions(files, sessions);
  if (isLocaliteSession(files)) return readLocaliteSession(files);
  return readOnlyFile(files, t1);
}

bool holdsSet(const fs::path& path) {
  try {
    const FileSet files(path);
    return isNavinibsSession(files) || isLocaliteSession(files) || !nibsMarkers(files).empty();
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

OtherFile readFileSet(const fs::path& path, const T1* t1) { return finished(readSet(path, t1), path); }

bool isSessionArchive(const fs::path& path) {
  char start[2] = {};
  if (!std::ifstream(path, std::ios::binary).read(start, sizeof start)) return false;
  if (start[0] != 'P' || start[1] != 'K') return false;
  return holdsSet(path);
}

bool isSessionFolder(const fs::path& path) { return fs::is_directory(path) && holdsSet(path); }

}  // namespace facenav::interop
