// facenav evaluate prepare: Dice, 95 % Hausdorff distance, time and memory of the brain mask on given
// volumes.

#include <cstdio>

#include "commands/lab_commands.h"
#include "evaluate/prepare_evaluation.h"
#include "evaluate/synthetic_prepare.h"
#include "facenav/core/whole_file.h"
#include "result_folder.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

namespace fs = std::filesystem;

struct EvaluatePrepareRequest {
  std::vector<fs::path> volumes;
  std::vector<std::pair<fs::path, fs::path>> tissue, with_fluid;
  double closing_voxels = 2;
  bool has_no_whole = false;
  std::optional<fs::path> output;
  PrepareEvaluation evaluation;
  SyntheticPrepare synthetic;
};

std::vector<PrepareTrial> trialsOf(const EvaluatePrepareRequest& request) {
  std::vector<PrepareTrial> trials;
  for (const auto& [volume, mask] : request.tissue)
    trials.push_back({volume, mask, false, request.closing_voxels});
  for (const auto& [volume, mask] : request.with_fluid) trials.push_back({volume, mask, true, 0});
  for (const auto& volume : request.volumes) trials.push_back({volume, std::nullopt, false, 0});
  if (trials.empty())
    throw WrongUsage("no volume is given",
                     "add --tissue VOLUME MASK, --with-fluid VOLUME MASK, --volume VOLUME or --synthetic N");
  return trials;
}

void write(const PrepareTables& tables, const std::string& markdown, const fs::path& output) {
  ResultFolder result(output, "masks.csv", "an evaluation of masks");
  writeWholeFile(result.path() / "prepare.md", markdown);
  writeWholeFile(result.path() / "masks.csv", evaluation::maskCsv(tables.masks));
  if (!tables.perturbations.empty())
    writeWholeFile(result.path() / "perturbations.csv", evaluation::perturbationCsv(tables.perturbations));
  result.finish();
}

void run(Context& context, EvaluatePrepareRequest request) {
  request.evaluation.is_whole = !request.has_no_whole;
  const bool is_synthetic = request.synthetic.heads > 0;
  if (!is_synthetic) request.evaluation.trials = trialsOf(request);
  const auto tables = is_synthetic ? evaluateSynthetic(context, request.synthetic, request.evaluation)
                                   : evaluatePrepare(context, request.evaluation);
  std::string markdown = evaluation::maskMarkdown(tables.masks);
  if (is_synthetic) markdown += "\n" + evaluation::maskSummaryMarkdown(tables.masks);
  if (!tables.perturbations.empty())
    markdown += "\n" + evaluation::perturbationMarkdown(tables.perturbations);
  if (!tables.reliability.empty())
    markdown +=
        "\nStated doubt against real error:\n\n" + evaluation::reliabilityMarkdown(tables.reliability);
  const auto pooled = evaluation::pooledReliability(tables.reliability);
  if (!pooled.empty())
    markdown += "\nAll scans together, by band:\n\n" + evaluation::doubtBandsMarkdown(pooled);
  if (request.output) write(tables, markdown, *request.output);
  if (!context.is_quiet) std::printf("%s", markdown.c_str());
}

}  // namespace

void addEvaluatePrepare(CLI::App& evaluate, Context& context) {
  auto* verb =
      evaluate.add_subcommand("prepare", "brain masks against true ones: Dice, Hausdorff, time, memory");
  auto request = std::make_shared<EvaluatePrepareRequest>();
  for (const auto& entry : context.registrations.brain_segmenters.entries())
    request->evaluation.methods.push_back(entry.name);
  verb->add_option("--tissue", request->tissue,
                   "mask or labels of the brain's tissue (sulci open), closed and filled here")
      ->type_name("VOLUME MASK");
  verb->add_option("--with-fluid", request->with_fluid, "mask that holds the fluid around the brain")
      ->type_name("VOLUME MASK");
  verb->add_option("--volume", request->volumes, "a volume without a mask: time, memory, perturbations")
      ->type_name("VOLUME");
  verb->add_option("--close-voxels", request->closing_voxels, "radius of the tissue masks' closing")
      ->check(CLI::Range(0.0, 20.0))
      ->capture_default_str();
  verb->add_option("--method", request->evaluation.methods,
                   "brain segmentation: " + steps::namesOf(context.registrations.brain_segmenters))
      ->check(namedIn(context.registrations.brain_segmenters))
      ->delimiter(',')
      ->capture_default_str();
  verb->add_flag("--perturb", request->evaluation.is_perturbed,
                 "how far the mask moves: +-20 deg, 0.5 to 1.5 mm, gain, noise, bias field");
  verb->add_flag("--hard", request->evaluation.has_hard_heads,
                 "the head made another: long neck, child, big, low contrast, bias, noisy scalp");
  verb->add_option("--only", request->evaluation.only,
                   "of --perturb and --hard, those whose name contains this (\"mm\", \"noise\", ...)");
  verb->add_option(
          "--synthetic", request->synthetic.heads,
          "this many heads made from labelled ones (shared data), each with its own seed from --seed on; "
          "then a summary of each method")
      ->check(CLI::Range(1, 1000));
  verb->add_option("--labels", request->synthetic.labels,
                   "folder of the labelled heads (else FACENAV_SHARED_DATA/head_labels)");
  verb->add_option("--heads", request->synthetic.names, "of the labelled heads only these (\"02,07\")")
      ->delimiter(',');
  verb->add_option("--contrast", request->synthetic.contrast,
                   "of the synthetic heads: t1 (published statistics) or any (drawn at random)")
      ->check(CLI::IsMember({"t1", "any"}))
      ->capture_default_str();
  verb->add_flag("--no-whole", request->has_no_whole, "leave out the run of 'facenav prepare' as a whole");
  verb->add_option("--seed", request->evaluation.seed, "of noise and bias fields")->capture_default_str();
  verb->add_option("-o,--output", request->output, "folder for prepare.md, masks.csv, perturbations.csv")
      ->check(folderToMake());
  verb->callback([&context, request] { run(context, *request); });
}

}  // namespace facenav::app
