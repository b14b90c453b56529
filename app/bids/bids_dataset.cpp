#include "bids/bids_dataset.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Folders of `parent` named "<kind>-<label>", as label and path, sorted.
std::vector<std::pair<std::string, fs::path>> labelledFolders(const fs::path& parent,
                                                              const std::string& kind) {
  std::vector<std::pair<std::string, fs::path>> folders;
  for (const auto& entry : fs::directory_iterator(parent)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && startsWith(name, kind + "-"))
      folders.emplace_back(name.substr(kind.size() + 1), entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::optional<fs::path> firstT1(const fs::path& anat) {
  if (!fs::is_directory(anat)) return std::nullopt;
  std::vector<fs::path> images;
  for (const auto& entry : fs::directory_iterator(anat)) {
    const std::string name = entry.path().filename().string();
    if (endsWith(name, "_T1w.nii.gz") || endsWith(name, "_T1w.nii")) images.push_back(entry.path());
  }
  if (images.empty()) return std::nullopt;
  return *std::min_element(images.begin(), images.end());
}

void addImagesOf(const std::string& participant, const fs::path& folder, std::vector<BidsImage>& images) {
  if (const auto t1 = firstT1(folder / "anat")) images.push_back({participant, "", *t1});
  for (const auto& [session, path] : labelledFolders(folder, "ses"))
    if (const auto t1 = firstT1(path / "anat")) images.push_back({participant, session, *t1});
}

void requireLabels(const std::vector<std::string>& labels, const std::vector<BidsImage>& images,
                   const fs::path& dataset) {
  for (const auto& label : labels)
    if (std::none_of(images.begin(), images.end(),
                     [&](const auto& image) { return image.participant == label; }))
      throw Error("no T1w image of participant '" + label + "'", dataset.string(),
                  "check --participant-label");
}

}  // namespace

std::string BidsImage::prefix() const {
  return "sub-" + participant + (session.empty() ? "" : "_ses-" + session);
}

std::vector<BidsImage> findT1Images(const fs::path& dataset, const std::vector<std::string>& labels) {
  if (!fs::is_regular_file(dataset / "dataset_description.json"))
    throw Error("is no BIDS dataset (no dataset_description.json in it)", dataset.string(), "check the path");
  std::vector<std::string> wanted;
  for (const auto& label : labels) wanted.push_back(startsWith(label, "sub-") ? label.substr(4) : label);
  std::vector<BidsImage> images;
  for (const auto& [participant, folder] : labelledFolders(dataset, "sub"))
    if (wanted.empty() || std::count(wanted.begin(), wanted.end(), participant))
      addImagesOf(participant, folder, images);
  requireLabels(wanted, images, dataset);
  if (images.empty())
    throw Error("no T1w image in any sub-*/[ses-*/]anat", dataset.string(), "check the dataset");
  return images;
}

void writeDerivativesDescription(const fs::path& output, const fs::path& dataset,
                                 const std::string& software_version) {
  const fs::path path = output / "dataset_description.json";
  if (fs::exists(path)) {
    const auto known = nlohmann::json::parse(readWholeFile(path), nullptr, false);
    if (known.is_discarded() || known.value("Name", "") != "FaceNav case models")
      throw Error("holds another dataset", output.string(), "choose another output folder");
  }
  nlohmann::ordered_json json;
  json["Name"] = "FaceNav case models";
  json["BIDSVersion"] = "1.8.0";
  json["DatasetType"] = "derivative";
  json["GeneratedBy"] = {{{"Name", "FaceNav"}, {"Version", software_version}}};
  json["SourceDatasets"] = {{{"URL", "file://" + fs::absolute(dataset).string()}}};
  writeWholeFile(path, json.dump(1) + "\n", FileAccess::by_umask);
  writeWholeFile(output / ".bidsignore", "*/case/\n*/*/case/\nlogs/\n", FileAccess::by_umask);
}

}  // namespace facenav::app
