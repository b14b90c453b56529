#pragma once
// `facenav evaluate prepare`: brain masks of given volumes against given true masks, with time and memory,
// every method beside the plain BET; and how far a mask moves when the scan is perturbed.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "context.h"
#include "facenav/evaluation/doubt_reliability.h"
#include "facenav/evaluation/mask_table.h"

namespace facenav::app {

struct PrepareTrial {
  std::filesystem::path volume;               // as `facenav prepare` takes it
  std::optional<std::filesystem::path> mask;  // NIfTI, > 0: brain
  bool is_with_fluid = false;                 // the mask holds the fluid around the brain: compared as it is
  double closing_voxels = 2;                  // of a tissue mask
};

struct PrepareEvaluation {
  std::vector<PrepareTrial> trials;
  std::vector<std::string> methods;  // registered names
  bool is_whole = true;              // `facenav prepare` too, as a whole, everything written
  bool is_perturbed = false, has_hard_heads = false;
  std::string only;  // perturbations and hard heads whose name contains this
  unsigned seed = 1;
};

struct PrepareTables {
  std::vector<evaluation::MaskRow> masks;
  std::vector<evaluation::PerturbationRow> perturbations;
  std::vector<evaluation::ReliabilityRow> reliability;  // where a method states its doubt
};

/// A failure of one method on one volume is a row. Throws Error: a mask that cannot be read, Cancelled.
PrepareTables evaluatePrepare(Context& context, const PrepareEvaluation& request);

}  // namespace facenav::app
