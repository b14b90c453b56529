// facenav brain CASE: prints the state of the case's brain mask, or corrects it with the same edits as the
// window.

#include <cstdio>

#include "commands/commands.h"
#include "facenav/casefile/edited_brain.h"
#include "facenav/core/number_text.h"
#include "facenav/prepare/correct_brain.h"
#include "json_output.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

constexpr double kMostRadius_mm = 40.0;  // as in the window

struct BrainRequest {
  std::filesystem::path case_folder;
  steps::BrainEdits edits;
  std::vector<std::string> added, removed, grown;  // as typed
  bool is_json = false;
};

/// Reads `count` numbers from "-37,-21,58.5". Throws WrongUsage that names the expected form.
std::vector<double> numbersOf(const std::string& typed, std::size_t count, const std::string& form) {
  const auto numbers = numbersIn(typed);
  if (numbers.size() == count) return numbers;
  throw WrongUsage("'" + typed + "' is not " + form, "give numbers in mm with commas between them");
}

Point<Mri> placeOf(const std::vector<double>& p) { return Point<Mri>(Eigen::Vector3d(p[0], p[1], p[2])); }

std::vector<editing::Ball> ballsOf(const std::vector<std::string>& typed) {
  std::vector<editing::Ball> balls;
  for (const auto& words : typed) {
    const auto numbers = numbersOf(words, 4, "R,A,S,RADIUS");
    if (!(numbers[3] > 0 && numbers[3] <= kMostRadius_mm))
      throw WrongUsage("the sphere's radius must lie between 0 and 40 mm, not as in " + words,
                       "give R,A,S,RADIUS");
    balls.push_back({placeOf(numbers), numbers[3]});
  }
  return balls;
}

bool hasEdits(const steps::BrainEdits& edits) {
  return edits.starts_automatic || edits.drawn || !edits.added.empty() || !edits.removed.empty() ||
         !edits.grown.empty() || edits.fills_holes || edits.smooths;
}

nlohmann::ordered_json stateJson(const casefile::CaseStore& store) {
  const auto mask = store.brainMask();
  return {{"brain_ml", mask ? nlohmann::ordered_json(mask->volume_ml()) : nlohmann::ordered_json()},
          {"corrected_by_hand", casefile::hasEditedBrainMask(store)},
          {"has_draft", casefile::brainDraft(store).has_value()}};
}

void printState(const casefile::CaseStore& store, bool is_json) {
  if (is_json) return printJson(stateJson(store));
  const auto mask = store.brainMask();
  if (!mask) return void(std::printf("no brain mask: the case holds the scalp alone\n"));
  std::printf("brain: %.0f ml, %s\n", mask->volume_ml(),
              casefile::hasEditedBrainMask(store) ? "corrected by hand" : "as prepared");
  if (casefile::brainDraft(store)) std::printf("an unfinished correction is kept (--discard removes it)\n");
}

void print(const steps::CorrectedBrain& result, bool is_json) {
  if (is_json)
    return printJson({{"brain_ml", result.after_ml},
                      {"before_ml", result.before_ml},
                      {"added_voxels", result.added_voxels},
                      {"removed_voxels", result.removed_voxels},
                      {"had_draft", result.had_draft},
                      {"notes", result.notes}});
  for (const auto& note : result.notes) std::printf("note: %s\n", note.c_str());
  if (result.had_draft) std::printf("went on from the unfinished correction\n");
  if (!result.isChanged()) return void(std::printf("brain: %.0f ml, unchanged\n", result.after_ml));
  std::printf(
      "brain: %.0f ml (before %.0f ml), %zu voxels added, %zu removed; the case must be checked again\n",
      result.after_ml, result.before_ml, result.added_voxels, result.removed_voxels);
}

void runBrain(Context& context, BrainRequest request) {
  request.edits.added = ballsOf(request.added);
  request.edits.removed = ballsOf(request.removed);
  for (const auto& typed : request.grown)
    request.edits.grown.push_back(placeOf(numbersOf(typed, 3, "R,A,S")));
  const auto store = casefile::CaseStore::open(request.case_folder);
  if (hasEdits(request.edits)) {
    const auto result = steps::correctBrain(store, request.edits, context.monitor);
    if (request.is_json || !context.is_quiet) print(result, request.is_json);
    return;
  }
  if (request.edits.discards_draft) casefile::removeBrainDraft(store);
  if (request.is_json || !context.is_quiet) printState(store, request.is_json);
}

}  // namespace

void addBrain(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "brain",
      "show or correct a case's brain mask; a correction rebuilds the surfaces and voids the sign-off");
  auto request = std::make_shared<BrainRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_flag("--discard", request->edits.discards_draft,
                 "discard an unfinished correction; otherwise the edits continue from it");
  verb->add_flag("--automatic", request->edits.starts_automatic, "back to the mask that prepare made");
  verb->add_option("--import", request->edits.drawn,
                   "a mask drawn elsewhere (NIfTI, on the grid of the case's mri.nii.gz)");
  verb->add_option("--add-sphere", request->added, "R,A,S,RADIUS in mm; may be given more than once")
      ->allow_extra_args(false);
  verb->add_option("--remove-sphere", request->removed, "R,A,S,RADIUS in mm; may be given more than once")
      ->allow_extra_args(false);
  verb->add_option("--grow", request->grown,
                   "R,A,S in mm: add the connected region of similar values within 20 mm")
      ->allow_extra_args(false);
  verb->add_flag("--fill-holes", request->edits.fills_holes, "holes inside the mask become brain");
  verb->add_flag("--smooth", request->edits.smooths, "take spikes off and fill notches (1.5 mm)");
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->footer("Edits are done in the order of the list above.");
  verb->callback([&context, request] { runBrain(context, *request); });
}

}  // namespace facenav::app
