#include "facenav/evaluation/doubt_reliability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/evaluation/error_statistics.h"
#include "facenav/volume/mask_morphology.h"
#include "markdown_cell.h"

namespace facenav::evaluation {
namespace {

constexpr std::array<double, 7> kEnds_mm{0, 1, 2, 3, 5, 8, 1e9};

template <class Value>
double shareCertain(const std::vector<DoubtedPlace>& places, Value DoubtedPlace::*value) {
  const auto certain = std::count_if(places.begin(), places.end(),
                                     [&](const DoubtedPlace& p) { return p.*value <= kCertain_mm; });
  return places.empty() ? 0 : double(certain) / double(places.size());
}

}  // namespace

SurfaceError::SurfaceError(const volume::Mask& reference)
    : grid_(reference.grid), distance_mm_(volume::distanceTo(volume::surfaceVoxels(reference))) {}

double SurfaceError::at_mm(const Point<Mri>& place) const {
  const Eigen::Vector3d ijk = grid_.toVoxel(place);
  std::array<int, 3> at{};
  for (int a = 0; a < 3; ++a)
    at[std::size_t(a)] = std::clamp(int(std::lround(ijk[a])), 0, grid_.size[std::size_t(a)] - 1);
  return double(distance_mm_[grid_.index(at[0], at[1], at[2])]);
}

std::vector<ReliabilityBin> reliabilityOf(const std::vector<DoubtedPlace>& places) {
  std::vector<ReliabilityBin> bins;
  for (std::size_t b = 0; b + 1 < kEnds_mm.size(); ++b) {
    ReliabilityBin bin;
    bin.from_mm = kEnds_mm[b], bin.to_mm = kEnds_mm[b + 1];
    std::vector<double> errors;
    for (const auto& p : places)
      if ((p.doubt_mm > bin.from_mm || b == 0) && p.doubt_mm <= bin.to_mm) errors.push_back(p.error_mm);
    bin.places = errors.size();
    if (bin.places) {
      bin.share = double(bin.places) / double(places.size());
      for (const double e : errors) {
        bin.mean_error_mm += e / double(bin.places);
        bin.wrong += (e > kCertain_mm) / double(bin.places);
      }
      bin.p90_error_mm = quantile(errors, 0.9);
    }
    bins.push_back(bin);
  }
  return bins;
}

ReliabilityRow reliabilityRow(std::string volume, std::string method, std::string against,
                              const std::vector<DoubtedPlace>& places) {
  return {std::move(volume),
          std::move(method),
          std::move(against),
          reliabilityOf(places),
          shareCertain(places, &DoubtedPlace::doubt_mm),
          shareCertain(places, &DoubtedPlace::error_mm)};
}

std::string reliabilityMarkdown(const std::vector<ReliabilityRow>& rows) {
  std::string text =
      "| volume | method | error against | stated doubt (mm) | places (%) | mean error (mm) | 90 % below "
      "(mm) "
      "| > 2 mm off (%) |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const auto& row : rows) {
    const std::string head = "| " + markdownCell(row.volume) + " | " + markdownCell(row.method) + " | " +
                             markdownCell(row.against) + " | ";
    for (const auto& bin : row.bins) {
      if (!bin.places) continue;
      const std::string range =
          bin.to_mm > 1e6 ? formatted("> %g", bin.from_mm) : formatted("%g-%g", bin.from_mm, bin.to_mm);
      text += head + range +
              formatted(" | %.1f | %.2f | %.2f | %.1f |\n", 100 * bin.share, bin.mean_error_mm,
                        bin.p90_error_mm, 100 * bin.wrong);
    }
    text += head + formatted("all: %.1f %% stated within 2 mm, %.1f %% are | | | | |\n",
                             100 * row.stated_certain, 100 * row.really_certain);
  }
  return text;
}

}  // namespace facenav::evaluation
