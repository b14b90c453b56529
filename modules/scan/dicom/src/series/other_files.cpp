#include "other_files.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>

#include "facenav/volume/nifti.h"

namespace facenav::dicom {
namespace fs = std::filesystem;
namespace {

/// Name of the archive format by the file's first bytes; empty for other files. Documents and arrays of other
/// programs are zip files, too: their endings tell.
std::string archiveOf(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  const std::set<std::string> kArchives{"", ".zip", ".7z", ".rar", ".gz", ".tgz", ".tar", ".dcm", ".iso"};
  if (!kArchives.count(ending)) return {};
  constexpr std::size_t kTarAt = 257;
  std::string start(kTarAt + 5, '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), std::streamsize(start.size()));
  const auto begins = [&](const std::string& mark) { return start.compare(0, mark.size(), mark) == 0; };
  if (begins("PK\x03\x04") || begins("PK\x05\x06")) return "zip";
  if (begins("7z\xBC\xAF\x27\x1C")) return "7z";
  if (begins("Rar!\x1A")) return "rar";
  if (begins("\x1F\x8B") && !volume::isNiftiName(path)) return "gzip";
  return start.compare(kTarAt, 5, "ustar") == 0 ? "tar" : "";
}

}  // namespace

Error noDicomIn(const std::vector<fs::path>& files, const std::string& where) {
  const bool is_one_file = files.size() == 1 && files[0] == fs::path(where);
  std::error_code error;
  for (const fs::path& file : files)
    if (const std::string archive = archiveOf(file); !archive.empty())
      return Error(is_one_file ? "is a " + archive + " archive"
                               : "holds no DICOM images but a " + archive + " archive (" +
                                     file.filename().string() + ")",
                   where, "unpack it and give the folder");
  if (std::all_of(files.begin(), files.end(),
                  [&](const fs::path& f) { return fs::file_size(f, error) == 0; }))
    return Error(is_one_file ? "is empty (0 bytes)"
                             : "holds empty files only (" + std::to_string(files.size()) + " of 0 bytes)",
                 where, "copy it again");
  for (const fs::path& file : files)
    if (volume::isNiftiName(file) && !is_one_file)
      return Error("holds no DICOM images but NIfTI (" + file.filename().string() + ")", where,
                   "give that file");
  return Error("holds no DICOM images", where, "give a folder of DICOM files or a .nii.gz");
}

}  // namespace facenav::dicom
