#include "single_slices.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "facenav/core/number_text.h"
#include "header/patient_identity.h"
#include "slice_stack.h"

namespace facenav::dicom {
namespace {

using Indices = std::vector<int>;
using Text = std::string SliceHeader::*;

constexpr std::size_t kMostPlaces = 2;  // per UID; a UID with more is a series by itself

bool isCandidate(const SliceHeader& header) {
  if (header.images.size() != 1 || header.voxels.frames != 1 || !header.layout.has_pixels) return false;
  if (header.series_uid.empty() || (header.modality != "MR" && header.modality != "CT")) return false;
  const ImagePlace& place = header.images[0];
  return place.position_lps_mm && place.axes_lps && place.spacing_mm;
}

/// The values that must be equal as text; `patient_number` or the identity represents the patient.
std::string statedTraits(const SliceHeader& h) {
  std::ostringstream key;
  for (const std::string& value :
       {h.patient.sex, h.age_and_weight, h.sop_class, h.modality, h.description, h.protocol, h.manufacturer,
        h.sequence, h.acquisition_kind, h.contrast_agent})
    key << value << '\n';
  for (const double value :
       {h.slice_thickness_mm, h.slice_gap_mm, h.repetition_time_ms, h.inversion_time_ms, h.flip_angle_deg})
    key << formatted("%.4g", value) << '\n';
  key << h.series_number << '\n' << h.voxels.rows << '\n' << h.voxels.columns << '\n' << h.voxels.samples;
  return key.str();
}

bool isSameGeometry(const SliceHeader& a, const SliceHeader& b) {
  const Eigen::Vector2d &spacing_a = *a.images[0].spacing_mm, &spacing_b = *b.images[0].spacing_mm;
  return isSameOrientation(a.images[0], b.images[0]) &&
         (spacing_a - spacing_b).cwiseAbs().maxCoeff() <= 1e-3 * spacing_a.cwiseAbs().maxCoeff();
}

class Joiner {
 public:
  explicit Joiner(const std::vector<SliceHeader>& headers) : headers_(headers) {}

  std::vector<Join> join() const {
    std::vector<Join> joins;
    for (const Indices& alike : agreeingSlices(candidates()))
      for (const Indices& scan : splitByMeaningful(alike))
        if (distinct(scan, &SliceHeader::series_uid).size() >= kFewestJoined)
          joins.push_back({scan, describe(scan)});
    return joins;
  }

 private:
  const SliceHeader& at(int h) const { return headers_[std::size_t(h)]; }

  Indices candidates() const {
    struct Cover {
      std::vector<Eigen::Vector3d> places;
      Indices slices;
      bool is_fragment = true;
    };
    std::map<std::pair<std::string, std::optional<int>>, Cover> by_uid;
    for (std::size_t h = 0; h < headers_.size(); ++h) {
      Cover& cover = by_uid[{headers_[h].series_uid, headers_[h].patient_number}];
      cover.is_fragment = cover.is_fragment && isCandidate(headers_[h]);
      if (!cover.is_fragment) continue;
      const Eigen::Vector3d& place = *headers_[h].images[0].position_lps_mm;
      if (std::find(cover.places.begin(), cover.places.end(), place) == cover.places.end())
        cover.places.push_back(place);
      cover.is_fragment = cover.places.size() <= kMostPlaces;
      cover.slices.push_back(int(h));
    }
    Indices all;
    for (const auto& [uid, cover] : by_uid)
      if (cover.is_fragment) all.insert(all.end(), cover.slices.begin(), cover.slices.end());
    std::sort(all.begin(), all.end());
    return all;
  }

  std::vector<Indices> agreeingSlices(const Indices& slices) const {
    std::map<std::pair<std::optional<int>, std::string>, std::vector<Indices>> by_traits;  // then by geometry
    for (const int h : slices) {
      auto& alike = by_traits[{at(h).patient_number, statedTraits(at(h))}];
      const auto home = std::find_if(alike.begin(), alike.end(), [&](const Indices& known) {
        return isSameGeometry(at(known.front()), at(h));
      });
      if (home == alike.end())
        alike.push_back({h});
      else
        home->push_back(h);
    }
    std::vector<Indices> all;
    for (auto& [traits, alike] : by_traits)
      for (Indices& one : alike)
        if (one.size() >= kFewestJoined) all.push_back(std::move(one));
    return all;
  }

  std::map<std::string, Indices> distinct(const Indices& slices, Text value) const {
    std::map<std::string, Indices> by_value;
    for (const int h : slices) by_value[at(h).*value].push_back(h);
    return by_value;
  }

  /// A value separates scans if each value covers a stack of slices. A value that differs in nearly every
  /// slice is as scrambled as the Series Instance UID and is ignored.
  bool isMeaningful(const std::map<std::string, Indices>& by_value, std::size_t slices) const {
    return by_value.size() * kFewestJoined <= slices;
  }

  std::vector<Indices> splitByMeaningful(const Indices& slices) const {
    std::vector<Indices> parts{slices};
    for (const Text value :
         {&SliceHeader::study_uid, &SliceHeader::frame_of_reference_uid, &SliceHeader::series_time}) {
      std::vector<Indices> finer;
      for (const Indices& part : parts) {
        const auto by_value = distinct(part, value);
        if (!isMeaningful(by_value, part.size()))
          finer.push_back(part);
        else
          for (const auto& [word, some] : by_value) finer.push_back(some);
      }
      parts = std::move(finer);
    }
    return parts;
  }

  JoinedSlices describe(const Indices& slices) const {
    const auto by_series = distinct(slices, &SliceHeader::series_uid);
    const SliceHeader& first = at(by_series.begin()->second.front());
    JoinedSlices joined;
    joined.series_uid = first.series_uid;
    joined.study_uid = first.study_uid;
    joined.frame_of_reference_uid = first.frame_of_reference_uid;
    joined.series_uids = int(by_series.size());
    joined.study_uids = int(distinct(slices, &SliceHeader::study_uid).size());
    const auto by_frame = distinct(slices, &SliceHeader::frame_of_reference_uid);
    joined.frame_of_reference_uids = int(by_frame.size() - by_frame.count(""));
    const auto state = [&](SliceTrait trait, bool is_stated) {
      (is_stated ? joined.agreeing : joined.unstated).push_back(trait);
    };
    state(SliceTrait::patient, !isSamePatient(first.patient, {}));
    state(SliceTrait::series_number, first.series_number != 0);
    if (distinct(slices, &SliceHeader::series_time).size() == 1)
      state(SliceTrait::series_time, first.series_time.back() != ' ');
    state(SliceTrait::description, !first.description.empty());
    return joined;
  }

  const std::vector<SliceHeader>& headers_;
};

}  // namespace

std::vector<Join> joinSingleSlices(const std::vector<SliceHeader>& headers) { return Joiner(headers).join(); }

bool isOfOneScan(const SliceHeader& a, const SliceHeader& b) {
  return isCandidate(a) && isCandidate(b) && isSamePatient(a.patient, b.patient) &&
         statedTraits(a) == statedTraits(b) && isSameGeometry(a, b);
}

}  // namespace facenav::dicom
