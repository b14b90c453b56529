#include "file_set.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/zip_file.h"
#include "facenav/interop/formats.h"
#include "text.h"

namespace facenav::interop {
namespace fs = std::filesystem;
namespace {

constexpr int kDeepest = 8;  // folders below the chosen one

std::string without(const std::string& name, const std::string& beginning) {
  return startsWith(name, beginning) ? name.substr(beginning.size()) : name;
}

}  // namespace

std::string plainText(std::string content) {
  if (startsWith(content, "\xEF\xBB\xBF")) content.erase(0, 3);
  if (!contains(content, "\n") && !contains(content.substr(0, 4000), std::string(1, '\0')))
    std::replace(content.begin(), content.end(), '\r', '\n');
  return content;
}

std::string folderOf(const std::string& name) {
  const auto slash = name.rfind('/');
  return slash == std::string::npos ? std::string() : name.substr(0, slash + 1);
}

std::string lastOf(const std::string& name) { return name.substr(folderOf(name).size()); }

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

FileSet::FileSet(const fs::path& root) : root_(root) {
  if (fs::is_directory(root)) {
    addFolder(root, true);
  } else {
    for (const auto& name : zipNames(root)) archived_[without(name, "./")] = name;
    for (const auto& [name, stored] : archived_) names_.push_back(name);
  }
  std::sort(names_.begin(), names_.end());
}

FileSet::FileSet(std::map<std::string, std::string> contents, const fs::path& root) : root_(root) {
  for (const auto& [name, content] : contents) names_.push_back(name);
  in_memory_ = std::move(contents);
}

FileSet FileSet::below(const fs::path& root, const fs::path& folder, bool is_deep) {
  FileSet files;
  files.root_ = root;
  files.addFolder(folder, is_deep);
  for (fs::path at = folder; at != root && at != at.parent_path();) {
    at = at.parent_path();
    files.addFolder(at, false);
  }
  std::sort(files.names_.begin(), files.names_.end());
  return files;
}

void FileSet::addFolder(const fs::path& folder, bool is_deep) {
  std::error_code fault, unknown;
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, fault), end;
  for (; !fault && it != end; it.increment(fault)) {
    const bool is_hidden = startsWith(it->path().filename().string(), ".");
    if (is_hidden || !is_deep || it.depth() > kDeepest) it.disable_recursion_pending();
    if (is_hidden || !fs::is_regular_file(it->path(), unknown)) continue;
    names_.push_back(it->path().lexically_relative(root_).generic_string());
    if (names_.size() > kMostItems)
      throw Error("holds more than 100000 files", folder.string(), "choose a folder in it, or one file");
  }
  if (fault) throw Error("the folder cannot be read: " + fault.message(), folder.string());
}

bool FileSet::has(const std::string& name) const {
  return std::binary_search(names_.begin(), names_.end(), name);
}

std::string FileSet::read(const std::string& name) const {
  if (in_memory_) return has(name) ? plainText(in_memory_->at(name)) : std::string();
  if (!archived_.empty()) {
    const auto found = archived_.find(name);
    return plainText(
        readZipEntry(root_, found == archived_.end() ? name : found->second, kLargestFile_bytes));
  }
  const fs::path file = path(name);
  if (!fs::is_regular_file(file)) throw Error("file does not exist", file.string());
  if (fs::file_size(file) > kLargestFile_bytes)
    throw Error("is larger than 64 MB, which no list of targets is", file.string());
  return plainText(readWholeFile(file));
}

std::optional<fs::path> FileSet::onDisk(const std::string& name) const {
  if (in_memory_ || !archived_.empty()) return std::nullopt;
  const fs::path relative = fs::path(name).lexically_normal();
  if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") return std::nullopt;
  std::error_code unknown;
  if (!fs::is_regular_file(root_ / relative, unknown)) return std::nullopt;
  return root_ / relative;
}

}  // namespace facenav::interop
