#include "evaluate/prepare_evaluation.h"

#include <array>
#include <fstream>

#include "evaluate/measured_child.h"
#include "evaluate/scratch_folder.h"
#include "facenav/core/whole_file.h"
#include "facenav/dicom/import_volume.h"
#include "facenav/evaluation/volume_perturbation.h"
#include "facenav/prepare/prepare_case.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using evaluation::MaskRow;
using evaluation::PerturbationRow;
using volume::Mask;
using volume::Volume;

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
  const ScratchFolder scratch;
  steps::PrepareRequest request;
  request.input = trial.volume;
  request.case_folder = scratch.path() / "case";
  request.head_segmenter = context.registrations.head_segmenters.defaultName();
  request.brain_segmenter = context.registrations.brain_segmenters.defaultName();
  auto row =
      rowOf(trial, "prepare, whole",
            measureInChild([&] { steps::prepareCase(context.registrations, request, context.monitor); }));
  judge(request.case_folder / "brain_mask.nii.gz", truth, row);
  return row;
}

/// Writes the doubts for the parent process, in the machine's binary format.
void writeDoubts(const std::vector<segmentation::BoundaryDoubt>& doubts, const fs::path& file) {
  std::ofstream stream(file, std::ios::binary);
  for (const auto& d : doubts) {
    const std::array<double, 4> values{d.place.mm.x(), d.place.mm.y(), d.place.mm.z(), d.doubt_mm};
    stream.write(reinterpret_cast<const char*>(values.data()), sizeof values);
  }
  if (!stream.flush()) throw Error("cannot be written", file.string(), "check free disk space");
}

std::vector<segmentation::BoundaryDoubt> readDoubts(const fs::path& file) {
  std::vector<segmentation::BoundaryDoubt> doubts;
  std::ifstream stream(file, std::ios::binary);
  for (std::array<double, 4> v{}; stream.read(reinterpret_cast<char*>(v.data()), sizeof v);)
    doubts.push_back({Point<Mri>(v[0], v[1], v[2]), float(v[3])});
  return doubts;
}

MaskRow segmenterAlone(Context& context, const PrepareTrial& trial, const std::string& method,
                       const Volume& volume, const std::optional<Mask>& truth,
                       std::optional<segmentation::SegmentationResult>& found) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "mask.nii.gz", doubts = scratch.path() / "doubts",
                 contrast = scratch.path() / "contrast";
  const auto segmenter = context.registrations.brain_segmenters.create(method);
  auto row = rowOf(trial, method, measureInChild([&] {
                     const auto result = segmenter->segment(volume, context.monitor);
                     volume::writeMask(result.mask, file);
                     writeDoubts(result.doubts, doubts);
                     writeWholeFile(contrast, result.contrast);
                   }));
  judge(file, truth, row);
  if (!row.failure.empty()) return row;
  row.contrast = readWholeFile(contrast);
  found = {volume::readMask(file), {}, readDoubts(doubts), row.contrast};
  return row;
}

struct Judged {
  const PrepareTrial& trial;
  const Volume& volume;
  const std::optional<Mask>& truth;
  const std::string& method;
  const Mask& unmoved;
  std::string contrast;
};

/// Places where a method gave its uncertainty, with their real errors. The error is the distance to the true
/// surface if the truth is a tissue mask (a mask with fluid has another surface); for a perturbation, it is
/// the distance to the unperturbed mask.
class Doubts {
 public:
  explicit Doubts(const Judged& of) : of_(of), unmoved_(of.unmoved) {
    if (of.truth && !of.trial.is_with_fluid) truth_.emplace(*of.truth);
  }
  void add(const std::vector<segmentation::BoundaryDoubt>& doubts,
           const evaluation::VolumePerturbation* perturbation) {
    for (const auto& doubt : doubts) {
      const auto place =
          perturbation ? evaluation::unperturbed(doubt.place, of_.volume.grid, *perturbation) : doubt.place;
      if (truth_) against_truth_.push_back({doubt.doubt_mm, truth_->at_mm(place)});
      if (perturbation) against_unmoved_.push_back({doubt.doubt_mm, unmoved_.at_mm(place)});
    }
  }
  void addRows(std::vector<evaluation::ReliabilityRow>& rows) const {
    const auto add = [&](const char* against, const auto& places) {
      if (places.empty()) return;
      rows.push_back(evaluation::reliabilityRow(nameOf(of_.trial), of_.method, against, places));
      rows.back().contrast = of_.contrast;
    };
    add("true surface", against_truth_);
    add("unperturbed mask", against_unmoved_);
  }

