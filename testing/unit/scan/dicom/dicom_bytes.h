#pragma once
// DICOM files made byte by byte for tests, independently of GDCM: any transfer syntax, any element, any
// damage.

#include <Eigen/Geometry>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace facenav::testing {

struct Syntax {
  std::string uid = "1.2.840.10008.1.2.1";
  bool is_explicit = true, is_big_endian = false;
};
inline Syntax explicitLittle() { return {}; }
inline Syntax implicitLittle() { return {"1.2.840.10008.1.2", false, false}; }
inline Syntax explicitBig() { return {"1.2.840.10008.1.2.2", true, true}; }

class DataSetBytes {
 public:
  explicit DataSetBytes(Syntax syntax) : syntax_(std::move(syntax)) {}

  DataSetBytes& raw(std::uint32_t tag, const char* vr, std::string value, bool is_undefined_length = false) {
    if (value.size() % 2) value += std::strcmp(vr, "UI") == 0 || vr[0] == 'O' ? '\0' : ' ';
    const std::uint32_t length = is_undefined_length ? 0xFFFFFFFFu : std::uint32_t(value.size());
    number(tag >> 16, 2);
    number(tag & 0xFFFF, 2);
    if (!syntax_.is_explicit) {
      number(length, 4);
    } else if (std::strstr("OB OW OF OD SQ UN UT", vr)) {
      bytes_ += vr;
      number(0, 2);
      number(length, 4);
    } else {
      bytes_ += vr;
      number(length, 2);
    }
    bytes_ += value;
    return *this;
  }
  DataSetBytes& us(std::uint32_t tag, int value) { return raw(tag, "US", encoded(std::uint32_t(value), 2)); }
  DataSetBytes& ds(std::uint32_t tag, std::initializer_list<double> values) {
    std::string text;
    char buffer[40];
    for (const double value : values) {
      std::snprintf(buffer, sizeof buffer, "%.10g", value);
      text += (text.empty() ? "" : "\\") + std::string(buffer);
    }
    return raw(tag, "DS", text);
  }
  DataSetBytes& sequence(std::uint32_t tag, const std::vector<DataSetBytes>& items) {
    std::string value;
    for (const DataSetBytes& item : items)
      value += encoded(0xFFFE, 2) + encoded(0xE000, 2) + encoded(std::uint32_t(item.bytes_.size()), 4) +
               item.bytes_;
    return raw(tag, "SQ", value);
  }
  std::string encoded(std::uint32_t value, int width) const {
    std::string out;
    for (int b = 0; b < width; ++b)
      out += char(value >> 8 * (syntax_.is_big_endian ? width - 1 - b : b) & 0xFF);
    return out;
  }
  const std::string& bytes() const { return bytes_; }
  const Syntax& syntax() const { return syntax_; }

 private:
  void number(std::uint32_t value, int width) { bytes_ += encoded(value, width); }
  Syntax syntax_;
  std::string bytes_;
};

/// File with preamble, meta header and data set.
inline std::string fileOf(const DataSetBytes& data_set) {
  DataSetBytes meta(explicitLittle());
  meta.raw(0x00020010, "UI", data_set.syntax().uid);
  DataSetBytes length(explicitLittle());
  length.raw(0x00020000, "UL", length.encoded(std::uint32_t(meta.bytes().size()), 4));
  return std::string(128, '\0') + "DICM" + length.bytes() + meta.bytes() + data_set.bytes();
}

