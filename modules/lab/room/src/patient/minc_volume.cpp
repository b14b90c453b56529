#include "facenav/room/minc_volume.h"

#include <zlib.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"

namespace facenav::room {
namespace {

using nlohmann::json;

std::string inflate(const std::filesystem::path& path) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file)
    throw Error("file does not exist or cannot be read", path.string(),
                "run ./facenav.sh once, it fetches it");
  std::string content;
  std::vector<char> block(1 << 20);
  int count = 0;
  while ((count = gzread(file.get(), block.data(), unsigned(block.size()))) > 0)
    content.append(block.data(), std::size_t(count));
  if (count < 0) throw Error("compressed file is truncated or damaged", path.string(), "fetch it again");
  return content;
}

struct Axis {
  int length;
  Eigen::Vector3d step_mm, start_mm;
};

Axis axisOf(const json& header, const std::string& name) {
  const json& axis = header.at(name);
  const auto cosines = axis.at("direction_cosines").get<std::vector<double>>();
  if (cosines.size() != 3) throw Error("direction_cosines of " + name + " are not three numbers");
  const Eigen::Vector3d direction(cosines[0], cosines[1], cosines[2]);
  return {axis.at("space_length").get<int>(), axis.at("step").get<double>() * direction,
          axis.at("start").get<double>() * direction};
}

/// Grid with the fastest axis first, as in VoxelGrid.
volume::VoxelGrid gridOf(const json& header) {
  const auto order = header.at("order").get<std::vector<std::string>>();
  if (order.size() != 3) throw Error("order does not name three axes");
  volume::VoxelGrid grid;
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
  for (int index = 0; index < 3; ++index) {
    const Axis axis = axisOf(header, order[std::size_t(2 - index)]);
    if (axis.length < 1) throw Error("space_length of " + order[std::size_t(2 - index)] + " is not positive");
    grid.size[std::size_t(index)] = axis.length;
    grid.mri_from_voxel.linear().col(index) = axis.step_mm;
    origin_mm += axis.start_mm;
  }
  grid.mri_from_voxel.translation() = origin_mm;
  return grid;
}

}  // namespace

volume::Volume readMincVolume(const std::filesystem::path& header_json_gz,
                              const std::filesystem::path& raw_gz) {
  volume::Volume volume;
  try {
    volume.grid = gridOf(json::parse(inflate(header_json_gz)));
  } catch (const json::exception& error) {
    throw Error(std::string("MINC header is malformed: ") + error.what(), header_json_gz.string(),
                "fetch it again");
  }
  const std::string raw = inflate(raw_gz);
  if (raw.size() != volume.grid.count())
    throw Error("holds " + std::to_string(raw.size()) + " voxels, " + std::to_string(volume.grid.count()) +
                    " were expected",
                raw_gz.string(), "fetch it again");
  volume.orientation_source = "MINC";
  volume.voxels.reserve(raw.size());
  for (const char byte : raw) volume.voxels.push_back(float(static_cast<unsigned char>(byte)));
  return volume;
}

}  // namespace facenav::room
