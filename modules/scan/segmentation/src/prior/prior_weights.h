#pragma once
// The weights of the brain prior, as resources/training/brain_prior/weights_file.py writes them: little
// endian "FNBP", version, number of tensors, rank and sizes of each, all values in half precision, CRC-32 of
// all before it.

#include <filesystem>
#include <vector>

namespace facenav::segmentation {

struct PriorTensor {
  std::vector<int> size;
  std::vector<float> values;  // last index fastest
};

/// Reads the tensors. Throws Error: missing, another format or version, truncated, damaged.
std::vector<PriorTensor> readPriorWeights(const std::filesystem::path& path);

}  // namespace facenav::segmentation
