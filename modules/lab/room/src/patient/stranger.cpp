#include "stranger.h"

#include <random>

#include "facenav/room/person_shape.h"

namespace facenav::room {
namespace {

constexpr double kSoftTissue_mm = 2.5;  // beyond the proportions

PersonShape shapeOf(const VirtualPatient& patient, std::uint64_t seed) {
  std::mt19937_64 random(seed * 31 + 5);
  const auto away = [&random] {  // 4 to 9 % larger or smaller
    const double size = 0.04 + 0.05 * double(random() >> 11) * 0x1p-53;
    return 1.0 + (random() % 2 ? size : -size);
  };
  PersonShape shape;
  shape.centre_mm = patient.face_middle.mm;
  shape.scale = {away(), away(), away()};
  shape.noise_mm = Eigen::Vector3d(51.0, 17.0, 23.0) * double(1 + seed % 97);
  shape.soft_mm = 0.5 * kSoftTissue_mm;
  return shape;
}

}  // namespace

std::shared_ptr<const VirtualPatient> strangerLike(const VirtualPatient& patient, std::uint64_t seed) {
  return std::make_shared<const VirtualPatient>(
      shapedLike(patient, shapeOf(patient, seed), seed + 500, true));
}

}  // namespace facenav::room
