#include "slice_header.h"

#include <gdcmDataSet.h>
#include <gdcmExplicitDataElement.h>
#include <gdcmImplicitDataElement.h>
#include <gdcmSwapper.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bytes/damage_error.h"
#include "tag_values.h"

namespace facenav::dicom {
namespace {

using gdcm::Tag;

/// GDCM writes warnings to the terminal; here each fault gives one Error instead.
void silenceGdcm() {
  static const bool is_silent = [] {  // runs once, in the first thread that arrives
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    gdcm::Trace::DebugOff();
    return true;
  }();
  (void)is_silent;
}

gdcm::DataSet parse(FilePrefix& file, const FileLayout& layout) {
  silenceGdcm();
  std::istringstream stream(
      file.bytes().substr(layout.data_set_start, layout.header_end - layout.data_set_start));
  gdcm::DataSet data;
  try {
    if (layout.is_big_endian)
      data.Read<gdcm::ExplicitDataElement, gdcm::SwapperDoOp>(stream);
    else if (layout.is_explicit)
      data.Read<gdcm::ExplicitDataElement, gdcm::SwapperNoOp>(stream);
    else
      data.Read<gdcm::ImplicitDataElement, gdcm::SwapperNoOp>(stream);
  } catch (const std::exception&) {
    throw DamageError("DICOM header is damaged", file.path());
  }
  return data;
}

std::string isoDate(const std::string& dicom) {
  std::string digits;
  for (const char c : dicom)
    if (c >= '0' && c <= '9') digits += c;
  return digits.size() == 8 ? digits.substr(0, 4) + "-" + digits.substr(4, 2) + "-" + digits.substr(6) : "";
}

VoxelFormat readFormat(const gdcm::DataSet& data) {
  VoxelFormat format;
  format.rows = integer(data, {0x0028, 0x0010}, 0);
  format.columns = integer(data, {0x0028, 0x0011}, 0);
  format.frames = integer(data, {0x0028, 0x0008}, 1);
  format.samples = integer(data, {0x0028, 0x0002}, 1);
  format.bits_allocated = integer(data, {0x0028, 0x0100}, 0);
  format.bits_stored = integer(data, {0x0028, 0x0101}, format.bits_allocated);
  format.high_bit = integer(data, {0x0028, 0x0102}, format.bits_stored - 1);
  format.is_signed = integer(data, {0x0028, 0x0103}, 0) == 1;
  format.photometric = text(data, {0x0028, 0x0004});
  format.has_embedded_overlay = integer(data, {0x6000, 0x0102}, 0) > 0;
  return format;
}

Patient readPatient(const gdcm::DataSet& data) {
  return {personName(data, {0x0010, 0x0010}), text(data, {0x0010, 0x0020}),
          isoDate(text(data, {0x0010, 0x0030})), text(data, {0x0010, 0x0040})};
}

void readDescription(const gdcm::DataSet& data, SliceHeader& header) {
  header.sop_class = text(data, {0x0008, 0x0016});
  header.sop_instance = text(data, {0x0008, 0x0018});
  header.series_uid = text(data, {0x0020, 0x000E});
  header.study_uid = text(data, {0x0020, 0x000D});
  header.description = text(data, {0x0008, 0x103E});
  if (header.description.empty()) header.description = text(data, {0x0018, 0x1030});
  header.modality = text(data, {0x0008, 0x0060});
  for (const Tag& tag : {Tag(0x0008, 0x0021), Tag(0x0008, 0x0022), Tag(0x0008, 0x0020)})
    if (header.date.empty()) header.date = isoDate(text(data, tag));
  header.image_type = text(data, {0x0008, 0x0008});
  header.is_mosaic = header.image_type.find("MOSAIC") != std::string::npos;
  header.is_annotated = header.image_type.rfind("DERIVED", 0) == 0 && text(data, {0x0028, 0x0301}) == "YES";
  header.manufacturer = text(data, {0x0008, 0x0070});
  header.sequence = text(data, {0x0018, 0x0024}) + " " + text(data, {0x0018, 0x0020});
  header.acquisition_kind = text(data, {0x0018, 0x0023});
  header.contrast_agent = text(data, {0x0018, 0x0010});
  header.slice_thickness_mm = number(data, {0x0018, 0x0050}).value_or(0);
  header.repetition_time_ms = number(data, {0x0018, 0x0080}).value_or(0);
  header.inversion_time_ms = number(data, {0x0018, 0x0082}).value_or(0);
  header.gantry_tilt_deg = number(data, {0x0018, 0x1120}).value_or(0);
  header.series_number = integer(data, {0x0020, 0x0011}, 0);
  header.instance_number = integer(data, {0x0020, 0x0013}, 0);
}

void readTraits(const gdcm::DataSet& data, SliceHeader& header) {
  header.frame_of_reference_uid = text(data, {0x0020, 0x0052});
  header.protocol = text(data, {0x0018, 0x1030});
  header.series_time = text(data, {0x0008, 0x0021}) + " " + text(data, {0x0008, 0x0031});
  header.acquisition_time = text(data, {0x0008, 0x0022}) + " " + text(data, {0x0008, 0x0032});
  header.age_and_weight = text(data, {0x0010, 0x1010}) + " " + text(data, {0x0010, 0x1030});
  header.flip_angle_deg = number(data, {0x0018, 0x1314}).value_or(0);
  header.slice_gap_mm = number(data, {0x0018, 0x0088}).value_or(0);
  header.acquisition_number = integer(data, {0x0020, 0x0012}, 0);
  // Images in Acquisition, Number of Series Related Instances
  header.stated_images = std::max(integer(data, {0x0020, 0x1002}, 0), integer(data, {0x0020, 0x1209}, 0));
}

/// GE states the part of the complex signal in a private element alone: 0 magnitude, 1 phase, 2 real, 3
/// imaginary.
std::string gePart(const gdcm::DataSet& data) {
  if (text(data, {0x0043, 0x0010}) != "GEMS_PARM_01") return "";
  constexpr const char* kParts[] = {"", "\\P", "\\R", "\\I"};
  const int part = integer(data, {0x0043, 0x102F}, 0);
  return part > 0 && part < 4 ? kParts[part] : "";
}

ImagePlace classicPlace(const gdcm::DataSet& data, const SliceHeader& header) {
  ImagePlace place;
  readPosition(data, place);
  readOrientation(data, place);
  readSpacing(data, place);
  readRescale(data, place);
  place.echo_time_ms = number(data, {0x0018, 0x0081}).value_or(0);
  place.kind = header.image_type + gePart(data);
  place.time_index = integer(data, {0x0020, 0x0100}, 0);
  return place;
}

}  // namespace

namespace {

/// Reads `count` numbers; otherwise none, and notes a value that cannot be read.
std::vector<double> rowOfNumbers(const gdcm::DataSet& data, Tag tag, std::size_t count, const char* name,
                                 ImagePlace& place) {
  auto values = numbers(data, tag);
  if (values.size() == count) return values;
  const std::string written = text(data, tag);
  if (!written.empty())
    place.unreadable = std::string(name) + " is not " + std::to_string(count) + " numbers" +
                       (written.find(',') != std::string::npos ? ", it has commas for decimal points" : "") +
                       ": '" + written.substr(0, 60) + "'";
  return {};
}

}  // namespace

void readPosition(const gdcm::DataSet& data, ImagePlace& place) {
  const auto p = rowOfNumbers(data, {0x0020, 0x0032}, 3, "Image Position (Patient)", place);
  if (!p.empty()) place.position_lps_mm = Eigen::Vector3d(p[0], p[1], p[2]);
}

void readOrientation(const gdcm::DataSet& data, ImagePlace& place) {
  const auto o = rowOfNumbers(data, {0x0020, 0x0037}, 6, "Image Orientation (Patient)", place);
  if (o.empty()) return;
  Eigen::Matrix<double, 3, 2> axes;
  axes << o[0], o[3], o[1], o[4], o[2], o[5];
  place.axes_lps = axes;
}

void readSpacing(const gdcm::DataSet& data, ImagePlace& place) {
  // between rows first (PS3.3 10.7.1.3)
  const auto s = rowOfNumbers(data, {0x0028, 0x0030}, 2, "Pixel Spacing", place);
  if (!s.empty()) place.spacing_mm = Eigen::Vector2d(s[1], s[0]);
}

void readRescale(const gdcm::DataSet& data, ImagePlace& place) {
  const auto slope = number(data, {0x0028, 0x1053}), intercept = number(data, {0x0028, 0x1052});
  if (slope && *slope != 0) place.slope = *slope;
  if (intercept) place.intercept = *intercept;
  // Philips: values comparable between scans are (stored * RS + RI) / (RS * SS), with SS in a private
  // element.
  const auto philips = number(data, {0x2005, 0x100E});
  if (philips && *philips > 0 && std::isfinite(1.0 / *philips) && slope && *slope != 0) {
    place.intercept /= place.slope * *philips;
    place.slope = 1.0 / *philips;
  }
}

gdcm::DataSet readElements(FilePrefix& file) { return parse(file, walkHeader(file)); }

std::optional<SliceHeader> readSliceHeader(FilePrefix& file) {
  if (!looksLikeDicom(file)) return std::nullopt;
  SliceHeader header;
  header.file = file.path();
  header.layout = walkHeader(file);
  const gdcm::DataSet data = parse(file, header.layout);
  readDescription(data, header);
  readTraits(data, header);
  header.patient = readPatient(data);
  if (header.sop_class.empty() && header.series_uid.empty() && header.modality.empty()) return std::nullopt;
  header.voxels = readFormat(data);
  const ImagePlace classic = classicPlace(data, header);
  const bool is_enhanced =
      data.FindDataElement(Tag(0x5200, 0x9229)) || data.FindDataElement(Tag(0x5200, 0x9230));
  if (is_enhanced)
    header.images = framePlaces(data, classic, header.voxels.frames);
  else
    header.images = {classic};
  return header;
}

}  // namespace facenav::dicom
