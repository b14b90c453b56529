#include "mixed_images.h"

#include <algorithm>
#include <set>

namespace facenav::dicom {
namespace {

/// What distinguishes `other` from `info`, for users: "phase image", or the part's name.
std::string differenceOf(const SeriesInfo& info, const SeriesInfo& other) {
  return other.kind != info.kind ? inWords(other.kind) : other.part;
}

/// The smaller groups of the same UID and patient.
std::vector<std::size_t> smallerParts(const std::vector<SeriesInfo>& series, std::size_t of) {
  std::vector<std::size_t> parts;
  for (std::size_t g = 0; g < series.size(); ++g)
    if (g != of && series[g].series_uid == series[of].series_uid && series[g].patient == series[of].patient &&
        series[g].slices < series[of].slices)
      parts.push_back(g);
  return parts;
}

/// True if `images` with those of `parts` are one even stack without an image twice.
bool fillTheStack(const std::vector<SliceHeader>& headers, const std::vector<SeriesGroup>& groups,
                  std::size_t of, const std::vector<std::size_t>& parts) {
  std::vector<ImageRef> images = groups[of].images;
  for (const std::size_t g : parts)
    images.insert(images.end(), groups[g].images.begin(), groups[g].images.end());
  const SliceStack stack = stackSlices(headers, images);
  return !stack.fault && stack.coincident.empty();
}

}  // namespace

void nameMixedImages(std::vector<SeriesInfo>& series, const std::vector<SliceHeader>& headers,
                     const std::vector<SeriesGroup>& groups) {
  for (std::size_t s = 0; s < groups.size(); ++s) {
    SeriesInfo& info = series[s];
    if (info.kind != ImageKind::magnitude || info.series_uid.empty()) continue;
    const auto parts = smallerParts(series, s);
    if (parts.empty()) continue;
    int others = 0;
    std::set<std::string> differences;
    for (const std::size_t g : parts)
      others += series[g].slices, differences.insert(differenceOf(info, series[g]));
    std::string kinds;
    for (const std::string& difference : differences) kinds += (kinds.empty() ? "" : ", ") + difference;
    const std::string words = std::to_string(others) + " of the " + std::to_string(others + info.slices) +
                              " images of this series are of another kind (" + kinds + ")";
    if (!fillTheStack(headers, groups, s, parts)) {
      const bool is_by_kind =
          std::all_of(parts.begin(), parts.end(), [&](std::size_t g) { return series[g].kind != info.kind; });
      if (!info.is_loadable && is_by_kind) info.problem += "; " + words;
      continue;
    }
    if (info.is_loadable) {
      info.notes.push_back(words + " and are left out: the scan may be cut there");
    } else {
      info.problem = words + ", so that the others have gaps";
      info.problem_file = series[parts.front()].files.front();
    }
  }
}

}  // namespace facenav::dicom
