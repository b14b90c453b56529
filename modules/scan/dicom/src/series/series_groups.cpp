#include "series_groups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "readings.h"
#include "single_slices.h"

namespace facenav::dicom {
namespace {

class Grouper {
 public:
  explicit Grouper(const std::vector<SliceHeader>& headers) : headers_(headers) {}

  std::vector<SeriesGroup> group(const std::vector<ImageRef>& images) const {
    std::vector<SeriesGroup> groups;
    for (const ImageRef image : images) {
      const auto home = std::find_if(groups.begin(), groups.end(), [&](const SeriesGroup& group) {
        return isSameSort(group.images[0], image) && isSameGeometry(group.images[0], image);
      });
      if (home == groups.end())
        groups.push_back({{image}, "", false});
      else
        home->images.push_back(image);
    }
    joinStacks(groups);
    takeInStrays(groups);
    joinScattered(groups);
    nameParts(groups);
    return groups;
  }

 private:
  const SliceHeader& headerOf(ImageRef image) const { return headers_[std::size_t(image.header)]; }

  bool isSameSort(ImageRef a, ImageRef b) const {
    return placeOf(headers_, a).stack == placeOf(headers_, b).stack && isSameSortOfAnyStack(a, b);
  }

  bool isSameSortOfAnyStack(ImageRef a, ImageRef b) const {
    const SliceHeader &ha = headerOf(a), &hb = headerOf(b);
    const ImagePlace &pa = placeOf(headers_, a), &pb = placeOf(headers_, b);
    return ha.sop_class == hb.sop_class && ha.layout.has_pixels == hb.layout.has_pixels &&
           ha.voxels.samples == hb.voxels.samples && pa.kind == pb.kind &&
           std::abs(pa.echo_time_ms - pb.echo_time_ms) <= 0.02 + 1e-3 * std::abs(pa.echo_time_ms);
  }

  bool isSameGeometry(ImageRef a, ImageRef b) const {
    const SliceHeader &ha = headerOf(a), &hb = headerOf(b);
    const ImagePlace &pa = placeOf(headers_, a), &pb = placeOf(headers_, b);
    if (ha.voxels.rows != hb.voxels.rows || ha.voxels.columns != hb.voxels.columns) return false;
    if (!isSameOrientation(pa, pb) || pa.spacing_mm.has_value() != pb.spacing_mm.has_value()) return false;
    if (!pa.spacing_mm) return true;
    return (*pa.spacing_mm - *pb.spacing_mm).cwiseAbs().maxCoeff() <=
           1e-3 * pa.spacing_mm->cwiseAbs().maxCoeff();
  }

  /// Stack IDs number parts of a scan in any way that the scanner likes. Stacks that together are one even
  /// volume without an image twice are that volume.
  void joinStacks(std::vector<SeriesGroup>& groups) const {
    constexpr std::size_t kFewest = 3;
    for (std::size_t first = 0; first < groups.size(); ++first) {
      const auto belongs = [&](const SeriesGroup& other) {
        return isSameSortOfAnyStack(groups[first].images[0], other.images[0]) &&
               isSameGeometry(groups[first].images[0], other.images[0]);
      };
      SeriesGroup whole = groups[first];
      for (std::size_t g = first + 1; g < groups.size(); ++g) {
        if (!belongs(groups[g])) continue;
        whole.images.insert(whole.images.end(), groups[g].images.begin(), groups[g].images.end());
        ++whole.stacks;
      }
      if (whole.stacks == 1 || whole.images.size() < kFewest) continue;
      const SliceStack stack = stackSlices(headers_, whole.images);
      if (stack.fault || !stack.coincident.empty()) continue;
      const auto others = groups.begin() + std::ptrdiff_t(first) + 1;
      groups.erase(std::remove_if(others, groups.end(), belongs), groups.end());
      groups[first] = std::move(whole);
    }
  }

  /// A large volume with a few deviating slices is one damaged volume.
  void takeInStrays(std::vector<SeriesGroup>& groups) const {
    constexpr std::size_t kLarge = 10, kFewerBy = 8;
    for (std::size_t large = 0; large < groups.size(); ++large) {
      if (groups[large].images.size() < kLarge) continue;
      for (std::size_t stray = groups.size(); stray-- > 0;) {
        if (stray == large || groups[stray].images.size() * kFewerBy > groups[large].images.size()) continue;
        if (!isSameSort(groups[large].images[0], groups[stray].images[0])) continue;
        groups[large].images.insert(groups[large].images.end(), groups[stray].images.begin(),
                                    groups[stray].images.end());
        groups.erase(groups.begin() + std::ptrdiff_t(stray));
        if (stray < large) --large;
      }
    }
  }

