#include <algorithm>
#include <set>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/dicom/derived_objects.h"
#include "header/put_values.h"
#include "header/tag_values.h"
#include "series/series_stack.h"
#include "source_elements.h"

namespace facenav::dicom {
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

constexpr const char* kSegmentation = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr int kSegmentationSeries = 9998;

/// A frame: the part of a segment that lies on an image of the stack.
struct SegmentFrame {
  int segment = 0, image = 0;
};

std::string tagBytes(std::uint16_t group, std::uint16_t element) {
  std::string bytes(reinterpret_cast<const char*>(&group), 2);
  return bytes.append(reinterpret_cast<const char*>(&element), 2);
}

bool hasVoxels(const volume::Mask& mask, int k) {
  const auto begin = mask.voxels.begin() + std::ptrdiff_t(mask.grid.index(0, 0, k));
  const auto size = std::ptrdiff_t(mask.grid.size[0]) * mask.grid.size[1];
  return std::any_of(begin, begin + size, [](std::uint8_t v) { return v != 0; });
}

/// Writes segments on a series' grid (PS3.3 A.51, C.8.20): one binary frame for each segment and image on
/// which it has voxels.
class SegmentationWriter {
 public:
  SegmentationWriter(const SeriesInfo& source, const SeriesStack& read, const std::vector<Segment>& segments)
      : source_(source), read_(read), segments_(segments) {
    for (int s = 0; s < int(segments.size()); ++s) {
      const auto before = frames_.size();
      for (int k = 0; k < read.stack.grid.size[2]; ++k)
        if (hasVoxels(segments[std::size_t(s)].mask, k)) frames_.push_back({s, k});
      if (frames_.size() == before)
        throw Error("'" + segments[std::size_t(s)].label + "' lies outside the images");
    }
  }

  DataSet dataSet(const std::string& description) const {
    DataSet data;
    FilePrefix file(read_.headers[std::size_t(read_.stack.order[0].header)].file);
    const DataSet from = readElements(file);
    copyPatientAndStudy(from, source_, data);
    putOwnIdentity(data, kSegmentation, newUid(), "SEG", kSegmentationSeries);
    put(data, {0x0008, 0x0008}, VR::CS, "DERIVED\\PRIMARY");
    put(data, {0x0008, 0x103E}, VR::LO, textFor(data, description, 64));
    put(data, {0x0018, 0x1000}, VR::LO, "0");
    put(data, {0x0020, 0x0013}, VR::IS, "1");
    const std::string frame_uid = frameOfReferenceOf(from, source_);
    put(data, {0x0020, 0x0052}, VR::UI, frame_uid.empty() ? newUid() : frame_uid);
    put(data, {0x0020, 0x1040}, VR::LO, "");
    put(data, {0x0028, 0x0301}, VR::CS, "NO");
    put(data, {0x0070, 0x0080}, VR::CS, "FACENAV_PLAN");
    put(data, {0x0070, 0x0081}, VR::LO, textFor(data, description, 64));
    put(data, {0x0070, 0x0084}, VR::PN, "FaceNav");
    putReferencedSeries(data);
    putDimensions(data);
    putSegments(data);
    putGroups(data);
    putPixels(data);
    return data;
  }

 private:
  const SliceHeader& headerOf(int k) const {
    return read_.headers[std::size_t(read_.stack.order[std::size_t(k)].header)];
  }

  void putReferencedSeries(DataSet& data) const {
    std::vector<DataSet> instances;
    std::set<std::string> seen;
    for (const ImageRef image : read_.stack.order) {
      const SliceHeader& header = read_.headers[std::size_t(image.header)];
      if (!seen.insert(header.sop_instance).second) continue;
      DataSet instance;
      put(instance, {0x0008, 0x1150}, VR::UI, header.sop_class);
      put(instance, {0x0008, 0x1155}, VR::UI, header.sop_instance);
      instances.push_back(instance);
    }
    DataSet series;
    putItems(series, {0x0008, 0x114A}, instances);
    put(series, {0x0020, 0x000E}, VR::UI, source_.series_uid);
    putItems(data, {0x0008, 0x1115}, {series});
  }

  /// Frames are ordered by segment, then by position.
  static void putDimensions(DataSet& data) {
    const std::string uid = newUid();
    DataSet organization, by_segment, by_position;
    put(organization, {0x0020, 0x9164}, VR::UI, uid);
    putItems(data, {0x0020, 0x9221}, {organization});
    put(by_segment, {0x0020, 0x9164}, VR::UI, uid);
    put(by_segment, {0x0020, 0x9165}, VR::AT, tagBytes(0x0062, 0x000B));
    put(by_segment, {0x0020, 0x9167}, VR::AT, tagBytes(0x0062, 0x000A));
    put(by_position, {0x0020, 0x9164}, VR::UI, uid);
    put(by_position, {0x0020, 0x9165}, VR::AT, tagBytes(0x0020, 0x0032));
    put(by_position, {0x0020, 0x9167}, VR::AT, tagBytes(0x0020, 0x9113));
    putItems(data, {0x0020, 0x9222}, {by_segment, by_position});
  }

