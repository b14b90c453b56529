#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_folder.h"
#include "facenav/dicom/series.h"
#include "header/put_values.h"

namespace facenav::dicom {
namespace fs = std::filesystem;
namespace {

using gdcm::VR;

constexpr const char* kMrImageStorage = "1.2.840.10008.5.1.4.1.1.4";

/// Hash by FNV-1a. The UIDs are derived from it, so that equal volume and tags give equal files.
class Hash {
 public:
  Hash& add(const void* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      state_ = (state_ ^ static_cast<const unsigned char*>(bytes)[i]) * 1099511628211ull;
    return *this;
  }
  Hash& add(const std::string& text) { return add(text.data(), text.size() + 1); }
  /// A UID of the UUID-derived root (PS3.5 B.2), with a suffix for instances.
  std::string uid(int suffix = 0) const {
    return "2.25." + std::to_string(state_) + (suffix ? "." + std::to_string(suffix) : "");
  }

 private:
  std::uint64_t state_ = 14695981039346656037ull;
};

struct SeriesUids {
  std::string study, series, frame_of_reference;
  Hash hash;
};

SeriesUids makeUids(const volume::Volume& volume, const SeriesTags& tags) {
  Hash study;
  study.add(tags.patient_id).add(tags.study_date);
  Hash series = study;
  series.add(tags.description).add(volume.grid.size.data(), sizeof volume.grid.size);
  series.add(volume.grid.mri_from_voxel.matrix().data(), 16 * sizeof(double));
  series.add(volume.voxels.data(), volume.voxels.size() * sizeof(float));
  Hash frame = study;
  frame.add("frame of reference");
  return {study.uid(), series.uid(), frame.uid(), series};
}

class SliceWriter {
 public:
  SliceWriter(const volume::Volume& volume, const SeriesTags& tags)
      : volume_(volume), tags_(tags), uids_(makeUids(volume, tags)) {
    const Eigen::Matrix3d linear = volume.grid.mri_from_voxel.linear();
    const Eigen::DiagonalMatrix<double, 3> lps_from_ras(-1, -1, 1);
    spacing_mm_ = volume.grid.spacing_mm();
    axes_lps_ = lps_from_ras * (linear * spacing_mm_.cwiseInverse().asDiagonal());
    const Eigen::Matrix3d skew = axes_lps_.transpose() * axes_lps_ - Eigen::Matrix3d::Identity();
    if (!linear.allFinite() || !(skew.cwiseAbs().maxCoeff() < 1e-3))
      throw Error("the volume's axes are not at right angles", {}, "resample it first");
    const auto [low, high] = std::minmax_element(volume.voxels.begin(), volume.voxels.end());
    is_signed_ = std::lround(*low) < 0;
    const double most = is_signed_ ? 32767 : 65535;
    if (!(*low >= -32768.5f && *high < most + 0.5))
      throw Error("the volume's values do not fit into 16 bits");
  }

  void write(int slice, const fs::path& path) const {
    gdcm::DataSet data;
    describe(data, slice);
    place(data, slice);
    putPixels(data, slice);
    writeDataSet(data, path.string());
  }

 private:
  void describe(gdcm::DataSet& data, int slice) const {
    put(data, {0x0008, 0x0005}, VR::CS, "ISO_IR 192");
    put(data, {0x0008, 0x0008}, VR::CS, "ORIGINAL\\PRIMARY\\M");
    put(data, {0x0008, 0x0016}, VR::UI, kMrImageStorage);
    put(data, {0x0008, 0x0018}, VR::UI, uids_.hash.uid(slice + 1));
    for (const std::uint16_t element : {0x0020, 0x0021, 0x0022})
      put(data, {0x0008, element}, VR::DA, tags_.study_date);
    put(data, {0x0008, 0x0030}, VR::TM, "120000");
    put(data, {0x0008, 0x0060}, VR::CS, "MR");
    put(data, {0x0008, 0x0070}, VR::LO, "FaceNav");
    put(data, {0x0008, 0x103E}, VR::LO, tags_.description);
    put(data, {0x0010, 0x0010}, VR::PN, tags_.patient_name);
    put(data, {0x0010, 0x0020}, VR::LO, tags_.patient_id);
    put(data, {0x0018, 0x0023}, VR::CS, "3D");
    put(data, {0x0020, 0x000D}, VR::UI, uids_.study);
    put(data, {0x0020, 0x000E}, VR::UI, uids_.series);
    put(data, {0x0020, 0x0010}, VR::SH, "1");
    put(data, {0x0020, 0x0011}, VR::IS, "1");
    put(data, {0x0020, 0x0013}, VR::IS, std::to_string(slice + 1));
    put(data, {0x0020, 0x0052}, VR::UI, uids_.frame_of_reference);
  }

