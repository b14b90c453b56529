#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "facenav/core/whole_file.h"
#include "tract_formats.h"

namespace facenav::surface {
namespace {

constexpr std::size_t kTrkHeader = 1000;

template <class T>
T atOffset(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(static_cast<void*>(&value), bytes.data() + offset, sizeof value);
  return value;
}

struct TrkHeader {
  std::array<int, 3> size;
  Eigen::Vector3f voxel_mm;
  int scalars, properties, count;
  Eigen::Affine3f ras_from_voxel;
  std::string order;  // "LPS"
};

TrkHeader readHeader(const std::string& bytes, const std::filesystem::path& path) {
  if (bytes.size() < kTrkHeader || bytes.compare(0, 5, "TRACK") != 0)
    refuseTracts(path, "it is no .trk file");
  const auto stated = atOffset<std::int32_t>(bytes, 996);
  if (stated != int(kTrkHeader))
    refuseTracts(path, stated == int(0xe8030000) ? "it is big-endian" : "its header is damaged");
  TrkHeader header;
  for (std::size_t i = 0; i < 3; ++i) {
    header.size[i] = atOffset<std::int16_t>(bytes, 6 + 2 * i);
    header.voxel_mm[int(i)] = atOffset<float>(bytes, 12 + 4 * i);
  }
  header.scalars = atOffset<std::int16_t>(bytes, 36);
  header.properties = atOffset<std::int16_t>(bytes, 238);
  header.count = atOffset<std::int32_t>(bytes, 988);
  header.ras_from_voxel = Eigen::Affine3f::Identity();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      header.ras_from_voxel(r, c) = atOffset<float>(bytes, 440 + 4 * std::size_t(4 * r + c));
  for (std::size_t i = 0; i < 3; ++i)
    if (const char letter = bytes[948 + i]) header.order += letter;
  if (header.order.empty()) header.order = "LPS";  // TrackVis' rule
  if (!(header.voxel_mm.minCoeff() > 0) || header.scalars < 0 || header.properties < 0 ||
      header.scalars > 10 || header.properties > 10)
    refuseTracts(path, "its header is damaged");
  if (!header.ras_from_voxel.matrix().allFinite() || atOffset<float>(bytes, 500) == 0 ||
      std::abs(header.ras_from_voxel.linear().determinant()) < 1e-9f)
    refuseTracts(path, "its header does not say where its voxels lie (vox_to_ras)");
  return header;
}

/// The letter of the side to which voxel axis `axis` of the affine runs.
char letterOf(const Eigen::Matrix3f& linear, int axis) {
  Eigen::Index row = 0;
  linear.col(axis).cwiseAbs().maxCoeff(&row);
  return linear(row, axis) > 0 ? "RAS"[row] : "LPI"[row];
}

int axisOf(char letter) {
  constexpr const char* kLetters = "RLAPSI";
  const char* found = std::strchr(kLetters, letter);
  return found && letter ? int(found - kLetters) / 2 : -1;
}

/// Map from TrackVis points, which are mm along the axes of voxel_order, from the corner of the first voxel,
/// to RAS.
Eigen::Affine3f rasFromTrackvis(const TrkHeader& header, const std::filesystem::path& path) {
  Eigen::Matrix4f voxel_from_order = Eigen::Matrix4f::Zero();
  voxel_from_order(3, 3) = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const char wanted = letterOf(header.ras_from_voxel.linear(), axis);
    int found = -1;
    for (int i = 0; i < 3 && i < int(header.order.size()); ++i)
      if (axisOf(header.order[std::size_t(i)]) == axisOf(wanted)) found = i;
    if (found < 0) refuseTracts(path, "its voxel order '" + header.order + "' is not known");
    const bool is_same = header.order[std::size_t(found)] == wanted;
    voxel_from_order(axis, found) = is_same ? 1.f : -1.f;
    if (!is_same) voxel_from_order(axis, 3) = float(header.size[std::size_t(found)] - 1);
  }
  Eigen::Affine3f order_from_mm = Eigen::Affine3f::Identity();
  order_from_mm.linear() = header.voxel_mm.cwiseInverse().asDiagonal();
  order_from_mm.translation().setConstant(-0.5f);  // from the corner to the centre
  return header.ras_from_voxel * Eigen::Affine3f(voxel_from_order) * order_from_mm;
}

}  // namespace

TractLines readTrk(const std::filesystem::path& path) {
  const std::string bytes = readWholeFile(path);
  const TrkHeader header = readHeader(bytes, path);
  const Eigen::Affine3f ras_from_mm = rasFromTrackvis(header, path);
  const std::size_t point_bytes = 4 * std::size_t(3 + header.scalars),
                    line_bytes = 4 * std::size_t(header.properties);
  TractLines tracts;
  tracts.points_mm.reserve((bytes.size() - kTrkHeader) / point_bytes);
  std::size_t at = kTrkHeader;
  while (at < bytes.size()) {
    if (bytes.size() - at < 4) refuseTracts(path, "it is cut short");
    const auto points = atOffset<std::int32_t>(bytes, at);
    at += 4;
    if (points < 0) refuseTracts(path, "it is damaged");
    if ((bytes.size() - at) / point_bytes < std::size_t(points) ||
        bytes.size() - at - point_bytes * std::size_t(points) < line_bytes)
      refuseTracts(path, "it is cut short");
    for (int i = 0; i < points; ++i, at += point_bytes)
      tracts.points_mm.push_back(ras_from_mm * atOffset<Eigen::Vector3f>(bytes, at));
    at += line_bytes;
    tracts.ends.push_back(tracts.points_mm.size());
  }
  if (header.count > 0 && tracts.lines() != std::size_t(header.count)) refuseTracts(path, "it is cut short");
  return tracts;
}

}  // namespace facenav::surface
