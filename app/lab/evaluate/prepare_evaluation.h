#pragma once
// `facenav evaluate prepare`: compares brain masks of given volumes with given true masks, and measures time
// and memory, for every method and plain BET. It also measures how far a mask moves when the scan is
// perturbed.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "context.h"
#include "facenav/evaluation/doubt_reliability.h"
#include "facenav/evaluation/mask_table.h"

namespace facenav::app {

struct PrepareTrial {
  std::filesystem::path volume;               // any input of `facenav prepare`
  std::optional<std::filesystem::path> mask;  // NIfTI, > 0: brain
  bool is_with_fluid = false;  // the mask includes the fluid around the brain; no closing is applied
  double closing_voxels = 2;   // for a tissue mask
};

struct PrepareEvaluation {
  std::vector<PrepareTrial> trials;
  std::vector<std::string> methods;  // registered names
  bool is_whole = true;              // also run all of `facenav prepare`, with its output files
  bool is_perturbed = false, has_hard_heads = false;
  std::string only;  // only perturbations and hard heads whose name contains this
  unsigned seed = 1;
};

struct PrepareTables {
  std::vector<evaluation::MaskRow> masks;
  std::vector<evaluation::PerturbationRow> perturbations;
  std::vector<evaluation::ReliabilityRow> reliability;  // for methods that give their uncertainty
};

/// Evaluates all methods. If one fails on a volume, its row says so. Throws Error: a mask that cannot be
/// read; Cancelled.
PrepareTables evaluatePrepare(Context& context, const PrepareEvaluation& request);

}  // namespace facenav::app
