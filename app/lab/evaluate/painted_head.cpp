#include "evaluate/painted_head.h"

#include <string>

#include "facenav/evaluation/synthetic_head.h"

namespace facenav::app {
namespace {

constexpr unsigned kPersonSeed = 1;

/// Ranges for the head as labelled: not turned, scaled or bent.
evaluation::SyntheticRanges asLabelled() {
  evaluation::SyntheticRanges ranges;
  ranges.turn_deg = 0, ranges.bend_mm = 0;
  ranges.least_size = ranges.most_size = 1.0;
  return ranges;
}

evaluation::SyntheticRanges ofAPerson() {
  evaluation::SyntheticRanges ranges = asLabelled();
  ranges.least_bias = 0, ranges.most_bias = 0.01;
  ranges.least_noise = 0.001, ranges.most_noise = 0.002;
  return ranges;
}

/// Seed from the file's name: each head's scan has its own contrast and noise.
unsigned scanSeedOf(const std::filesystem::path& nifti) {
  unsigned seed = 1000;
  for (const char c : nifti.stem().stem().string()) seed = 31 * seed + unsigned(c);
  return seed;
}

/// Changes the statistics to uniform tissue and dark air.
std::map<int, evaluation::LabelStatistics> evenTissue(std::map<int, evaluation::LabelStatistics> statistics) {
  for (auto& [label, s] : statistics) {
    s.deviation_of_means = 0, s.deviation_of_deviations = 0;
    s.mean_of_deviations = 1;
    if (label == 0) s.mean_of_means = 0;
  }
  return statistics;
}

}  // namespace

std::optional<PaintedHead> paintedHead(const std::filesystem::path& nifti) {
  const auto table = nifti.parent_path() / "t1_intensities.csv";
  if (!std::filesystem::exists(table)) return std::nullopt;
  const auto statistics = evaluation::readLabelStatistics(table);
  const auto head = evaluation::readLabelledHead(nifti);
  constexpr auto kT1 = evaluation::SyntheticContrast::t1;
  return PaintedHead{
      evaluation::makeSyntheticHead(head, evenTissue(statistics), kT1, kPersonSeed, ofAPerson()).scan,
      evaluation::makeSyntheticHead(head, statistics, kT1, scanSeedOf(nifti), asLabelled()).scan};
}

}  // namespace facenav::app
