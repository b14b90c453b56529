// facenav series DIR [--json] [--thumbnails OUT] [--patients]: lists the DICOM series under DIR, one a line,
// the recommended one first. On request with a small picture of each and the patient's name.

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/dicom/patient.h"
#include "facenav/dicom/series.h"
#include "facenav/dicom/thumbnail.h"
#include "facenav/scene/png.h"

namespace facenav::app {
namespace {

std::string number(double value) { return formatted("%.3g", value); }

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (const auto& part : parts) text += (text.empty() || part.empty() ? "" : between) + part;
  return text;
}

std::string stateOf(const dicom::SeriesInfo& info) {
  if (!info.is_loadable) {
    const std::string file = info.problem_file.empty() || info.files.size() < 2
                                 ? ""
                                 : " (" + info.problem_file.filename().string() + ")";
    return "not loadable: " + info.problem + file;
  }
  std::vector<std::string> words = info.notes;
  if (info.joined) words.insert(words.begin(), dicom::inWords(*info.joined));
  words.insert(words.begin(), info.fitness);
  return (info.is_recommended ? "recommended, " : "") + joined(words, "; ");
}

using Row = std::vector<std::string>;

/// Names the patient of each series: "patient 2" if there are several, the name on request.
std::vector<std::string> owners(const std::vector<dicom::SeriesInfo>& series, bool are_named) {
  std::vector<std::string> words(series.size());
  if (!are_named && dicom::patientCount(series) < 2) return words;
  for (std::size_t s = 0; s < series.size(); ++s)
    if (series[s].patient)
      words[s] = are_named ? dicom::inWords(dicom::patientOf(series[s]))
                           : "patient " + std::to_string(*series[s].patient);
  return words;
}

Row rowOf(const dicom::SeriesInfo& info, const std::string& owner) {
  const std::string name = (info.description.empty() ? "(no description)" : info.description) +
                           (info.part.empty() ? "" : ", " + info.part);
  std::string shape =
      std::to_string(info.columns) + " x " + std::to_string(info.rows) + " x " + std::to_string(info.slices);
  if (info.spacing_mm[2] > 0)
    shape += ", " + number(info.spacing_mm[0]) + " x " + number(info.spacing_mm[1]) + " x " +
             number(info.spacing_mm[2]) + " mm";
  if (info.rows == 0) shape = "-";
  return {info.is_recommended ? "*" : " ",
          name,
          info.date,
          info.modality,
          info.contrast,
          shape,
          info.plane,
          owner,
          stateOf(info),
          info.id};
}

/// Prints the table. Each column is as wide as its widest entry; empty columns are left out.
void printTable(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.empty() ? 0 : rows[0].size());
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      if (widths[c] > 0) line += row[c] + std::string(widths[c] - row[c].size() + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    std::printf("%s\n", line.c_str());
  }
}

nlohmann::json toJson(const dicom::JoinedSlices& joined) {
  const auto names = [](const std::vector<dicom::SliceTrait>& traits) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto trait : traits) list.push_back(dicom::toString(trait));
    return list;
  };
  return {{"finding", dicom::findingId(joined)},
          {"in_words", dicom::inWords(joined)},
          {"series_uids", joined.series_uids},
          {"study_uids", joined.study_uids},
          {"frame_of_reference_uids", joined.frame_of_reference_uids},
          {"frame_of_reference_uid", joined.frame_of_reference_uid},
          {"agreeing", names(joined.agreeing)},
          {"unstated", names(joined.unstated)},
          {"readings", joined.readings}};
}

