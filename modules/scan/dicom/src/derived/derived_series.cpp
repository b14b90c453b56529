#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_folder.h"
#include "facenav/dicom/derived_objects.h"
#include "header/put_values.h"
#include "header/tag_values.h"
#include "series/series_stack.h"
#include "source_elements.h"

namespace facenav::dicom {
namespace fs = std::filesystem;
namespace {

using gdcm::Tag;
using gdcm::VR;

constexpr const char* kMrImage = "1.2.840.10008.5.1.4.1.1.4";
constexpr int kFirstOwnSeries = 9000;  // series numbers of scanners are lower

/// How values become 16-bit numbers: as they are, or scaled.
struct StoredRange {
  double offset = 0, factor = 1;
  bool is_signed = false;

  explicit StoredRange(const volume::Volume& volume) {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    bool is_whole = true;
    for (const float value : volume.voxels) {
      if (!std::isfinite(value)) throw Error("the series holds values that are no numbers");
      low = std::min(low, double(value));
      high = std::max(high, double(value));
      is_whole = is_whole && value == std::round(value);
    }
    is_signed = low < 0;
    if (is_whole && low >= (is_signed ? -32768 : 0) && high <= (is_signed ? 32767 : 65535)) return;
    is_signed = false;
    offset = low;
    factor = high > low ? 4095 / (high - low) : 1;
  }
  double operator()(double value) const { return std::round((value - offset) * factor); }
};

/// Characters of the longest number of a decimal string.
std::size_t longestNumber(const std::string& words) {
  std::size_t longest = 0;
  for (std::size_t start = 0; start <= words.size();) {
    const std::size_t end = std::min(words.find('\\', start), words.size());
    longest = std::max(longest, end - start);
    start = end + 1;
  }
  return longest;
}

/// Writes the images of a series in the order of their stack.
class DerivedImages {
 public:
  DerivedImages(const SeriesInfo& source, const SeriesStack& read, const volume::Volume& drawn,
                const DerivedSeries& words)
      : source_(source), read_(read), drawn_(drawn), words_(words), range_(drawn) {}

  void write(int k, const fs::path& path) {
    const ImageRef image = read_.stack.order[std::size_t(k)];
    const SliceHeader& header = read_.headers[std::size_t(image.header)];
    gdcm::DataSet data;
    const gdcm::DataSet& from = elementsOf(image.header);
    copyPatientAndStudy(from, source_, data);
    copyMeasurement(from, data);
    putOwnIdentity(data, kMrImage, series_uid_, "MR",
                   kFirstOwnSeries + std::clamp(source_.series_number, 0, 999));
    putWords(data);
    gdcm::DataSet reference;
    putSourceImage(reference, header, image.frame);
    putItems(data, {0x0008, 0x2112}, {reference});
    putPlace(data, from, image);
    put(data, {0x0020, 0x0013}, VR::IS, std::to_string(k + 1));
    putPixels(data, k);
    writeDataSet(data, path.string());
  }

 private:
  /// Elements of a file; those of the last one are kept, since an enhanced file holds many images.
  const gdcm::DataSet& elementsOf(int header) {
    if (header != held_) {
      FilePrefix file(read_.headers[std::size_t(header)].file);
      elements_ = readElements(file);
      held_ = header;
    }
    return elements_;
  }

  void putWords(gdcm::DataSet& data) const {
    put(data, {0x0008, 0x0008}, VR::CS, "DERIVED\\SECONDARY\\OTHER");
    put(data, {0x0008, 0x103E}, VR::LO, textFor(data, words_.description, 64));
    std::string derivation = words_.derivation;
    if (range_.factor != 1 || range_.offset != 0) derivation += "; values scaled to 0..4095";
    put(data, {0x0008, 0x2111}, VR::ST, textFor(data, derivation, 1024));
  }