  void putSegments(DataSet& data) const {
    std::vector<DataSet> items;
    for (const Segment& segment : segments_) {
      DataSet item;
      if (segment.is_device) {
        putCode(item, {0x0062, 0x0003}, "260787004", "SCT", "Physical object");
        putCode(item, {0x0062, 0x000F}, "49062001", "SCT", "Device");
      } else {
        putCode(item, {0x0062, 0x0003}, "309825002", "SCT", "Spatial and Relational Concept");
        putCode(item, {0x0062, 0x000F}, "111099", "DCM", "Selected region");
      }
      put(item, {0x0062, 0x0004}, std::uint16_t(items.size() + 1));
      put(item, {0x0062, 0x0005}, VR::LO, textFor(data, segment.label, 64));
      put(item, {0x0062, 0x0008}, VR::CS, "MANUAL");  // a person planned it
      items.push_back(item);
    }
    put(data, {0x0062, 0x0001}, VR::CS, "BINARY");
    putItems(data, {0x0062, 0x0002}, items);
  }

  void putGroups(DataSet& data) const {
    const ImagePlace& first = placeOf(read_.headers, read_.stack.order[0]);
    const auto& a = *first.axes_lps;
    const double gap_mm = read_.stack.grid.spacing_mm()[2];
    DataSet measures, orientation, shared;
    put(measures, {0x0018, 0x0050}, VR::DS, decimal(gap_mm));
    put(measures, {0x0018, 0x0088}, VR::DS, decimal(gap_mm));
    put(measures, {0x0028, 0x0030}, VR::DS, decimals({(*first.spacing_mm)[1], (*first.spacing_mm)[0]}));
    put(orientation, {0x0020, 0x0037}, VR::DS,
        decimals({a(0, 0), a(1, 0), a(2, 0), a(0, 1), a(1, 1), a(2, 1)}));
    putItems(shared, {0x0020, 0x9116}, {orientation});
    putItems(shared, {0x0028, 0x9110}, {measures});
    putItems(data, {0x5200, 0x9229}, {shared});
    std::vector<DataSet> frames;
    for (const SegmentFrame& frame : frames_) frames.push_back(groupsOf(frame));
    putItems(data, {0x5200, 0x9230}, frames);
  }

  DataSet groupsOf(const SegmentFrame& frame) const {
    const ImageRef image = read_.stack.order[std::size_t(frame.image)];
    const auto& p = *placeOf(read_.headers, image).position_lps_mm;
    const std::uint32_t indices[2] = {std::uint32_t(frame.segment + 1), std::uint32_t(frame.image + 1)};
    DataSet content, position, identification, source, derivation, groups;
    put(content, {0x0020, 0x9157}, VR::UL, std::string(reinterpret_cast<const char*>(indices), 8));
    put(position, {0x0020, 0x0032}, VR::DS, decimals({p.x(), p.y(), p.z()}));
    put(identification, {0x0062, 0x000B}, std::uint16_t(frame.segment + 1));
    putSourceImage(source, headerOf(frame.image), image.frame);
    putCode(derivation, {0x0008, 0x9215}, "113076", "DCM", "Segmentation");
    putItems(derivation, {0x0008, 0x2112}, {source});
    putItems(groups, {0x0008, 0x9124}, {derivation});
    putItems(groups, {0x0020, 0x9111}, {content});
    putItems(groups, {0x0020, 0x9113}, {position});
    putItems(groups, {0x0062, 0x000A}, {identification});
    return groups;
  }

  /// Puts the frames bit by bit, the lowest bit first, without gaps between frames (PS3.5 8.1.1).
  void putPixels(DataSet& data) const {
    const auto& size = read_.stack.grid.size;
    const std::size_t count = std::size_t(size[0]) * std::size_t(size[1]);
    std::string bytes((frames_.size() * count + 7) / 8, '\0');
    std::size_t bit = 0;
    for (const SegmentFrame& frame : frames_) {
      const auto& mask = segments_[std::size_t(frame.segment)].mask;
      const std::size_t start = count * std::size_t(frame.image);
      for (std::size_t v = 0; v < count; ++v, ++bit)
        if (mask.voxels[start + v]) bytes[bit / 8] = char(bytes[bit / 8] | 1 << bit % 8);
    }
    put(data, {0x0028, 0x0002}, std::uint16_t(1));
    put(data, {0x0028, 0x0004}, VR::CS, "MONOCHROME2");
    put(data, {0x0028, 0x0008}, VR::IS, std::to_string(frames_.size()));
    put(data, {0x0028, 0x0010}, std::uint16_t(size[1]));
    put(data, {0x0028, 0x0011}, std::uint16_t(size[0]));
    put(data, {0x0028, 0x0100}, std::uint16_t(1));
    put(data, {0x0028, 0x0101}, std::uint16_t(1));
    put(data, {0x0028, 0x0102}, std::uint16_t(0));
    put(data, {0x0028, 0x0103}, std::uint16_t(0));
    put(data, {0x0028, 0x2110}, VR::CS, "00");
    put(data, {0x7FE0, 0x0010}, VR::OB, std::move(bytes));
  }

  const SeriesInfo& source_;
  const SeriesStack& read_;
  const std::vector<Segment>& segments_;
  std::vector<SegmentFrame> frames_;
};

}  // namespace

void writeSegmentation(const SeriesInfo& source, const std::vector<Segment>& segments,
                       const std::string& description, const std::filesystem::path& file,
                       TaskMonitor& monitor) {
  FACENAV_EXPECT(!segments.empty(), "a segmentation has segments");
  const SeriesStack read = readStack(source, monitor);
  requireOneIdentity(read.headers);
  for (const Segment& segment : segments)
    FACENAV_EXPECT(segment.mask.grid.size == read.stack.grid.size, "a segment on another grid");
  WholeFile whole(file);
  writeDataSet(SegmentationWriter(source, read, segments).dataSet(description),
               whole.temporaryPath().string());
  whole.commit();
}

}  // namespace facenav::dicom
