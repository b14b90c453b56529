// facenav prepare INPUT -o CASE: DICOM folder or file, or NIfTI -> case with masks, scalp and brain model.

#include <cstdio>

#include "commands/commands.h"
#include "facenav/prepare/prepare_case.h"
#include "navigation_sheet.h"
#include "typed_values.h"

namespace facenav::app {

void addPrepare(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("prepare", "MRI (DICOM or NIfTI) -> case: masks, scalp, brain model");
  auto request = std::make_shared<steps::PrepareRequest>();
  request->head_segmenter = context.registrations.head_segmenters.defaultName();
  request->brain_segmenter = context.registrations.brain_segmenters.defaultName();
  verb->add_option("INPUT", request->input,
                   "DICOM folder, one DICOM file, or NIfTI (.nii, .nii.gz, .hdr, .img)")
      ->required();
  verb->add_option("-o,--output", request->case_folder, "case folder to make")
      ->required()
      ->check(folderToMake());
  verb->add_option("--series", request->series_uid,
                   "series UID, where INPUT holds several ('facenav series' lists them)");
  verb->add_option(
          "--nifti-transform", request->nifti_transform,
          "which of a NIfTI file's maps to world coordinates to believe: automatic (the sform, else the "
          "qform), sform, qform")
      ->check(CLI::IsMember({"automatic", "sform", "qform"}))
      ->capture_default_str();
  verb->add_option("--brain", request->brain_segmenter,
                   "brain segmentation: " + steps::namesOf(context.registrations.brain_segmenters))
      ->check(namedIn(context.registrations.brain_segmenters))
      ->capture_default_str();
  verb->add_flag(
      "--replace", request->replace,
      "replace the case's model; its targets, sessions and threshold searches are kept (another scan "
      "is refused where the case has targets or sessions)");
  verb->add_flag("--discard-edits", request->discard_edits,
                 "with --replace: also where the brain mask was corrected by hand");
  auto* label =
      verb->add_option("--label", request->label, "what you call the case in lists (private to you)");
  verb->add_flag(
          "--patient-label", request->is_labelled_by_patient,
          "label the case with the patient's name from the DICOM files, which no case holds unless asked")
      ->excludes(label);
  verb->callback([&context, request] {
    const auto outcome = steps::prepareCase(context.registrations, *request, context.monitor);
    if (context.is_quiet) return;
    for (const auto& line : outcome.description) std::printf("%s\n", line.c_str());
    if (outcome.brain_ml) std::printf("brain: %.0f ml\n", *outcome.brain_ml);
    if (const auto quality = outcome.store.brainQuality()) {
      std::printf(
          "phi-theta surface: %.1f mm (95 %%: %.1f) from the true one; the true one with its folds %.1f "
          "(%.1f) from it\n",
          quality->model_median_mm, quality->model_p95_mm, quality->surface_median_mm,
          quality->surface_p95_mm);
      if (!quality->regions.empty())
        std::printf("mask: least certain at the %s (confidence %.2f)\n",
                    quality->regions.front().region.c_str(), quality->regions.front().confidence);
    }
    if (outcome.navigation_check) printNavigationCheck(*outcome.navigation_check);
    for (const auto& finding : outcome.findings) std::printf("note: %s\n", finding.c_str());
    std::printf("case written: %s\n", outcome.store.folder().c_str());
  });
}

}  // namespace facenav::app
