#include "facenav/evaluation/doubt_reliability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

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

/// Returns true if the value is in (from, to]; 0 is in the first bin.
bool isWithin(double value_mm, const ReliabilityBin& bin) {
  return (value_mm > bin.from_mm || bin.from_mm == 0) && value_mm <= bin.to_mm;
}

std::size_t placesOf(const ReliabilityRow& row) {
  std::size_t places = 0;
  for (const auto& bin : row.bins) places += bin.places;
  return places;
}

/// Adds the points of `more` to those of `sum`.
void addPoints(const ReliabilityRow& more, ReliabilityRow& sum) {
  const double before = double(placesOf(sum)), added = double(placesOf(more));
  if (added == 0) return;
  const auto mean = [](double a, double of_a, double b, double of_b) {
    return of_a + of_b > 0 ? (a * of_a + b * of_b) / (of_a + of_b) : 0;
  };
  for (std::size_t b = 0; b < sum.bins.size(); ++b) {
    ReliabilityBin& bin = sum.bins[b];
    const ReliabilityBin& other = more.bins[b];
    bin.mean_error_mm =
        mean(bin.mean_error_mm, double(bin.places), other.mean_error_mm, double(other.places));
    bin.wrong = mean(bin.wrong, double(bin.places), other.wrong, double(other.places));
    bin.share = mean(bin.share, before, other.share, added);
    bin.really = mean(bin.really, before, other.really, added);
    bin.places += other.places;
  }
  sum.stated_certain = mean(sum.stated_certain, before, more.stated_certain, added);
  sum.really_certain = mean(sum.really_certain, before, more.really_certain, added);
}

std::string rangeOf(const ReliabilityBin& bin) {
  return bin.to_mm > 1e6 ? formatted("> %g", bin.from_mm) : formatted("%g-%g", bin.from_mm, bin.to_mm);
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
    for (const auto& p : places) {
      if (isWithin(p.doubt_mm, bin)) errors.push_back(p.error_mm);
      bin.really += isWithin(p.error_mm, bin) ? 1.0 / double(places.size()) : 0.0;
    }
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
      text += head + rangeOf(bin) +
              formatted(" | %.1f | %.2f | %.2f | %.1f |\n", 100 * bin.share, bin.mean_error_mm,
                        bin.p90_error_mm, 100 * bin.wrong);
    }
    text += head + formatted("all: %.1f %% stated within 2 mm, %.1f %% are | | | | |\n",
                             100 * row.stated_certain, 100 * row.really_certain);
  }
  return text;
}

std::vector<ReliabilityRow> pooledReliability(const std::vector<ReliabilityRow>& rows) {
  struct Group {
    ReliabilityRow sum;
    int scans = 0;
  };
  std::map<std::pair<std::string, std::string>, Group> groups;  // contrast "": all scans of the method
  const auto add = [&](const ReliabilityRow& row, const std::string& contrast) {
    Group& group = groups[{row.method, contrast}];
    if (group.scans++ == 0) group.sum = reliabilityRow({}, row.method, row.against, {});
    group.sum.contrast = contrast;
    addPoints(row, group.sum);
  };
  for (const auto& row : rows) {
    if (row.against != "true surface") continue;
    add(row, {});
    if (!row.contrast.empty()) add(row, row.contrast);
  }
  std::vector<ReliabilityRow> pooled;
  for (auto& [key, group] : groups) {
    const auto all = groups.find({key.first, {}});
    if (!key.second.empty() && group.scans == all->second.scans) continue;  // the only contrast
    group.sum.volume = std::to_string(group.scans) + (group.scans == 1 ? " scan" : " scans");
    pooled.push_back(group.sum);
  }
  return pooled;
}

std::string doubtBandsMarkdown(const std::vector<ReliabilityRow>& rows) {
  std::string text =
      "| scans | method | seen as | doubt or error (mm) | stated (%) | really (%) | > 2 mm off of those "
      "stated "
      "(%) |\n| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const auto& row : rows)
    for (const auto& bin : row.bins)
      text += "| " + markdownCell(row.volume) + " | " + markdownCell(row.method) + " | " +
              markdownCell(row.contrast.empty() ? "all" : row.contrast) + " | " + rangeOf(bin) +
              formatted(" | %.1f | %.1f | %.1f |\n", 100 * bin.share, 100 * bin.really, 100 * bin.wrong);
  return text;
}

}  // namespace facenav::evaluation
