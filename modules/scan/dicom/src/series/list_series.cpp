#include <algorithm>
#include <map>
#include <set>

#include "bytes/damage_error.h"
#include "bytes/for_files.h"
#include "facenav/core/error.h"
#include "facenav/dicom/patient.h"
#include "header/patient_identity.h"
#include "lost_files.h"
#include "mixed_images.h"
#include "other_files.h"
#include "series_groups.h"
#include "series_scan.h"
#include "series_verdict.h"
#include "value_check.h"

namespace facenav::dicom {
namespace fs = std::filesystem;
namespace {

constexpr char kDicomDirClass[] = "1.2.840.10008.1.3.10";  // Media Storage Directory Storage

struct DamagedFile {
  fs::path file;
  std::string problem, start;  // `start`: first bytes, where its Series UID may still be readable
};

/// Tests the meta header. A DICOMDIR lists files that are found anyway, so it is skipped, damaged or not.
bool isDicomDir(FilePrefix& file) {
  constexpr std::uint64_t kPreamble = 132, kMetaHeader = 512;
  const std::string& bytes = file.bytes();
  if (!file.ensure(kPreamble) || bytes.compare(128, 4, "DICM") != 0) return false;
  file.ensure(std::min(file.fileSize(), kPreamble + kMetaHeader));
  return bytes.substr(kPreamble, kMetaHeader).find(kDicomDirClass) != std::string::npos;
}

/// Content of one file: an image, damage, a DICOMDIR, nothing at all, or something else.
struct ScannedFile {
  std::optional<SliceHeader> header;
  std::optional<DamagedFile> damage;
  bool is_empty = false, is_dicom_dir = false;
};

ScannedFile scanFile(const fs::path& path) {
  constexpr std::uint64_t kStart = 16 << 10;
  std::optional<FilePrefix> file;
  try {
    file.emplace(path);
    if (file->fileSize() == 0) return {{}, {}, true, false};
    if (isDicomDir(*file)) return {{}, {}, false, true};
    return {readSliceHeader(*file), {}};
  } catch (const DamageError& damage) {
    const std::string& bytes = file->bytes();
    if (bytes.size() < 132 || bytes.compare(128, 4, "DICM") != 0) return {};  // not DICOM
    return {{}, DamagedFile{path, damage.fault(), bytes.substr(0, kStart)}};
  } catch (const Error&) {
    return {{}, DamagedFile{path, "cannot be read", ""}};
  }
}

/// A damaged file makes the series with its UID unloadable; if no series has that UID, those in its folder.
void applyDamage(std::vector<SeriesInfo>& series, const std::vector<DamagedFile>& damaged) {
  for (const DamagedFile& damage : damaged) {
    const auto carries = [&](const SeriesInfo& info) {
      return !info.series_uid.empty() && damage.start.find(info.series_uid) != std::string::npos;
    };
    const bool is_known = std::any_of(series.begin(), series.end(), carries);
    for (SeriesInfo& info : series) {
      const bool lies_beside = std::any_of(info.files.begin(), info.files.end(), [&](const fs::path& file) {
        return file.parent_path() == damage.file.parent_path();
      });
      if (!(is_known ? carries(info) : lies_beside) || !info.is_loadable) continue;
      info.is_loadable = info.is_fit_for_navigation = false;
      info.problem_kind = SeriesProblem::damaged;
      info.problem = "a file beside it is damaged: " + damage.problem;
      info.problem_file = damage.file;
    }
  }
}

SeriesInfo damagedEntry(const DamagedFile& damage) {
  SeriesInfo info;
  info.description = damage.file.filename().string();
  info.files = {damage.file};
  info.problem_kind = SeriesProblem::damaged;
  info.problem = damage.problem;
  info.problem_file = damage.file;
  return info;
}

void numberParts(std::vector<SeriesInfo>& series) {
  std::map<std::string, int> seen;
  for (SeriesInfo& info : series)
    if (const int count = ++seen[info.series_uid]; count > 1) info.id += "#" + std::to_string(count);
}

/// A series of a few thick slices in several planes is a localizer, whatever its name.
void nameLocalizers(std::vector<SeriesInfo>& series) {
  constexpr int kMostSlices = 30;
  constexpr double kThick_mm = 3;
  const auto isThin = [](const SeriesInfo& s) {
    return s.slices > kMostSlices || (s.spacing_mm[2] > 0 && s.spacing_mm[2] < kThick_mm);
  };
  for (SeriesInfo& info : series) {
    std::set<std::string> planes;
    bool is_localizer =
        info.modality == "MR" && info.kind == ImageKind::magnitude && !info.series_uid.empty();
    for (const SeriesInfo& other : series)
      if (other.series_uid == info.series_uid) {
        is_localizer &= !isThin(other);
        planes.insert(other.plane);
      }
    if (!is_localizer || planes.size() < 2) continue;
    info.kind = ImageKind::localizer;
    if (info.is_loadable) judgeFitness(info);
  }
}

/// Candidates for the navigation T1 are magnitude images by their values, too.
void checkValues(std::vector<SeriesInfo>& series) {
  for (SeriesInfo& info : series) {
    if (info.kind != ImageKind::magnitude || navigationScore(info) <= 0 || hasDarkAir(info)) continue;
    info.kind = ImageKind::signed_or_uniform;
    judgeFitness(info);
  }
}

void recommend(std::vector<SeriesInfo>& series) {
  std::stable_sort(series.begin(), series.end(), [](const SeriesInfo& a, const SeriesInfo& b) {
    const double score_a = navigationScore(a), score_b = navigationScore(b);
    if (score_a != score_b) return score_a > score_b;
    if (a.is_loadable != b.is_loadable) return a.is_loadable;
    return a.series_number < b.series_number;
  });
  if (patientCount(series) > 1) return;  // only a person knows whose head is meant
  if (series.empty() || isOneOfSeveralReadings(series.front())) return;  // a person must choose
  if (navigationScore(series.front()) > 0) series.front().is_recommended = true;
}

}  // namespace

std::vector<fs::path> filesUnder(const fs::path& folder, bool is_recursive) {
  std::error_code error;
  if (!fs::exists(folder, error)) throw Error("does not exist", folder.string(), "check the path");
  std::vector<fs::path> files;
  if (fs::is_regular_file(folder, error)) return {folder};
  const auto options = fs::directory_options::skip_permission_denied;
  const auto collect = [&](auto iterator) {
    for (const auto end = decltype(iterator)(); iterator != end; iterator.increment(error)) {
      if (error) break;
      if (iterator->is_regular_file(error)) files.push_back(iterator->path());
    }
  };
  if (is_recursive)
    collect(fs::recursive_directory_iterator(folder, options, error));
  else
    collect(fs::directory_iterator(folder, options, error));
  if (files.empty()) throw Error("holds no files", folder.string(), "check the path and its permissions");
  std::sort(files.begin(), files.end());
  return files;
}

std::optional<SliceHeader> readHeaderOf(const fs::path& path) {
  FilePrefix file(path);
  return readSliceHeader(file);
}

bool isDicomDir(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  try {
    FilePrefix file(path);
    return isDicomDir(file);
  } catch (const Error&) {
    return false;
  }
}

std::vector<SeriesInfo> scanFiles(const std::vector<fs::path>& files, const std::string& where,
                                  TaskMonitor& monitor) {
  std::vector<ScannedFile> scanned(files.size());
  forFiles(files.size(), monitor, "reading DICOM headers",
           [&](std::size_t f, std::size_t) { scanned[f] = scanFile(files[f]); });
  std::vector<SliceHeader> headers;
  std::vector<DamagedFile> damaged;
  LostFiles lost;
  for (std::size_t f = 0; f < files.size(); ++f) {
    ScannedFile& file = scanned[f];
    if (file.is_empty) lost.empty.push_back(files[f]);
    if (file.is_dicom_dir)
      for (fs::path& absent : absentFilesOf(files[f])) lost.absent.push_back(std::move(absent));
    if (file.header) headers.push_back(std::move(*file.header));
    if (file.damage) damaged.push_back(std::move(*file.damage));
  }
  if (headers.empty() && damaged.size() == 1)
    throw Error(damaged[0].problem, damaged[0].file.string(), "copy it again");
  if (headers.empty() && damaged.empty()) throw noDicomIn(files, where);
  numberPatients(headers);
  std::vector<SeriesInfo> series;
  const std::vector<SeriesGroup> groups = groupImages(headers);
  for (const SeriesGroup& group : groups) series.push_back(describeGroup(headers, group));
  numberParts(series);
  nameMixedImages(series, headers, groups);
  countStatedImages(series, headers);
  noteLostFiles(series, lost);
  applyDamage(series, damaged);
  for (const DamagedFile& damage : damaged) series.push_back(damagedEntry(damage));
  nameLocalizers(series);
  checkValues(series);
  recommend(series);
  monitor.report("reading DICOM headers", 1.0);
  return series;
}

std::vector<SeriesInfo> listSeries(const fs::path& folder, TaskMonitor& monitor) {
  if (isDicomDir(folder)) {  // its files lie under its folder (PS3.10 8.6), with others perhaps
    const fs::path whole = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
    return scanFiles(filesUnder(whole, true), whole.string(), monitor);
  }
  return scanFiles(filesUnder(folder, true), folder.string(), monitor);
}

}  // namespace facenav::dicom