 private:
  const Judged& of_;
  evaluation::SurfaceError unmoved_;
  std::optional<evaluation::SurfaceError> truth_;
  std::vector<evaluation::DoubtedPlace> against_truth_, against_unmoved_;
};

PerturbationRow perturbedRow(Context& context, const Judged& of,
                             const evaluation::VolumePerturbation& perturbation, bool must_hold,
                             unsigned seed, Doubts& doubts) {
  PerturbationRow row;
  row.volume = nameOf(of.trial), row.method = of.method, row.perturbation = perturbation.name;
  row.must_hold = must_hold;
  try {
    const Volume other = evaluation::perturbed(of.volume, of.unmoved, perturbation, seed);
    const auto segmenter = context.registrations.brain_segmenters.create(of.method);
    const auto result = segmenter->segment(other, context.monitor);
    doubts.add(result.doubts, &perturbation);
    const Mask back = evaluation::unperturbed(result.mask, of.volume.grid, perturbation);
    row.moved = evaluation::compareMasks(back, of.unmoved);
    if (of.truth) row.truth = evaluation::compareMasks(back, *of.truth);
  } catch (const Error& error) {
    row.failure = error.what();
  }
  return row;
}

void addPerturbations(Context& context, const PrepareEvaluation& request, const Judged& of, Doubts& doubts,
                      std::vector<PerturbationRow>& rows) {
  const auto add = [&](const auto& perturbations, bool must_hold) {
    for (const auto& perturbation : perturbations) {
      if (perturbation.name.find(request.only) == std::string::npos) continue;
      context.monitor.report(nameOf(of.trial) + ", " + of.method + ": " + perturbation.name, 0.5);
      rows.push_back(perturbedRow(context, of, perturbation, must_hold, request.seed, doubts));
    }
  };
  if (request.is_perturbed) add(evaluation::standardPerturbations(), true);
  if (request.has_hard_heads) add(evaluation::hardHeads(), false);
}

}  // namespace

PrepareTables evaluatePrepare(Context& context, const PrepareEvaluation& request) {
  PrepareTables tables;
  std::vector<std::optional<Mask>> truths;
  // Reports a bad file before the long work.
  for (const auto& trial : request.trials) truths.push_back(truthOf(trial));
  for (std::size_t t = 0; t < request.trials.size(); ++t) {
    const auto& trial = request.trials[t];
    if (request.is_whole) tables.masks.push_back(wholePrepare(context, trial, truths[t]));
    const Volume volume = dicom::importVolume(trial.volume, std::nullopt, context.monitor).volume;
    for (const auto& method : request.methods) {
      context.monitor.report("evaluate prepare: " + nameOf(trial) + ", " + method,
                             double(t) / double(request.trials.size()));
      std::optional<segmentation::SegmentationResult> found;
      tables.masks.push_back(segmenterAlone(context, trial, method, volume, truths[t], found));
      if (!found) continue;
      const Judged judged{trial, volume, truths[t], method, found->mask, found->contrast};
      Doubts doubts(judged);
      doubts.add(found->doubts, nullptr);
      addPerturbations(context, request, judged, doubts, tables.perturbations);
      doubts.addRows(tables.reliability);
    }
  }
  return tables;
}

}  // namespace facenav::app
