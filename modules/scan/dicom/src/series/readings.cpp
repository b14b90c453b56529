#include "readings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "duplicates.h"
#include "single_slices.h"

namespace facenav::dicom {
namespace {

constexpr std::size_t kMostParts = 8;  // more stacks at one place form a time series
constexpr double kSameGap = 0.05;      // tolerance, as a share of the gap in the files

/// Attribute value of an image, which may identify its stack: a number or a word.
using Mark = std::pair<long, std::string>;
struct Part {
  std::string words;
  std::vector<ImageRef> images;
};
using Partition = std::vector<Part>;

class Reader {
 public:
  Reader(const std::vector<SliceHeader>& headers, const SeriesGroup& group)
      : headers_(headers), group_(group), stack_(stackSlices(headers, group.images)) {
    for (std::size_t k = 0; k < stack_.order.size(); ++k) place_of_[idOf(stack_.order[k])] = long(k);
    for (const auto& [kept, twin] : stack_.coincident) place_of_[idOf(twin)] = place_of_[idOf(kept)];
  }

  std::vector<SeriesGroup> read() const {
    if (stack_.order.size() < kFewestJoined) return {group_};
    const bool is_one_volume = areSame(stack_.coincident);
    if (is_one_volume && !stack_.fault && isAsDenseAsStated()) return {group_};
    const auto partitions = otherPartitions(is_one_volume);
    if (partitions.empty()) return {group_};
    std::vector<SeriesGroup> groups{named("all slices", group_.images)};
    for (const Partition& partition : partitions)
      for (const Part& part : partition) groups.push_back(named(part.words, part.images));
    const bool is_whole_readable = is_one_volume && !stack_.fault;
    for (SeriesGroup& group : groups)
      group.joined->readings = int(groups.size()) - (is_whole_readable ? 0 : 1);
    return groups;
  }

 private:
  using Id = std::pair<int, int>;
  static Id idOf(ImageRef image) { return {image.header, image.frame}; }
  const SliceHeader& headerOf(ImageRef image) const { return headers_[std::size_t(image.header)]; }
  long placeIndex(ImageRef image) const { return place_of_.at(idOf(image)); }

  bool areSame(const std::vector<std::pair<ImageRef, ImageRef>>& pairs) const {
    return std::all_of(pairs.begin(), pairs.end(),
                       [&](const auto& pair) { return isSameImage(headers_, pair.first, pair.second); });
  }

  /// Compares the gap with Spacing Between Slices if the files have it, otherwise with Slice Thickness.
  bool isAsDenseAsStated() const {
    const SliceHeader& header = headerOf(stack_.order[0]);
    const double stated_mm = header.slice_gap_mm > 0 ? header.slice_gap_mm : header.slice_thickness_mm;
    return std::abs(stack_.grid.spacing_mm()[2] - stated_mm) <= kSameGap * stated_mm;
  }

  std::vector<Partition> otherPartitions(bool is_one_volume) const {
    std::vector<Partition> found;
    std::set<std::vector<std::size_t>> known;
    const auto offer = [&](const Partition& partition) {
      if (!isReading(partition, is_one_volume) || !known.insert(labelsOf(partition)).second) return;
      found.push_back(partition);
    };
    offer(numbered("acquisition number", [&](ImageRef i) { return long(headerOf(i).acquisition_number); }));
    offer(numbered("temporal position", [&](ImageRef i) { return long(placeOf(headers_, i).time_index); }));
    offer(inOrder("acquisition time", [&](ImageRef i) { return Mark{0, headerOf(i).acquisition_time}; }));
    offer(inOrder("folder", [&](ImageRef i) { return Mark{0, headerOf(i).file.parent_path().string()}; }));
    if (is_one_volume)
      offer(byRank(
          "repeated instance numbers", [&](ImageRef i) { return long(headerOf(i).instance_number); },
          [&](ImageRef i) { return placeIndex(i); }));
    else
      offer(byRank(
          "instance order", [&](ImageRef i) { return placeIndex(i); },
          [&](ImageRef i) { return long(headerOf(i).instance_number); }));
    return found;
  }

