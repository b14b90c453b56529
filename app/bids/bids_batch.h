#pragma once
// The batch: one case per T1, each in its own process, so that a bad image affects no other. Finished cases
// are kept: an interrupted batch continues where it stopped.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bids/bids_dataset.h"

namespace facenav::app {

enum class BidsState { prepared, there_already, failed, not_run };

struct BidsResult {
  BidsImage image;
  BidsState state = BidsState::failed;
  double seconds = 0;
  std::optional<double> brain_ml;
  std::size_t findings = 0;
  std::string problem;  // why it failed, in one line
};

/// Prepares one image. Writes OUT/sub-<label>[/ses-<label>]: case/ (the case),
/// anat/<prefix>_desc-{head,brain}_mask.nii.gz; logs in OUT/logs. `facenav`: the command line tool. Never
/// throws for a single image.
BidsResult prepareImage(const BidsImage& image, const std::filesystem::path& output,
                        const std::filesystem::path& facenav);

/// Says what is there of one image, and runs nothing: its case, how its last run failed, or that none ran.
BidsResult foundImage(const BidsImage& image, const std::filesystem::path& output);

/// The final table: one line per T1, then the totals.
std::string toTable(const std::vector<BidsResult>& results);

}  // namespace facenav::app
