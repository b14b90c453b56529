#include "facenav/plan/other_files.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/interop/formats.h"
#include "facenav/plan/imported_field.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/nifti_forms.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

constexpr int kMostFiles = 2000, kDeepest = 4;  // of a folder: an export has some dozen, three folders deep
constexpr std::size_t kStart_bytes = 4096;

std::string startOf(const fs::path& file) {
  std::string start(kStart_bytes, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(&start[0], std::streamsize(start.size()));
  start.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
  return start;
}

bool isDicom(const std::string& start) { return start.size() >= 132 && start.compare(128, 4, "DICM") == 0; }

bool isScan(const fs::path& file, const std::string& start) {
  auto ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return isDicom(start) || volume::isNiftiName(file) || ending == ".img" || ending == ".dcm" ||
         ending == ".ima";
}

/// Binary content is read whole only where its first bytes may be those of a known format.
bool isOther(const fs::path& file, const std::string& start) {
  if (start.empty() || fs::file_size(file) > interop::kLargestFile_bytes) return false;
  const bool is_text = start.find('\0') == std::string::npos;
  return is_text ? interop::isKnown(readWholeFile(file)) : interop::isKnown(start);
}

/// True for a NIfTI of vectors or of fractions, as a field is. A scan may hold fractions, too.
/// A damaged one is for the scan's reader to refuse.
bool mayHoldField(const fs::path& nifti) {
  try {
    const auto forms = volume::readNiftiForms(nifti);
    return forms.values == 3 || (forms.values == 1 && forms.holds_fractions);
  } catch (const Error&) {
    return false;
  }
}

DroppedFiles filesIn(const fs::path& folder) {
  DroppedFiles found;
  found.may_be_scan = true;
  int count = 0;
  for (auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied);
       it != fs::recursive_directory_iterator() && count < kMostFiles; ++it) {
    if (it->is_directory() && it.depth() >= kDeepest) it.disable_recursion_pending();
    if (!it->is_regular_file()) continue;
    ++count;
    const std::string start = startOf(it->path());
    if (isDicom(start)) return {{}, {}, true};
    if (!isScan(it->path(), start) && isOther(it->path(), start)) found.others.push_back(it->path());
  }
  std::sort(found.others.begin(), found.others.end());
  found.may_be_scan = found.others.empty();
  return found;
}

}  // namespace

DroppedFiles filesAt(const fs::path& path) {
  try {
    if (interop::isSessionFolder(path)) return {{path}, {}, false};
    if (fs::is_directory(path)) return filesIn(path);
    if (!fs::is_regular_file(path)) return {};
    const std::string start = startOf(path);
    if (isDicom(start)) return {{}, {}, true};
    if (volume::isNiftiName(path) && isFieldFile(path) && mayHoldField(path))
      return {{}, {path}, volume::readNiftiForms(path).values == 1};
    if (isScan(path, start)) return {{}, {}, true};
    if (interop::isSessionArchive(path) || isOther(path, start)) return {{path}, {}, false};
    if (isFieldFile(path)) return {{}, {path}, false};
  } catch (const std::exception&) {  // unreadable: none of these
  }
  return {};
}

}  // namespace facenav::steps