  template <class MarkOf>
  std::map<Mark, std::vector<ImageRef>> markedBy(MarkOf markOf) const {
    std::map<Mark, std::vector<ImageRef>> parts;
    for (const ImageRef image : group_.images) parts[markOf(image)].push_back(image);
    return parts;
  }

  template <class NumberOf>
  Partition numbered(const std::string& name, NumberOf numberOf) const {
    Partition partition;
    for (const auto& [mark, images] : markedBy([&](ImageRef i) { return Mark{numberOf(i), ""}; }))
      partition.push_back({name + " " + std::to_string(mark.first), images});
    return partition;
  }

  template <class MarkOf>
  Partition inOrder(const std::string& name, MarkOf markOf) const {
    Partition partition;
    const auto parts = markedBy(markOf);
    for (const auto& [mark, images] : parts)
      partition.push_back(
          {name + " " + std::to_string(partition.size() + 1) + " of " + std::to_string(parts.size()),
           images});
    return partition;
  }

  /// Rank of each image among those with the same `shared` value, in the order of `order`. Empty if two
  /// images are equal in both, or if the groups differ in size.
  template <class Shared, class Order>
  Partition byRank(const std::string& name, Shared shared, Order order) const {
    std::map<long, std::map<long, ImageRef>> sharing;
    for (const ImageRef image : group_.images)
      if (!sharing[shared(image)].emplace(order(image), image).second) return {};
    std::map<Id, long> rank;
    for (const auto& [value, images] : sharing) {
      if (images.size() != sharing.begin()->second.size()) return {};
      long place = 0;
      for (const auto& [at, image] : images) rank[idOf(image)] = place++;
    }
    return inOrder(name, [&](ImageRef i) { return Mark{rank.at(idOf(i)), ""}; });
  }

  bool isReading(const Partition& partition, bool is_one_volume) const {
    if (partition.size() < 2 || partition.size() > kMostParts) return false;
    for (const Part& part : partition) {
      if (part.images.size() < kFewestJoined) return false;
      const SliceStack stack = stackSlices(headers_, part.images);
      if (stack.order.empty() || !areSame(stack.coincident)) return false;
      if (is_one_volume && stack.fault) return false;
    }
    return overlaps(partition);
  }

  /// True if the parts overlap: slabs one after the other are one volume acquired in steps, not two volumes.
  bool overlaps(const Partition& partition) const {
    std::vector<std::pair<long, long>> ranges;
    for (const Part& part : partition) {
      std::pair<long, long> range{placeIndex(part.images[0]), placeIndex(part.images[0])};
      for (const ImageRef image : part.images) {
        range.first = std::min(range.first, placeIndex(image));
        range.second = std::max(range.second, placeIndex(image));
      }
      ranges.push_back(range);
    }
    std::sort(ranges.begin(), ranges.end());
    for (std::size_t r = 1; r < ranges.size(); ++r)
      if (ranges[r].first > ranges[r - 1].second) return false;
    return true;
  }

  /// The part of each image; parts are numbered in the order of their first image.
  std::vector<std::size_t> labelsOf(const Partition& partition) const {
    std::map<Id, std::size_t> part_of;
    for (std::size_t p = 0; p < partition.size(); ++p)
      for (const ImageRef image : partition[p].images) part_of[idOf(image)] = p;
    std::map<std::size_t, std::size_t> renumbered;
    std::vector<std::size_t> labels;
    for (const ImageRef image : group_.images)
      labels.push_back(renumbered.emplace(part_of.at(idOf(image)), renumbered.size()).first->second);
    return labels;
  }

  SeriesGroup named(const std::string& words, const std::vector<ImageRef>& images) const {
    SeriesGroup group = group_;
    group.images = images;
    group.part += (group.part.empty() ? "" : ", ") + words;
    return group;
  }

  const std::vector<SliceHeader>& headers_;
  const SeriesGroup& group_;
  SliceStack stack_;
  std::map<Id, long> place_of_;
};

}  // namespace

std::vector<SeriesGroup> readingsOf(const std::vector<SliceHeader>& headers, const SeriesGroup& group) {
  return Reader(headers, group).read();
}

}  // namespace facenav::dicom
