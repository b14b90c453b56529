#include "facenav/prepare/preparation.h"

#include <cmath>
#include <cstdio>
#include <future>
#include <mutex>

#include "facenav/anatomy/brain_norms.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/measured_face/skin_model.h"
#include "facenav/prepare/brain_confidence.h"
#include "facenav/prepare/brain_surfaces.h"

namespace facenav::steps {
namespace {

struct HeadPart {
  volume::Mask mask;
  surface::ScalpSurface scalp;
  surface::NavigationCheck check;
  std::vector<std::string> warnings;
};
/// Returns the field, or null if no face can be aligned to the scalp: the case is complete without it.
std::shared_ptr<const registration::ScalpField> fieldOf(const surface::ScalpSurface& scalp) {
  if (!scalp.has_face) return {};
  try {
    return std::make_shared<const registration::ScalpField>(measured_face::skinModel(asStored(scalp)));
  } catch (const Error& error) {  // the alignment reports the same error
    logWarning(std::string("no face could be aligned to this scalp: ") + error.what());
    return {};
  }
}

struct BrainPart {
  std::optional<volume::Mask> mask;
  std::optional<surface::BrainModel> model;
  std::optional<surface::DetailedCortex> cortex;
  std::optional<atlas::AtlasMap> atlas;
  std::optional<casefile::BrainQuality> quality;
  std::string contrast;
  std::vector<std::string> findings;
};

HeadPart prepareHead(const volume::Volume& mri, const segmentation::Segmenter& segmenter,
                     TaskMonitor& monitor) {
  auto result = segmenter.segment(mri, monitor);
  auto scalp = surface::extractScalp(mri, result.mask, monitor);
  auto check = surface::checkForNavigation(mri, result.mask, scalp);
  return {std::move(result.mask), std::move(scalp), std::move(check), std::move(result.warnings)};
}

/// Findings of the check that must be acknowledged. Findings that repeat the scalp's own, or that apply to
/// every file of this kind, are shown but need no acknowledgement.
std::vector<std::string> worthAcknowledging(const surface::NavigationCheck& check) {
  std::vector<std::string> lines;
  for (const auto& finding : check.findings) {
    const bool is_said = finding.topic == surface::CheckTopic::face ||
                         finding.topic == surface::CheckTopic::ears ||
                         finding.topic == surface::CheckTopic::left_and_right;
    if (!is_said && finding.verdict != surface::Verdict::fine) lines.push_back(inWords(finding));
  }
  return lines;
}

void registerTo(const atlas::BrainTemplate& atlas, const volume::Volume& mri, BrainPart& part,
                TaskMonitor& monitor) {
  auto fit = atlas::registerAtlas(mri, *part.mask, atlas, {}, monitor);
  if (fit.quality.isUsable()) {
    part.atlas = std::move(fit.map);
    return;
  }
  char figures[80];
  std::snprintf(figures, sizeof figures, "overlap %.2f, correlation %.2f", fit.quality.dice,
                fit.quality.correlation);
  part.findings.push_back(std::string("the atlas does not fit this brain (") + figures +
                          "): no MNI coordinates or labels");
}

/// Stores both surfaces of the brain and the distance between them.
void keepSurfaces(BrainSurfaces surfaces, BrainPart& part) {
  const auto& [to_model, to_cortex] = surfaces.distance;
  part.quality->surface_median_mm = to_model.median_mm, part.quality->surface_p95_mm = to_model.p95_mm;
  part.quality->model_median_mm = to_cortex.median_mm, part.quality->model_p95_mm = to_cortex.p95_mm;
  part.model = std::move(surfaces.model);
  part.cortex = std::move(surfaces.cortex);
}

BrainPart prepareBrain(const volume::Volume& mri, const segmentation::Segmenter& segmenter,
                       const AtlasSource& source, TaskMonitor& monitor) {
  BrainPart part;
  try {
    auto result = segmenter.segment(mri, monitor);
    part.findings = std::move(result.warnings);
    part.contrast = std::move(result.contrast);
    if (const auto finding = anatomy::brainVolumeFinding(result.mask.volume_ml()))
      part.findings.insert(part.findings.begin(), *finding);
    part.mask = std::move(result.mask);
    TaskMonitor surface_monitor;  // silent; this thread cancels it
    auto surfaces =
        std::async(std::launch::async, [&] { return buildBrainSurfaces(mri, *part.mask, surface_monitor); });
    const atlas::BrainTemplate* atlas = nullptr;
    try {
      atlas = source ? source() : nullptr;
      if (atlas) registerTo(*atlas, mri, part, monitor);
    } catch (...) {
      surface_monitor.cancel();
      surfaces.wait();
      throw;
    }
    part.quality.emplace();
    part.quality->regions = regionConfidence(result.doubts, part.atlas ? &*part.atlas : nullptr, atlas);
    for (auto& words : whereToLook(part.quality->regions)) part.findings.push_back(std::move(words));
    monitor.report("modelling the brain's surface", 0.5);
    keepSurfaces(surfaces.get(), part);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    part = {};
    part.findings.push_back(std::string("no brain model: ") + error.what() +
                            "; the case holds the scalp alone");
  }
  return part;
}

/// Makes a listener for one of two threads: forwards reports to `parent`, one at a time. The call throws
/// Cancelled when the parent was cancelled.
TaskMonitor::Listener forwardTo(TaskMonitor& parent, std::mutex& mutex) {
  return [&parent, &mutex](const std::string& step, double fraction) {
    std::lock_guard lock(mutex);
    parent.report(step, fraction);
  };
}

}  // namespace

casefile::PreparedCase prepare(volume::Volume mri, const segmentation::Segmenter& head,
                               const segmentation::Segmenter& brain, TaskMonitor& monitor,
                               const AtlasSource& atlas) {
  std::mutex one_report;
  TaskMonitor head_monitor(forwardTo(monitor, one_report)), brain_monitor(forwardTo(monitor, one_report));
  auto brain_task =
      std::async(std::launch::async, [&] { return prepareBrain(mri, brain, atlas, brain_monitor); });
  casefile::PreparedCase prepared;
  try {
    HeadPart part = prepareHead(mri, head, head_monitor);
    prepared.head_mask = std::move(part.mask);
    prepared.scalp = std::move(part.scalp);
    prepared.findings = std::move(part.warnings);
    prepared.navigation_check = std::move(part.check);
    prepared.scalp_field = fieldOf(prepared.scalp);  // in parallel with the brain
  } catch (...) {
    brain_monitor.cancel();  // the other thread ends at its next report
    brain_task.wait();
    throw;
  }
  BrainPart part = brain_task.get();
  prepared.mri = std::move(mri);
  prepared.brain_mask = std::move(part.mask);
  prepared.brain = std::move(part.model);
  prepared.cortex = std::move(part.cortex);
  prepared.atlas = std::move(part.atlas);
  prepared.brain_quality = std::move(part.quality);
  prepared.contrast = std::move(part.contrast);
  auto checked = worthAcknowledging(*prepared.navigation_check);
  for (const auto* more : {&prepared.scalp.findings, &checked, &part.findings})
    prepared.findings.insert(prepared.findings.end(), more->begin(), more->end());
  return prepared;
}

}  // namespace facenav::steps
