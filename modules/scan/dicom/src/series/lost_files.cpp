#include "lost_files.h"

#include <gdcmDataSet.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "facenav/core/error.h"
#include "header/tag_values.h"
#include "series_verdict.h"

namespace facenav::dicom {
namespace fs = std::filesystem;
namespace {

/// A name as it is compared: small letters, without the version ";1" and the dot that CDs add.
std::string plainName(std::string name) {
  name = name.substr(0, name.find(';'));
  while (!name.empty() && name.back() == '.') name.pop_back();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return name;
}

/// Finds `name` in `folder`, as CDs write names; empty if it is not there.
fs::path findIn(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (fs::exists(folder / name, error)) return folder / name;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (plainName(entry->path().filename().string()) == plainName(name)) return entry->path();
  return {};
}

/// The parts of a Referenced File ID, separated by backslashes. Empty for a path that leaves the folder.
std::vector<std::string> partsOf(const std::string& id) {
  std::vector<std::string> parts(1);
  for (const char c : id)
    if (c == '\\')
      parts.emplace_back();
    else if (c != ' ' || !parts.back().empty())
      parts.back() += c;
  for (const std::string& part : parts)
    if (part.empty() || part == ".." || part.find('/') != std::string::npos) return {};
  return parts;
}

std::string listed(const std::vector<const fs::path*>& files) {
  constexpr std::size_t kNamed = 3;
  std::string names;
  for (std::size_t f = 0; f < std::min(kNamed, files.size()); ++f)
    names += (f == 0 ? "" : ", ") + files[f]->filename().string();
  return names + (files.size() > kNamed ? ", .." : "");
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// The files of `lost` that lie in a folder of the series and have the ending of its files.
std::vector<const fs::path*> beside(const SeriesInfo& info, const std::vector<fs::path>& lost) {
  std::set<std::pair<fs::path, std::string>> homes;
  for (const fs::path& file : info.files)
    homes.insert({file.parent_path(), plainName(file.extension().string())});
  std::vector<const fs::path*> found;
  for (const fs::path& file : lost)
    if (homes.count({file.parent_path(), plainName(file.extension().string())})) found.push_back(&file);
  return found;
}

}  // namespace

std::vector<fs::path> absentFilesOf(const fs::path& directory) {
  std::vector<fs::path> absent;
  try {
    FilePrefix file(directory);
    const gdcm::DataSet data = readElements(file);
    for (const gdcm::DataSet& record : items(data, {0x0004, 0x1220})) {
      const auto parts = partsOf(text(record, {0x0004, 0x1500}));
      if (parts.empty()) continue;
      fs::path place = directory.parent_path(), written = place;
      for (const std::string& part : parts) {
        written = (place.empty() ? written : place) / part;
        if (!place.empty()) place = findIn(place, part);
      }
      if (place.empty()) absent.push_back(written);
    }
  } catch (const Error&) {
    absent.clear();
  }
  return absent;
}

void noteLostFiles(std::vector<SeriesInfo>& series, const LostFiles& lost) {
  for (SeriesInfo& info : series) {
    if (info.series_uid.empty()) continue;
    const auto empty = beside(info, lost.empty), absent = beside(info, lost.absent);
    if (empty.empty() && absent.empty()) continue;
    std::string words;
    if (!empty.empty())
      words = counted(empty.size(), "file beside it is", "files beside it are") + " empty (" + listed(empty) +
              ")";
    if (!absent.empty())
      words +=
          (words.empty() ? "" : ", ") +
          counted(absent.size(), "file that the DICOMDIR lists is", "files that the DICOMDIR lists are") +
          " not there (" + listed(absent) + ")";
    if (info.is_loadable)
      info.notes.push_back(words + ": look whether the head is whole, or copy the scan again");
    else
      info.problem += "; " + words;
  }
}

void countStatedImages(std::vector<SeriesInfo>& series, const std::vector<SliceHeader>& headers) {
  struct Count {
    int stated = 0, present = 0;
    bool is_clear = true;  // every header states the same number
  };
  std::map<std::string, Count> counts;
  for (const SliceHeader& header : headers) {
    Count& count = counts[header.series_uid];
    count.is_clear &= count.present == 0 || count.stated == header.stated_images;
    count.stated = header.stated_images;
    ++count.present;
  }
  for (SeriesInfo& info : series) {
    const auto found = counts.find(info.series_uid);
    if (info.joined || found == counts.end() || !found->second.is_clear) continue;
    if (found->second.stated <= found->second.present) continue;
    info.stated_images = found->second.stated;
    info.missing_images = found->second.stated - found->second.present;
    if (info.is_loadable) judgeFitness(info);
  }
}

}  // namespace facenav::dicom
