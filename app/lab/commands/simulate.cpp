// facenav simulate SCENARIO [--case CASE | --patient mri.nii.gz] -o RECORDING: the virtual treatment room

#include <cstdio>

#include "commands/lab_commands.h"
#include "commands/option_flags.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/whole_folder.h"
#include "facenav/room/minc_volume.h"
#include "facenav/room/simulate.h"
#include "facenav/volume/nifti.h"
#include "room_patient.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

namespace fs = std::filesystem;

struct SimulateRequest {
  room::ScenarioOptions options;
  room::PatientOptions patient_options;
  std::optional<fs::path> case_folder, patient;
  std::string target;
  fs::path output;
};

volume::Volume cachedPatient(const Context& context) {
  const fs::path nifti = context.cacheFolder() / "virtual_patient" / "mri.nii.gz";
  if (fs::exists(nifti)) return volume::readNifti(nifti).volume;
  const fs::path fetched = context.cacheFolder() / "brainbrowser";
  return room::readMincVolume(fetched / "structural1.mnc.header.gz", fetched / "structural1.mnc.raw.gz");
}

void run(Context& context, const SimulateRequest& request) {
  requireUnderstood([&] { room::resolved(request.options); });  // before the seconds that the patient takes
  const WholeFolder place(request.output);                      // it is free and can be written to
  std::optional<RigidTransform<Mri, frames::Target>> target;
  std::shared_ptr<const room::VirtualPatient> patient;
  if (request.case_folder) {
    const auto store = casefile::CaseStore::open(*request.case_folder);
    const auto plan = store.targets();
    if (!request.target.empty() || !plan.targets.empty())
      target = (request.target.empty() ? plan.targets.front() : plan.find(request.target)).mri_T_target;
    patient =
        std::make_shared<const room::VirtualPatient>(roomPatient(context, store, request.patient_options));
  } else {
    const auto mri = request.patient ? volume::readNifti(*request.patient).volume : cachedPatient(context);
    patient = std::make_shared<const room::VirtualPatient>(
        room::makePatient(mri, request.patient_options, context.monitor));
  }
  if (patient->landmarks68_mm.empty() && !context.is_quiet)
    std::fprintf(stderr, "facenav: note: no whole face in this scan; the patient has plain skin\n");
  room::simulate(request.options, patient, target, request.output, context.monitor);
}

}  // namespace

void addSimulate(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("simulate", "the virtual treatment room -> recording with exact truth");
  auto request = std::make_shared<SimulateRequest>();
  std::string scenarios = "what happens:";
  for (const auto& kind : room::scenarios()) scenarios += "\n  " + kind.name + ": " + kind.help;
  verb->add_option("SCENARIO", request->options.name, scenarios)->required();
  auto* of_case = verb->add_option("--case", request->case_folder,
                                   "case folder: its MRI is the patient, its target the coil's");
  verb->add_option("--patient", request->patient,
                   "mri.nii.gz of another patient (default: the cached virtual patient)")
      ->excludes(of_case);
  verb->add_option("--target", request->target,
                   "name of the case's target the coil is brought to (default: the first)")
      ->needs(of_case);
  verb->add_option("-o,--output", request->output, "recording folder to write")
      ->required()
      ->check(folderToMake());
  room::ScenarioOptions::visit(request->options, FlagVisitor{*verb});
  room::PatientOptions::visit(request->patient_options, FlagVisitor{*verb, "patient-"});
  verb->callback([&context, request] { run(context, *request); });
}

}  // namespace facenav::app
