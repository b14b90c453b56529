#include "facenav/plan/export_dicom.h"

#include "facenav/casefile/case_coil.h"
#include "facenav/core/error.h"
#include "facenav/core/software_version.h"
#include "facenav/dicom/derived_objects.h"
#include "facenav/pictures/burnt_plan.h"
#include "facenav/prepare/case_source.h"

namespace facenav::steps {
namespace {

std::vector<guidance::Target> chosenTargets(const casefile::CaseStore& store, const DicomExport& order) {
  const auto plan = store.targets();
  if (order.targets.empty()) {
    if (plan.targets.empty())
      throw Error("the case has no target to draw", store.folder().string(), "plan one first");
    if (plan.targets.size() > 1)
      throw Error("the case has " + std::to_string(plan.targets.size()) + " targets", store.folder().string(),
                  "name those to draw with --target");
    return plan.targets;
  }
  std::vector<guidance::Target> targets;
  for (const auto& name : order.targets) targets.push_back(plan.find(name));
  return targets;
}

std::string namesOf(const std::vector<guidance::Target>& targets) {
  std::string names;
  for (const auto& target : targets) names += (names.empty() ? "" : ", ") + target.name;
  return names;
}

}  // namespace

ExportedSeries exportDicomSegments(const casefile::CaseStore& store, const DicomExport& order,
                                   TaskMonitor& monitor) {
  if (std::filesystem::exists(order.output) && !order.replaces)
    throw Error("the file exists already", order.output.string(), "choose another name, or --replace");
  const auto targets = chosenTargets(store, order);
  const auto source = sourceOf(store, order.source, monitor);
  std::vector<dicom::Segment> segments;
  for (auto& mask : pictures::planMasks(source.volume.grid, targets, casefile::coilOf(store.folder()).plate))
    segments.push_back({mask.label, std::move(mask.mask), mask.is_coil});
  dicom::writeSegmentation(source.series, segments, "FaceNav plan: " + namesOf(targets), order.output,
                           monitor);
  ExportedSeries exported{1, {}};
  for (const auto& target : targets) exported.targets.push_back(target.name);
  return exported;
}

ExportedSeries exportDicomMr(const casefile::CaseStore& store, const DicomExport& order,
                             TaskMonitor& monitor) {
  const auto targets = chosenTargets(store, order);
  const auto coil = casefile::coilOf(store.folder());
  const auto source = sourceOf(store, order.source, monitor);
  const auto burnt = pictures::burnPlan(source.volume, targets, coil.plate);
  ExportedSeries exported;
  for (const auto& target : targets) exported.targets.push_back(target.name);
  const std::string names = namesOf(targets);
  dicom::DerivedSeries words;
  words.description = "FaceNav, not for diagnosis: " + names;
  words.derivation = "FaceNav " + softwareVersion() + ": planned target and coil (" +
                     (coil.name.empty() ? "figure of eight" : coil.name) +
                     ") drawn into the voxels, not for diagnosis: " + names;
  words.black = burnt.black;
  words.white = burnt.white;
  exported.images =
      dicom::writeDerivedSeries(source.series, burnt.volume, words, order.output, order.replaces, monitor);
  return exported;
}

}  // namespace facenav::steps
