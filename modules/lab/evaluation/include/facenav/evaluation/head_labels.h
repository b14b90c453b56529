#pragma once
// Labelled heads (label maps with FreeSurfer's numbers inside the brain and classes of tissue outside) and
// the published statistics of their T1 intensities: the source of synthetic heads with an exact truth.
// Source: Billot et al. 2023, SynthSeg: Segmentation of brain MRI scans of any contrast and resolution,
// Medical Image Analysis 86 (label maps and intensities of its public repository, Apache-2.0).

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct LabelledHead {
  std::string name;
  volume::VoxelGrid grid;             // RAS order
  std::vector<std::uint16_t> labels;  // one a voxel
};

/// Intensity of one label over many T1 scans, on a scale of 0 to 255. Labels of one class share their draw.
struct LabelStatistics {
  int tissue_class = 0;
  double mean_of_means = 0, deviation_of_means = 0;            // between scans
  double mean_of_deviations = 0, deviation_of_deviations = 0;  // within one scan
};

/// Reads the statistics by label, from the columns label, name (may contain commas), class, mean of means, sd
/// of means, mean of sds, sd of sds. Throws Error if the file is missing or a line has another form.
std::map<int, LabelStatistics> readLabelStatistics(const std::filesystem::path& csv);
/// Reads a labelled head. Throws Error: missing, not NIfTI, values that are no labels.
LabelledHead readLabelledHead(const std::filesystem::path& nifti);
/// Folder of the shared data with labelled heads: FACENAV_SHARED_DATA/head_labels, else
/// ../shared/data/head_labels.
std::filesystem::path sharedHeadLabels();
/// Paths of all *.nii.gz of a folder, sorted. Throws Error if there are none.
std::vector<std::filesystem::path> labelledHeads(const std::filesystem::path& folder);

/// Returns true for tissue of the brain: no outer fluid, vessels, chiasm, and nothing outside the skull.
bool isBrainTissue(int label);

}  // namespace facenav::evaluation
