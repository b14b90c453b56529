#pragma once
// The batch: one case per T1, each in a process of its own, so that one bad image takes nothing else down.
// What is there already is kept: a batch that was killed goes on where it stopped.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bids/bids_dataset.h"

namespace facenav::app {

enum class BidsState { prepared, there_already, failed };

struct BidsResult {
  BidsImage image;
  BidsState state = BidsState::failed;
  double seconds = 0;
  std::optional<double> brain_ml;
  std::size_t findings = 0;
  std::string problem;  // one line, where it failed
};

/// OUT/sub-<label>[/ses-<label>]: case/ (the case), anat/<prefix>_desc-{head,brain}_mask.nii.gz; logs in
/// OUT/logs. `facenav`: the command line tool. Never throws for a single image.
BidsResult prepareImage(const BidsImage& image, const std::filesystem::path& output,
                        const std::filesystem::path& facenav);

/// The table at the end: one line a T1, then a line of sums.
std::string toTable(const std::vector<BidsResult>& results);

}  // namespace facenav::app
