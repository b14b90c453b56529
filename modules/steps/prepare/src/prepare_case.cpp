#include "facenav/prepare/prepare_case.h"

#include <future>

#include "facenav/casefile/case_place.h"
#include "facenav/casefile/edited_brain.h"
#include "facenav/casefile/sha256.h"
#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/software_version.h"
#include "facenav/dicom/import_volume.h"
#include "facenav/dicom/patient.h"
#include "facenav/pictures/face_measures_picture.h"
#include "facenav/prepare/case_pictures.h"
#include "facenav/prepare/case_source.h"
#include "facenav/prepare/preparation.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

/// Returns the atlas, or a warning if there is none: a case is valid without MNI coordinates.
std::optional<atlas::BrainTemplate> installedAtlas(std::vector<std::string>& warnings) {
  try {
    return atlas::readColin27();
  } catch (const Error& error) {
    warnings.push_back(std::string("no MNI coordinates: ") + error.what());
    return std::nullopt;
  }
}

/// Draws the face's measures; empty if the face was not measured.
RgbImage faceMeasuresPicture(const casefile::PreparedCase& prepared) {
  const auto& check = prepared.navigation_check;
  if (!check || check->landmarks.points.empty()) return {};
  return pictures::drawFaceMeasures(prepared.scalp, check->landmarks, check->measures);
}

/// Draws the surface distance; empty if there is no cortex.
RgbImage distancePicture(const casefile::PreparedCase& prepared) {
  if (!prepared.cortex || !prepared.brain_quality) return {};
  const auto& q = *prepared.brain_quality;
  return surfaceDistancePicture(
      *prepared.cortex, {{q.surface_median_mm, q.surface_p95_mm, 0}, {q.model_median_mm, q.model_p95_mm, 0}});
}

/// Returns at most `most` bytes of UTF-8 text; never cuts a character.
std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

/// Returns the label; empty if none was asked for or is available (the description then reports it).
std::string labelOf(const PrepareRequest& request, dicom::ImportedVolume& imported) {
  if (!request.is_labelled_by_patient) return casefile::asLabel(request.label);
  const std::string name = imported.series ? dicom::nameInWords(dicom::patientOf(*imported.series)) : "";
  if (name.empty()) imported.description.push_back("no patient is named: the case has no label");
  return casefile::asLabel(shortened(name, casefile::kLongestLabel));
}

}  // namespace

PrepareOutcome prepareCase(const Registrations& methods, const PrepareRequest& request,
                           TaskMonitor& monitor) {
  if (fs::exists(request.case_folder) && !request.replace)
    throw Error(
        "exists already", request.case_folder.string(),
        "choose another folder, or --replace to model this scan again (targets and sessions are kept)");
  if (!request.discard_edits) casefile::requireNoEditsIn(request.case_folder);  // refuse early
  const auto parent = fs::absolute(request.case_folder / ".").lexically_normal().parent_path().parent_path();
  if (!fs::is_directory(parent))  // refuse early
    throw Error("no such folder to make the case in", parent.string(), "create it first");
  casefile::requireWritablePlace(request.case_folder, request.replace);  // refuse early
  const auto head = methods.head_segmenters.create(request.head_segmenter);
  const auto brain = methods.brain_segmenters.create(request.brain_segmenter);
  std::vector<std::string> atlas_warnings;
  const std::shared_future<std::optional<atlas::BrainTemplate>> colin =
      std::async(std::launch::async, [&atlas_warnings] { return installedAtlas(atlas_warnings); });
  auto imported = dicom::importVolume(request.input, request.series_uid, monitor,
                                      volume::niftiTransformNamed(request.nifti_transform));
  casefile::requireTargetsStay(request.case_folder, imported.volume);  // refuse early
  casefile::requireSpaceFor(request.case_folder, imported.volume);
  const std::string label = labelOf(request, imported);
  auto prepared = prepare(std::move(imported.volume), *head, *brain, monitor,
                          [&colin] { return colin.get() ? &*colin.get() : nullptr; });
  colin.wait();  // wait even if it was not used
  imported.warnings.insert(imported.warnings.end(), atlas_warnings.begin(), atlas_warnings.end());
  prepared.label = label;
  if (!prepared.contrast.empty()) imported.description.push_back("contrast: looks like " + prepared.contrast);
  if (const auto changed = changedSettingsFinding("made")) imported.warnings.push_back(*changed);
  prepared.findings.insert(prepared.findings.begin(), imported.warnings.begin(), imported.warnings.end());
  monitor.report("writing the case", 0.0);
  casefile::Provenance step{"prepare",
                            softwareVersion(),
                            {{"head", request.head_segmenter},
                             {"brain", request.brain_segmenter},
                             {"nifti_transform", request.nifti_transform}},
                            {{"input", casefile::sha256OfInput(request.input)}}};
  if (imported.series)
    step.input_sha256[kSeriesUidHash] = casefile::sha256OfText(imported.series->series_uid);
  // Draws while files are written.
  auto face_picture = std::async(std::launch::async, [&prepared] { return faceMeasuresPicture(prepared); });
  auto distance_picture = std::async(std::launch::async, [&prepared] { return distancePicture(prepared); });
  auto store = casefile::CaseStore::create(request.case_folder, prepared, {step}, request.replace,
                                           request.discard_edits);
  if (const RgbImage picture = distance_picture.get(); !picture.empty())
    writePrivatePng(picture, store.folder() / "surface_distance.png");
  if (const RgbImage picture = face_picture.get(); !picture.empty())
    writePrivatePng(picture, store.folder() / "face_measures.png");
  std::optional<double> brain_ml;
  if (prepared.brain_mask) brain_ml = prepared.brain_mask->volume_ml();
  return {std::move(store), imported.description, prepared.findings, brain_ml,
          std::move(prepared.navigation_check)};
}

}  // namespace facenav::steps
