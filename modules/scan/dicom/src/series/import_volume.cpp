#include "facenav/dicom/import_volume.h"

#include <algorithm>
#include <map>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/dicom/patient.h"
#include "header/patient_identity.h"
#include "series_scan.h"

namespace facenav::dicom {
namespace fs = std::filesystem;
namespace {

std::string gridInWords(const volume::VoxelGrid& grid) {
  const Eigen::Vector3d spacing_mm = grid.spacing_mm();
  return formatted("%d x %d x %d voxels of %.3g x %.3g x %.3g mm", grid.size[0], grid.size[1], grid.size[2],
                   spacing_mm[0], spacing_mm[1], spacing_mm[2]);
}

ImportedVolume importNifti(const fs::path& path, volume::NiftiTransform transform) {
  auto read = volume::readNifti(path, transform);
  ImportedVolume imported;
  imported.volume = std::move(read.volume);
  imported.description = {"NIfTI: " + gridInWords(imported.volume.grid),
                          "left and right rest on the file's " + read.evidence};
  if (read.warning) imported.warnings.push_back(*read.warning);
  if (read.is_template_space)
    imported.warnings.push_back(
        "the file says that the scan was fitted to a template: its size and shape are then the "
        "template's, not the patient's; use the scan as acquired");
  return imported;
}

[[noreturn]] void refuse(const SeriesInfo& info, const fs::path& input) {
  const fs::path& at = info.problem_file.empty() ? input : info.problem_file;
  throw Error(info.problem, at.string(),
              "choose another series or export it again ('facenav series' lists them)");
}

/// Throws Error if neither skin nor brain can be found in this kind of image.
void requireSkin(const SeriesInfo& info, const fs::path& input) {
  if (!isWithoutSkin(info.kind)) return;
  const fs::path& at = info.files.size() == 1 ? info.files.front() : input;
  const std::string name = info.description.empty() ? "this series" : "series '" + info.description + "'";
  throw Error(name + " is " + withArticle(info.kind) + ", in which no skin can be found", at.string(),
              "choose the magnitude images of a T1 ('facenav series' lists them)");
}

/// Throws Error for an image with marks in its voxels, which would count as tissue.
void requireNoMarks(const SeriesInfo& info, const fs::path& input) {
  if (info.kind == ImageKind::annotated)
    throw Error("series '" + info.description + "' is " + withArticle(info.kind), input.string(),
                "use the series that it was made from, or name it with --series");
}

/// Names what the series are: " (2 phase image, T1 map)"; empty if all are plain images.
std::string kindsOf(const std::vector<SeriesInfo>& series) {
  std::map<ImageKind, int> counts;
  for (const SeriesInfo& info : series)
    if (info.kind != ImageKind::magnitude) ++counts[info.kind];
  std::string words;
  for (const auto& [kind, count] : counts)
    words += (words.empty() ? "" : ", ") + (count > 1 ? std::to_string(count) + " x " : "") + inWords(kind);
  return words.empty() ? "" : " (" + words + ")";
}

const SeriesInfo& chooseById(const std::vector<SeriesInfo>& series, const std::string& id,
                             const fs::path& input) {
  for (const auto& info : series)
    if (info.id == id) {
      if (!info.is_loadable) refuse(info, input);
      requireSkin(info, input);
      return info;
    }
  throw Error("holds no series '" + id + "'", input.string(), "'facenav series' lists them");
}

/// Throws Error if the images do not show which of several patients is meant.
void requireOnePatient(const std::vector<SeriesInfo>& series, const fs::path& input) {
  if (const int count = patientCount(series); count > 1)
    throw Error("holds images of " + std::to_string(count) + " patients", input.string(),
                "choose one with --series ('facenav series --patients' shows the patients)");
}

/// Throws Error if the same slices have several readings.
void requireOneReading(const std::vector<SeriesInfo>& series, const fs::path& input) {
  const int count = readingCount(series);
  if (count == 0) return;
  std::string parts;
  for (const SeriesInfo& info : series)
    if (info.is_loadable && isOneOfSeveralReadings(info)) parts += (parts.empty() ? "" : "; ") + info.part;
  throw Error("holds slices with series UIDs of their own that can be read in " + std::to_string(count) +
                  (count == 1 ? " way (" : " ways (") + parts + ")",
              input.string(), "choose one with --series ('facenav series' lists them)");
}

const SeriesInfo& choose(const std::vector<SeriesInfo>& series, const fs::path& input) {
  requireOnePatient(series, input);
  // A small readable series must not silently replace a larger damaged one.
  const auto largest =
      std::max_element(series.begin(), series.end(), [](const SeriesInfo& a, const SeriesInfo& b) {
        return (a.is_loadable ? 0 : a.slices) < (b.is_loadable ? 0 : b.slices);
      });
  const auto loadable =
      std::count_if(series.begin(), series.end(), [](const SeriesInfo& s) { return s.is_loadable; });
  if (loadable == 0) refuse(*largest, input);
  for (const auto& info : series)
    if (info.is_recommended) return info;
  requireOneReading(series, input);
  if (loadable > 1)
    throw Error(
        "holds " + std::to_string(loadable) + " series, none of them a 3-D T1 of a head" + kindsOf(series),
        input.string(), "choose one with --series ('facenav series' lists them)");
  const SeriesInfo& only =
      *std::find_if(series.begin(), series.end(), [](const SeriesInfo& s) { return s.is_loadable; });
  if (!largest->is_loadable && largest->slices > only.slices) refuse(*largest, input);
  requireSkin(only, input);
  requireNoMarks(only, input);
  return only;
}

/// Series of the file's folder: a single slice means its whole series.
std::vector<SeriesInfo> seriesAround(const fs::path& file, TaskMonitor& monitor) {
  auto alone = scanFiles({file}, file.string(), monitor);
  if (alone[0].is_loadable || alone[0].problem_kind != SeriesProblem::single_slice ||
      alone[0].series_uid.empty())
    return alone;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  auto around = scanFiles(filesUnder(folder, false), folder.string(), monitor);
  // Keeps only the file's own patient: another patient's images may carry the same UID.
  const Patient whose = patientOf(alone[0]);
  const auto is_file = [&](const fs::path& other) { return other.filename() == file.filename(); };
  const auto holds = [&](const SeriesInfo& s) {
    return s.series_uid == alone[0].series_uid ||
           (s.joined && std::any_of(s.files.begin(), s.files.end(), is_file));
  };
  const auto is_other = [&](const SeriesInfo& s) { return !holds(s) || !isSamePatient(patientOf(s), whose); };
  around.erase(std::remove_if(around.begin(), around.end(), is_other), around.end());
  return around.empty() ? alone : around;
}

void describe(ImportedVolume& imported, std::size_t series_count) {
  const SeriesInfo& info = *imported.series;
  const std::string name = info.description.empty() ? "without description" : "'" + info.description + "'";
  imported.description.push_back("DICOM " + info.modality + " series " + name +
                                 (info.part.empty() ? "" : ", " + info.part) + ", " + info.plane + ": " +
                                 gridInWords(imported.volume.grid));
  if (series_count > 1)
    imported.description.push_back("chosen from " + std::to_string(series_count) + " series" +
                                   (info.is_recommended ? ", the best T1 for navigation" : ""));
  imported.description.push_back(
      "left and right rest on Image Position and Orientation (Patient), as the scanner wrote them");
  if (info.joined) imported.warnings.push_back(inWords(*info.joined));
  imported.warnings.insert(imported.warnings.end(), info.notes.begin(), info.notes.end());
  if (!info.is_fit_for_navigation) imported.warnings.push_back(info.fitness);
}

}  // namespace

ImportedVolume importVolume(const fs::path& input, const std::optional<std::string>& series_id,
                            TaskMonitor& monitor, volume::NiftiTransform transform) {
  std::error_code error;
  if (!fs::exists(input, error)) throw Error("does not exist", input.string(), "check the path");
  const bool is_folder = fs::is_directory(input, error) || isDicomDir(input);
  if (!is_folder && volume::isNiftiName(input)) return importNifti(input, transform);
  const auto series = is_folder ? listSeries(input, monitor) : seriesAround(input, monitor);
  ImportedVolume imported;
  imported.series = series_id ? chooseById(series, *series_id, input) : choose(series, input);
  imported.volume = loadSeries(*imported.series, monitor);
  describe(imported, series.size());
  return imported;
}

}  // namespace facenav::dicom
