#pragma once
// `facenav evaluate prepare --synthetic N`: brain masks of heads generated from labelled ones (shared data),
// where the truth is exact. Head n of seed s is the same in every run.

#include "evaluate/prepare_evaluation.h"

namespace facenav::app {

struct SyntheticPrepare {
  int heads = 0;  // 0: none
  std::optional<std::filesystem::path>
      labels;                      // else FACENAV_SHARED_DATA/head_labels, ../shared/data/head_labels
  std::vector<std::string> names;  // of the labelled heads, e.g. those a model was not trained on; empty: all
  std::string contrast = "t1";     // or "any"
};

/// Evaluates methods on generated heads. `request`: methods, perturbations and the first seed; its trials are
/// not used, and `facenav prepare` as a whole is not run. Throws Error: no labelled heads in the folder, none
/// of that name, Cancelled.
PrepareTables evaluateSynthetic(Context& context, const SyntheticPrepare& synthetic,
                                PrepareEvaluation request);

}  // namespace facenav::app