  /// The place of the image; a classic file's own words, since a number written anew may differ in its last
  /// digit.
  void putPlace(gdcm::DataSet& data, const gdcm::DataSet& from, ImageRef image) const {
    const ImagePlace& place = placeOf(read_.headers, image);
    const auto& p = *place.position_lps_mm;
    const auto& a = *place.axes_lps;
    const double gap_mm = drawn_.grid.spacing_mm()[2];
    const double thickness_mm = read_.headers[std::size_t(image.header)].slice_thickness_mm;
    putOwnWords(data, from, {0x0020, 0x0032}, {p.x(), p.y(), p.z()});
    putOwnWords(data, from, {0x0020, 0x0037}, {a(0, 0), a(1, 0), a(2, 0), a(0, 1), a(1, 1), a(2, 1)});
    putOwnWords(data, from, {0x0028, 0x0030}, {(*place.spacing_mm)[1], (*place.spacing_mm)[0]});
    putOwnWords(data, from, {0x0018, 0x0050}, {thickness_mm > 0 ? thickness_mm : gap_mm});
    put(data, {0x0018, 0x0088}, VR::DS, decimal(gap_mm));
    const std::string frame_uid = frameOfReferenceOf(from, source_);
    put(data, {0x0020, 0x0052}, VR::UI, frame_uid.empty() ? own_frame_uid_ : frame_uid);
  }

  /// Puts the file's own words where they state these values in at most 16 characters each, as DICOM
  /// requires; an enhanced file states them a frame.
  static void putOwnWords(gdcm::DataSet& data, const gdcm::DataSet& from, Tag tag,
                          const std::vector<double>& values) {
    std::string words = text(from, tag);
    if (numbers(from, tag) != values || longestNumber(words) > 16) {
      words.clear();
      for (const double value : values) words += (words.empty() ? "" : "\\") + decimal(value);
    }
    put(data, tag, VR::DS, words);
  }

  void putPixels(gdcm::DataSet& data, int k) const {
    const auto& size = drawn_.grid.size;
    put(data, {0x0028, 0x0002}, std::uint16_t(1));
    put(data, {0x0028, 0x0004}, VR::CS, "MONOCHROME2");
    put(data, {0x0028, 0x0010}, std::uint16_t(size[1]));
    put(data, {0x0028, 0x0011}, std::uint16_t(size[0]));
    put(data, {0x0028, 0x0100}, std::uint16_t(16));
    put(data, {0x0028, 0x0101}, std::uint16_t(16));
    put(data, {0x0028, 0x0102}, std::uint16_t(15));
    put(data, {0x0028, 0x0103}, std::uint16_t(range_.is_signed ? 1 : 0));
    const double black = range_(words_.black), white = std::max(black + 1, range_(words_.white));
    // PS3.3 C.11.2.1.2: the window covers centre - 0.5 -+ (width - 1) / 2
    put(data, {0x0028, 0x1050}, VR::DS, decimal((black + white) / 2 + 0.5));
    put(data, {0x0028, 0x1051}, VR::DS, decimal(white - black + 1));
    const std::size_t count = std::size_t(size[0]) * std::size_t(size[1]);
    std::string bytes(count * 2, '\0');
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = std::uint16_t(std::lround(range_(drawn_.voxels[count * std::size_t(k) + i])));
      std::memcpy(&bytes[2 * i], &value, 2);
    }
    put(data, {0x7FE0, 0x0010}, VR::OW, std::move(bytes));
  }

  const SeriesInfo& source_;
  const SeriesStack& read_;
  const volume::Volume& drawn_;
  const DerivedSeries& words_;
  StoredRange range_;
  std::string series_uid_ = newUid(), own_frame_uid_ = newUid();
  gdcm::DataSet elements_;
  int held_ = -1;
};

}  // namespace

int writeDerivedSeries(const SeriesInfo& source, const volume::Volume& drawn, const DerivedSeries& words,
                       const fs::path& folder, bool replaces, TaskMonitor& monitor) {
  if (source.modality != "MR")
    throw Error("is a " + source.modality + " series; only an MR series can be written",
                source.files.empty() ? std::string() : source.files.front().string());
  const SeriesStack read = readStack(source, monitor);
  requireOneIdentity(read.headers);
  FACENAV_EXPECT(drawn.grid.size == read.stack.grid.size && drawn.voxels.size() == drawn.grid.count(),
                 "drawn on another grid than the source's");
  DerivedImages images(source, read, drawn, words);
  WholeFolder whole(folder, FileAccess::owner_only, replaces ? Existing::replace : Existing::refuse);
  const int count = drawn.grid.size[2];
  for (int k = 0; k < count; ++k) {
    monitor.report("writing DICOM images", double(k) / count);
    images.write(k, whole.temporaryPath() / formatted("IM%04d.dcm", k + 1));
  }
  whole.commit();
  return count;
}

}  // namespace facenav::dicom