  void joinScattered(std::vector<SeriesGroup>& groups) const {
    constexpr std::size_t kFew = 2;
    for (std::size_t first = 0; first < groups.size(); ++first)
      for (std::size_t other = groups.size() - 1; other > first; --other) {
        SeriesGroup &a = groups[first], &b = groups[other];
        if (!(a.is_scattered || a.images.size() <= kFew) || b.images.size() > kFew) continue;
        if (!isSameSort(a.images[0], b.images[0]) || !headerOf(a.images[0]).layout.has_pixels) continue;
        if (isSameOrientation(placeOf(headers_, a.images[0]), placeOf(headers_, b.images[0]))) continue;
        a.images.insert(a.images.end(), b.images.begin(), b.images.end());
        a.is_scattered = true;
        groups.erase(groups.begin() + std::ptrdiff_t(other));
      }
  }

  void nameParts(std::vector<SeriesGroup>& groups) const {
    if (groups.size() < 2) return;
    const auto differs = [&](auto value) {
      return std::any_of(groups.begin(), groups.end(), [&](const SeriesGroup& g) {
        return value(g.images[0]) != value(groups[0].images[0]);
      });
    };
    const auto echo = [&](ImageRef i) { return placeOf(headers_, i).echo_time_ms; };
    const auto kind = [&](ImageRef i) { return placeOf(headers_, i).kind; };
    const auto stack = [&](ImageRef i) { return placeOf(headers_, i).stack; };
    const bool tells_echo = differs(echo), tells_kind = differs(kind), tells_stack = differs(stack);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const ImageRef first = groups[g].images[0];
      std::ostringstream part;
      if (tells_echo) part << "echo " << echo(first) << " ms, ";
      if (tells_kind) part << kindInWords(kind(first)) << ", ";
      groups[g].is_magnitude_part = tells_kind && isMagnitude(kind(first));
      if (tells_stack) part << "stack " << stack(first) << ", ";
      std::string words = part.str();
      if (words.empty()) words = "part " + std::to_string(g + 1) + ", ";
      groups[g].part = words.substr(0, words.size() - 2);
    }
  }

  /// True if `word` is one of the values of Image Type.
  static bool has(const std::string& kind, const char* word) {
    return ("\\" + kind + "\\").find(std::string("\\") + word + "\\") != std::string::npos;
  }
  static bool isMagnitude(const std::string& kind) {
    return kindOf(kind, "") == ImageKind::magnitude && (has(kind, "M") || has(kind, "MAGNITUDE"));
  }

  static std::string kindInWords(const std::string& kind) {
    const ImageKind stated = kindOf(kind, "");
    if (stated == ImageKind::phase) return "phase";
    if (stated != ImageKind::magnitude) return inWords(stated);
    if (isMagnitude(kind)) return has(kind, "DERIVED") ? "derived magnitude" : "magnitude";
    std::string words = kind.empty() ? "no image type" : kind;
    std::replace(words.begin(), words.end(), '\\', '/');
    return words;
  }

  const std::vector<SliceHeader>& headers_;
};

}  // namespace

std::vector<SeriesGroup> groupImages(const std::vector<SliceHeader>& headers) {
  const std::vector<Join> joins = joinSingleSlices(headers);
  std::vector<int> join_of(headers.size(), -1);
  for (std::size_t j = 0; j < joins.size(); ++j)
    for (const int h : joins[j].headers) join_of[std::size_t(h)] = int(j);
  // Images by UID, patient and join.
  std::map<std::tuple<std::string, std::optional<int>, int>, std::vector<ImageRef>> by_uid;
  for (std::size_t h = 0; h < headers.size(); ++h) {
    const int join = join_of[h];
    const std::string& uid = join < 0 ? headers[h].series_uid : joins[std::size_t(join)].finding.series_uid;
    for (std::size_t f = 0; f < headers[h].images.size(); ++f)
      by_uid[{uid, headers[h].patient_number, join}].push_back({int(h), int(f)});
  }
  std::vector<SeriesGroup> groups;
  const Grouper grouper(headers);
  for (const auto& [key, images] : by_uid)
    for (auto& group : grouper.group(images)) {
      const int join = std::get<2>(key);
      if (join < 0) {
        groups.push_back(std::move(group));
        continue;
      }
      group.joined = joins[std::size_t(join)].finding;
      for (auto& reading : readingsOf(headers, group)) groups.push_back(std::move(reading));
    }
  return groups;
}

}  // namespace facenav::dicom