inline void writeBytes(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

struct Slice {
  Slice() {}  // not "= default": GCC 12 then warns of members it takes for uninitialised
  Syntax syntax;
  int rows = 24, columns = 20, bits_allocated = 16, bits_stored = 12;
  bool is_signed = false;
  double slope = 1, intercept = 0, echo_ms = 3.5, tilt_deg = 0;
  std::string photometric = "MONOCHROME2", image_type = "ORIGINAL\\PRIMARY\\M", modality = "MR";
  std::string series_uid = "1.2.3.4", sop_uid = "1.2.3.4.1", description = "t1_mprage", series_number = "3";
  std::string patient_name = "Secret^Name", patient_id = "id", character_set, contrast_agent;
  std::string sop_class = "1.2.840.10008.5.1.4.1.1.4";
  std::string study_uid = "1.2.3", frame_uid, series_time,
              acquisition_time;  // the last three: omitted if empty
  int instance = 1, acquisition = 0;
  double gap = 0;              // Spacing Between Slices; omitted if 0
  int stated_images = 0;       // Images in Acquisition; omitted if 0
  std::string position_words;  // instead of `position`, if not empty
  Eigen::Vector3d position{-100, -80, 0}, row{1, 0, 0}, column{0, 1, 0};
  double row_spacing = 1.0, column_spacing = 1.0, thickness = 1.5;
  std::vector<int> values;  // rows * columns
};

inline std::string pixelBytes(const Slice& s) {
  const DataSetBytes coder(s.syntax);
  std::string bytes;
  for (const int value : s.values) bytes += coder.encoded(std::uint32_t(value), s.bits_allocated / 8);
  if (s.bits_allocated == 8 && s.syntax.is_big_endian)
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
  return bytes;
}

inline DataSetBytes headerOf(const Slice& s) {
  DataSetBytes d(s.syntax);
  if (!s.character_set.empty()) d.raw(0x00080005, "CS", s.character_set);
  d.raw(0x00080008, "CS", s.image_type).raw(0x00080016, "UI", s.sop_class).raw(0x00080018, "UI", s.sop_uid);
  d.raw(0x00080020, "DA", "20200102");
  if (!s.series_time.empty()) d.raw(0x00080031, "TM", s.series_time);
  if (!s.acquisition_time.empty()) d.raw(0x00080032, "TM", s.acquisition_time);
  d.raw(0x00080060, "CS", s.modality).raw(0x0008103E, "LO", s.description);
  d.raw(0x00100010, "PN", s.patient_name).raw(0x00100020, "LO", s.patient_id);
  if (!s.contrast_agent.empty()) d.raw(0x00180010, "LO", s.contrast_agent);
  d.ds(0x00180050, {s.thickness}).ds(0x00180081, {s.echo_ms});
  if (s.gap != 0) d.ds(0x00180088, {s.gap});
  if (s.tilt_deg != 0) d.ds(0x00181120, {s.tilt_deg});
  d.raw(0x0020000D, "UI", s.study_uid)
      .raw(0x0020000E, "UI", s.series_uid)
      .raw(0x00200011, "IS", s.series_number);
  if (s.acquisition != 0) d.raw(0x00200012, "IS", std::to_string(s.acquisition));
  d.raw(0x00200013, "IS", std::to_string(s.instance));
  if (s.position_words.empty())
    d.ds(0x00200032, {s.position.x(), s.position.y(), s.position.z()});
  else
    d.raw(0x00200032, "DS", s.position_words);
  d.ds(0x00200037, {s.row.x(), s.row.y(), s.row.z(), s.column.x(), s.column.y(), s.column.z()});
  if (!s.frame_uid.empty()) d.raw(0x00200052, "UI", s.frame_uid);
  if (s.stated_images != 0) d.raw(0x00201002, "IS", std::to_string(s.stated_images));
  d.us(0x00280002, 1).raw(0x00280004, "CS", s.photometric).us(0x00280010, s.rows).us(0x00280011, s.columns);
  d.ds(0x00280030, {s.row_spacing, s.column_spacing});
  d.us(0x00280100, s.bits_allocated).us(0x00280101, s.bits_stored).us(0x00280102, s.bits_stored - 1);
  d.us(0x00280103, s.is_signed ? 1 : 0);
  if (s.slope != 1 || s.intercept != 0) d.ds(0x00281052, {s.intercept}).ds(0x00281053, {s.slope});
  return d;
}

inline std::string sliceFile(const Slice& s) {
  return fileOf(headerOf(s).raw(0x7FE00010, "OW", pixelBytes(s)));
}

/// `count` slices along row x column with distinct values; `change` alters slice k before it is written.
template <class Change>
std::vector<Slice> makeSlices(int count, Slice first, Change change) {
  std::vector<Slice> slices;
  const Eigen::Vector3d start = first.position, normal = first.row.cross(first.column);
  const int low = first.is_signed ? -(1 << (first.bits_stored - 1)) : 0, span = 1 << first.bits_stored;
  for (int k = 0; k < count; ++k) {
    Slice s = first;
    s.position = start + normal * first.thickness * k;
    s.sop_uid = s.series_uid + "." + std::to_string(k + 1);
    s.instance = k + 1;
    for (int j = 0; j < s.rows; ++j)
      for (int i = 0; i < s.columns; ++i) s.values.push_back(low + (i * 7 + j * 131 + k * 1009) % span);
    change(s, k);
    slices.push_back(s);
  }
  return slices;
}
inline std::vector<Slice> makeSlices(int count, const Slice& first = {}) {
  return makeSlices(count, first, [](Slice&, int) {});
}

/// Writes slices under names whose order is not that of the slices.
inline void writeSlices(const std::filesystem::path& folder, const std::vector<Slice>& slices) {
  for (std::size_t k = 0; k < slices.size(); ++k)
    writeBytes(folder / ("f" + std::to_string(k * 7919 % 10007)), sliceFile(slices[k]));
}

}  // namespace facenav::testing
