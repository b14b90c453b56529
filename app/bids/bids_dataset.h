#pragma once
// A BIDS dataset (bids-specification 1.8) for the batch: it reads the T1-weighted images of the participants
// and writes the derivatives dataset.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facenav::app {

/// One navigation T1: sub-<label>[/ses-<label>]/anat/*_T1w.nii[.gz].
struct BidsImage {
  std::string participant, session;  // labels without "sub-" and "ses-"; session may be empty
  std::filesystem::path t1;
  /// "sub-01" or "sub-01_ses-a".
  std::string prefix() const;
};

/// Finds the T1 images, sorted by participant and session. If an anat folder has several T1w images, the
/// first by name is used. `labels` (with or without "sub-") chooses participants; empty: all. Throws Error:
/// no dataset_description.json, no T1w image, or a label that the dataset does not have.
std::vector<BidsImage> findT1Images(const std::filesystem::path& dataset,
                                    const std::vector<std::string>& labels);

/// Writes dataset_description.json of the derivatives. Throws Error if `output` contains another dataset's
/// derivatives.
void writeDerivativesDescription(const std::filesystem::path& output, const std::filesystem::path& dataset,
                                 const std::string& software_version);

}  // namespace facenav::app