  void place(gdcm::DataSet& data, int slice) const {
    const Eigen::Vector3d ras_mm = volume_.grid.toMri(Eigen::Vector3d(0, 0, slice)).mm;
    const auto row = axes_lps_.col(0), column = axes_lps_.col(1);
    put(data, {0x0018, 0x0050}, VR::DS, decimal(spacing_mm_[2]));
    put(data, {0x0018, 0x0088}, VR::DS, decimal(spacing_mm_[2]));
    put(data, {0x0020, 0x0032}, VR::DS, decimals({-ras_mm.x(), -ras_mm.y(), ras_mm.z()}));
    put(data, {0x0020, 0x0037}, VR::DS,
        decimals({row.x(), row.y(), row.z(), column.x(), column.y(), column.z()}));
    put(data, {0x0028, 0x0030}, VR::DS, decimals({spacing_mm_[1], spacing_mm_[0]}));
  }

  void putPixels(gdcm::DataSet& data, int slice) const {
    put(data, {0x0028, 0x0002}, std::uint16_t(1));
    put(data, {0x0028, 0x0004}, VR::CS, "MONOCHROME2");
    put(data, {0x0028, 0x0010}, std::uint16_t(volume_.grid.size[1]));
    put(data, {0x0028, 0x0011}, std::uint16_t(volume_.grid.size[0]));
    put(data, {0x0028, 0x0100}, std::uint16_t(16));
    put(data, {0x0028, 0x0101}, std::uint16_t(16));
    put(data, {0x0028, 0x0102}, std::uint16_t(15));
    put(data, {0x0028, 0x0103}, std::uint16_t(is_signed_ ? 1 : 0));
    const std::size_t count = std::size_t(volume_.grid.size[0]) * std::size_t(volume_.grid.size[1]);
    std::string bytes(count * 2, '\0');
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = std::uint16_t(std::lround(volume_.voxels[count * std::size_t(slice) + i]));
      std::memcpy(&bytes[2 * i], &value, 2);
    }
    put(data, {0x7FE0, 0x0010}, VR::OW, std::move(bytes));
  }

  const volume::Volume& volume_;
  const SeriesTags& tags_;
  SeriesUids uids_;
  Eigen::Vector3d spacing_mm_;
  Eigen::Matrix3d axes_lps_;  // columns: directions of i, j, k
  bool is_signed_ = false;
};

}  // namespace

void writeSeries(const volume::Volume& volume, const fs::path& folder, const SeriesTags& tags) {
  FACENAV_EXPECT(volume.voxels.size() == volume.grid.count() && !volume.voxels.empty(),
                 "volume and grid differ in size");
  if (volume.grid.size[0] > 65535 || volume.grid.size[1] > 65535)
    throw Error("the volume is too large for DICOM");
  const SliceWriter writer(volume, tags);
  std::error_code error;
  const fs::path named = fs::absolute(folder / ".").lexically_normal().parent_path();  // "out/" is "out"
  fs::create_directories(named.parent_path(), error);
  if (error)
    throw Error("cannot be created (" + error.message() + ")", folder.string(), "choose another place");
  WholeFolder whole(folder);
  for (int k = 0; k < volume.grid.size[2]; ++k) {
    writer.write(k, whole.temporaryPath() / formatted("IM%04d.dcm", k + 1));
  }
  whole.commit();
}

}  // namespace facenav::dicom