nlohmann::json toJson(const dicom::SeriesInfo& info) {
  nlohmann::json files = nlohmann::json::array();
  for (const auto& file : info.files) files.push_back(file.string());
  const auto triple = [](const Eigen::Vector3d& v) { return nlohmann::json{v[0], v[1], v[2]}; };
  return {{"id", info.id},
          {"series_uid", info.series_uid},
          {"study_uid", info.study_uid},
          {"description", info.description},
          {"part", info.part},
          {"patient", info.patient.value_or(0)},
          {"date", info.date},
          {"modality", info.modality},
          {"kind", dicom::idOf(info.kind)},
          {"contrast", info.contrast},
          {"series_number", info.series_number},
          {"rows", info.rows},
          {"columns", info.columns},
          {"slices", info.slices},
          {"spacing_mm", triple(info.spacing_mm)},
          {"extent_mm", triple(info.extent_mm)},
          {"plane", info.plane},
          {"loadable", info.is_loadable},
          {"problem", info.problem},
          {"problem_id", dicom::idOf(info.problem_kind)},
          {"problem_file", info.problem_file.string()},
          {"notes", info.notes},
          {"fit_for_navigation", info.is_fit_for_navigation},
          {"fitness", info.fitness},
          {"recommended", info.is_recommended},
          {"files", files}};
}

RgbImage toRgb(const dicom::Thumbnail& picture) {
  RgbImage image(picture.width_px, picture.height_px);
  for (std::size_t i = 0; i < picture.grey.size(); ++i)
    std::fill_n(image.rgb.begin() + std::ptrdiff_t(3 * i), 3, picture.grey[i]);
  return image;
}

/// Writes one PNG a series, named by its position in the list (01.png). Returns the names, empty for a series
/// without a picture.
std::vector<std::string> writeThumbnails(const std::vector<dicom::SeriesInfo>& series,
                                         const std::filesystem::path& folder, TaskMonitor& monitor) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault)
    throw Error("cannot be made (" + fault.message() + ")", folder.string(), "choose another folder");
  std::vector<std::string> names(series.size());
  for (std::size_t s = 0; s < series.size(); ++s) {
    monitor.report("drawing thumbnails", double(s) / double(series.size()));
    const auto picture = dicom::makeThumbnail(series[s]);
    if (!picture) continue;
    const std::string number = std::to_string(s + 1);
    names[s] = std::string(number.size() < 2 ? "0" : "") + number + ".png";
    scene::writePng(toRgb(*picture), folder / names[s]);
  }
  return names;
}

}  // namespace

void addSeries(CLI::App& app, Context& context) {
  struct Options {
    std::string folder, thumbnails;
    bool is_json = false, are_patients_named = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("series", "list the DICOM series found under a folder");
  verb->add_option("DIR", options->folder, "a folder (with all below it), a DICOMDIR, or one DICOM file")
      ->required();
  verb->add_flag("--json", options->is_json, "everything known about each series, as JSON");
  verb->add_flag("--patients", options->are_patients_named, "show each patient: name, birth date, sex, ID");
  verb->add_option("--thumbnails", options->thumbnails,
                   "folder for a PNG of each series' middle image: 01.png is the first of the list, ..");
  verb->callback([options, &context] {
    const auto series = dicom::listSeries(options->folder, context.monitor);
    std::vector<std::string> pictures(series.size());
    if (!options->thumbnails.empty())
      pictures = writeThumbnails(series, options->thumbnails, context.monitor);
    const auto patients = owners(series, options->are_patients_named);
    if (options->is_json) {
      nlohmann::json list = nlohmann::json::array();
      for (std::size_t s = 0; s < series.size(); ++s) {
        list.push_back(toJson(series[s]));
        if (series[s].joined) list.back()["joined_slices"] = toJson(*series[s].joined);
        if (options->are_patients_named) list.back()["patient_in_words"] = patients[s];
        if (!pictures[s].empty()) list.back()["thumbnail"] = pictures[s];
      }
      const auto replace = nlohmann::json::error_handler_t::replace;  // file names need not be UTF-8
      std::printf("%s\n", list.dump(2, ' ', false, replace).c_str());
    } else {
      std::vector<Row> rows;
      for (std::size_t s = 0; s < series.size(); ++s) rows.push_back(rowOf(series[s], patients[s]));
      printTable(rows);
    }
  });
}

}  // namespace facenav::app
