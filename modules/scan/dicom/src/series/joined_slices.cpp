#include "facenav/dicom/joined_slices.h"

#include <algorithm>

#include "facenav/dicom/series.h"

namespace facenav::dicom {
namespace {

/// Joins traits to a list: "start, a and b", or "a, b or c" without a start.
std::string listed(const std::string& start, const std::vector<SliceTrait>& traits, const char* last_joint) {
  std::string words = start;
  for (std::size_t t = 0; t < traits.size(); ++t)
    words += (words.empty() ? "" : t + 1 == traits.size() ? last_joint : ", ") + toString(traits[t]);
  return words;
}

}  // namespace

std::string toString(SliceTrait trait) {
  switch (trait) {
    case SliceTrait::patient:
      return "patient";
    case SliceTrait::series_number:
      return "series number";
    case SliceTrait::series_time:
      return "series time";
    case SliceTrait::description:
      return "description";
  }
  return "";
}

bool isOneOfSeveralReadings(const SeriesInfo& series) { return series.joined && series.joined->readings > 1; }

int readingCount(const std::vector<SeriesInfo>& series) {
  return int(std::count_if(series.begin(), series.end(), [](const SeriesInfo& info) {
    return info.is_loadable && isOneOfSeveralReadings(info);
  }));
}

std::string findingId(const JoinedSlices& joined) {
  return joined.readings > 1 ? "slices_joined_in_several_ways" : "slices_joined";
}

std::string inWords(const JoinedSlices& joined) {
  std::string words =
      "slices with " + std::to_string(joined.series_uids) + " different series UIDs were joined: ";
  words +=
      joined.agreeing.empty() ? "geometry and timing" : listed("geometry, timing", joined.agreeing, " and ");
  words += " agree";
  if (!joined.unstated.empty()) words += ", no " + listed("", joined.unstated, " or ") + " is given";
  if (joined.readings > 1)
    words += "; one of " + std::to_string(joined.readings) + " ways to read them: choose the right one";
  return words + (joined.frame_of_reference_uids == 1
                      ? ". They share one frame-of-reference UID"
                      : ". No UID says that they share a frame of reference: look for steps between slices");
}

}  // namespace facenav::dicom
