#include "evaluate/synthetic_prepare.h"

#include <algorithm>

#include "evaluate/scratch_folder.h"
#include "facenav/evaluation/synthetic_head.h"
#include "facenav/volume/nifti.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

fs::path labelsFolder(const SyntheticPrepare& synthetic) {
  return synthetic.labels ? *synthetic.labels : evaluation::sharedHeadLabels();
}

std::string nameOf(const fs::path& nifti) { return nifti.stem().stem().string(); }

/// Returns the requested heads of the folder.
std::vector<fs::path> chosenHeads(const fs::path& folder, const std::vector<std::string>& names) {
  const auto all = evaluation::labelledHeads(folder);
  if (names.empty()) return all;
  std::vector<fs::path> chosen;
  for (const auto& name : names) {
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const fs::path& path) { return nameOf(path) == name; });
    if (at == all.end())
      throw Error("there is no labelled head " + name, folder.string(), "see the names of its files");
    chosen.push_back(*at);
  }
  return chosen;
}

template <class Row>
void append(std::vector<Row>& all, const std::vector<Row>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

PrepareTables evaluateSynthetic(Context& context, const SyntheticPrepare& synthetic,
                                PrepareEvaluation request) {
  const fs::path folder = labelsFolder(synthetic);
  const auto heads = chosenHeads(folder, synthetic.names);
  const auto statistics = evaluation::readLabelStatistics(folder / "t1_intensities.csv");
  const auto contrast =
      synthetic.contrast == "any" ? evaluation::SyntheticContrast::any : evaluation::SyntheticContrast::t1;
  const unsigned first_seed = request.seed;
  request.is_whole = false;
  PrepareTables tables;
  for (unsigned n = 0; n < unsigned(synthetic.heads); ++n) {
    const ScratchFolder scratch;
    const fs::path& labels = heads[n % heads.size()];
    request.seed = first_seed + n;
    const std::string name =
        "head_" + nameOf(labels) + "_" + synthetic.contrast + "_seed_" + std::to_string(request.seed);
    const fs::path scan = scratch.path() / (name + ".nii.gz"), tissue = scratch.path() / "tissue.nii.gz";
    {  // freed before a child is forked, whose memory would include it
      const auto made = evaluation::makeSyntheticHead(evaluation::readLabelledHead(labels), statistics,
                                                      contrast, request.seed);
      volume::writeNifti(made.scan, scan);
      volume::writeMask(made.tissue, tissue);
    }
    request.trials = {{scan, tissue}};
    const PrepareTables more = evaluatePrepare(context, request);
    append(tables.masks, more.masks);
    append(tables.perturbations, more.perturbations);
    append(tables.reliability, more.reliability);
  }
  return tables;
}

}  // namespace facenav::app
