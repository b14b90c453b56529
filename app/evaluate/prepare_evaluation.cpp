#include "evaluate/prepare_evaluation.h"

#include "evaluate/measured_child.h"
#include "facenav/dicom/import_volume.h"
#include "facenav/evaluation/volume_perturbation.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"
#include "pipeline.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using evaluation::MaskRow;
using evaluation::PerturbationRow;
using volume::Mask;
using volume::Volume;

/// A folder for what the children leave.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "facenav_evaluate_XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw Error("no temporary folder can be made", name, "check free disk space");
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string nameOf(const PrepareTrial& trial) {
  const fs::path path = trial.volume.has_filename() ? trial.volume : trial.volume.parent_path();
  const std::string parent = path.parent_path().filename().string();
  return path.filename() == "mri.nii.gz" && !parent.empty() ? parent : path.filename().string();
}

std::string truthName(const PrepareTrial& trial) {
  if (!trial.mask) return "";
  if (trial.is_with_fluid) return "with fluid";
  char text[48];
  std::snprintf(text, sizeof text, "tissue, closed by %g voxels", trial.closing_voxels);
  return text;
}

std::optional<Mask> truthOf(const PrepareTrial& trial) {
  if (!trial.mask) return std::nullopt;
  const Mask mask = volume::readMask(*trial.mask);
  return trial.is_with_fluid ? mask : evaluation::closedAndFilled(mask, trial.closing_voxels);
}

MaskRow rowOf(const PrepareTrial& trial, const std::string& method, const ChildMeasure& measure) {
  MaskRow row;
  row.volume = nameOf(trial), row.truth = truthName(trial), row.method = method;
  row.wall_s = measure.wall_s, row.processor_s = measure.processor_s, row.peak_mib = measure.peak_mib;
  row.failure = measure.failure;
  return row;
}

void judge(const fs::path& found, const std::optional<Mask>& truth, MaskRow& row) {
  if (!row.failure.empty() || !fs::exists(found)) return;
  const Mask mask = volume::readMask(found);
  row.brain_ml = mask.volume_ml();
  if (truth) row.agreement = evaluation::compareMasks(mask, *truth);
}

MaskRow wholePrepare(Context& context, const PrepareTrial& trial, const std::optional<Mask>& truth) {
  const Scratch scratch;
  PrepareRequest request;
  request.input = trial.volume;
  request.case_folder = scratch.path() / "case";
  request.head_segmenter = context.registrations.head_segmenters.defaultName();
  request.brain_segmenter = context.registrations.brain_segmenters.defaultName();
  auto row = rowOf(trial, "prepare, whole", measureInChild([&] { prepareCase(context, request); }));
  judge(request.case_folder / "brain_mask.nii.gz", truth, row);
  return row;
}

MaskRow segmenterAlone(Context& context, const PrepareTrial& trial, const std::string& method,
                       const Volume& volume, const std::optional<Mask>& truth, std::optional<Mask>& found) {
  const Scratch scratch;
  const fs::path file = scratch.path() / "mask.nii.gz";
  const auto segmenter = context.registrations.brain_segmenters.create(method);
  auto row = rowOf(trial, method, measureInChild([&] {
                     volume::writeMask(segmenter->segment(volume, context.monitor).mask, file);
                   }));
  judge(file, truth, row);
  if (row.failure.empty()) found = volume::readMask(file);
  return row;
}

struct Judged {
  const PrepareTrial& trial;
  const Volume& volume;
  const std::optional<Mask>& truth;
  const std::string& method;
  const Mask& unmoved;
};

PerturbationRow perturbedRow(Context& context, const Judged& of,
                             const evaluation::VolumePerturbation& perturbation, bool must_hold,
                             unsigned seed) {
  PerturbationRow row;
  row.volume = nameOf(of.trial), row.method = of.method, row.perturbation = perturbation.name;
  row.must_hold = must_hold;
  try {
    const Volume other = evaluation::perturbed(of.volume, of.unmoved, perturbation, seed);
    const auto segmenter = context.registrations.brain_segmenters.create(of.method);
    const Mask found = segmenter->segment(other, context.monitor).mask;
    const Mask back = evaluation::unperturbed(found, of.volume.grid, perturbation);
    row.moved = evaluation::compareMasks(back, of.unmoved);
    if (of.truth) row.truth = evaluation::compareMasks(back, *of.truth);
  } catch (const Error& error) {
    row.failure = error.what();
  }
  return row;
}

void addPerturbations(Context& context, const PrepareEvaluation& request, const Judged& of,
                      std::vector<PerturbationRow>& rows) {
  const auto add = [&](const auto& perturbations, bool must_hold) {
    for (const auto& perturbation : perturbations) {
      context.monitor.report(nameOf(of.trial) + ", " + of.method + ": " + perturbation.name, 0.5);
      rows.push_back(perturbedRow(context, of, perturbation, must_hold, request.seed));
    }
  };
  if (request.is_perturbed) add(evaluation::standardPerturbations(), true);
  if (request.has_hard_heads) add(evaluation::hardHeads(), false);
}

}  // namespace

PrepareTables evaluatePrepare(Context& context, const PrepareEvaluation& request) {
  PrepareTables tables;
  std::vector<std::optional<Mask>> truths;
  for (const auto& trial : request.trials) truths.push_back(truthOf(trial));  // said before the long work
  for (std::size_t t = 0; t < request.trials.size(); ++t) {
    const auto& trial = request.trials[t];
    if (request.is_whole) tables.masks.push_back(wholePrepare(context, trial, truths[t]));
    const Volume volume = dicom::importVolume(trial.volume, std::nullopt, context.monitor).volume;
    for (const auto& method : request.methods) {
      context.monitor.report("evaluate prepare: " + nameOf(trial) + ", " + method,
                             double(t) / double(request.trials.size()));
      std::optional<Mask> found;
      tables.masks.push_back(segmenterAlone(context, trial, method, volume, truths[t], found));
      if (found)
        addPerturbations(context, request, {trial, volume, truths[t], method, *found}, tables.perturbations);
    }
  }
  return tables;
}

}  // namespace facenav::app
