// POLYDATA and IMAGE.

#include <algorithm>
#include <cmath>

#include "big_endian.h"
#include "facenav/core/error.h"
#include "facenav/links/igtl_content.h"

namespace facenav::links {
namespace {

constexpr std::size_t kImageHeaderSize = 72;
constexpr int kFloat32 = 10, kBigEndian = 1, kLittleEndian = 2, kRas = 1, kLps = 2;

int sizeOfScalar(int type) {
  switch (type) {
    case 2:
    case 3:
      return 1;
    case 4:
    case 5:
      return 2;
    case 6:
    case 7:
    case kFloat32:
      return 4;
    case 11:
      return 8;
    default:
      return 0;
  }
}

/// Value of a voxel from its bits, most significant byte first.
float valueOfScalar(std::uint64_t bits, int type) {
  double real;
  float single;
  const auto low = std::uint32_t(bits);
  switch (type) {
    case 2:
      return float(std::int8_t(low));
    case 4:
      return float(std::int16_t(low));
    case 6:
      return float(std::int32_t(low));
    case kFloat32:
      std::memcpy(&single, &low, sizeof single);
      return single;
    case 11:
      std::memcpy(&real, &bits, sizeof real);
      return float(real);
    default:
      return float(low);
  }
}

std::vector<float> voxelsFrom(const Bytes& bytes, int type, bool is_little) {
  const auto size = std::size_t(sizeOfScalar(type));
  std::vector<float> voxels(bytes.size() / size);
  for (std::size_t n = 0; n < voxels.size(); ++n) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i)
      bits = bits << 8 | bytes[n * size + (is_little ? size - 1 - i : i)];
    voxels[n] = valueOfScalar(bits, type);
  }
  return voxels;
}

/// Adds the polygons' triangles. Returns false if the counts do not fit the bytes, or a point does not exist.
bool addPolygons(BigEndianReader& reader, std::size_t count, IgtlSurface& surface) {
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t corners = reader.take(4);
    if (!reader.isGood() || corners < 3 || corners > reader.left() / 4) return false;
    std::vector<std::uint32_t> polygon(corners);
    for (auto& point : polygon) {
      point = std::uint32_t(reader.take(4));
      if (point >= surface.points_mm.size()) return false;
    }
    for (std::size_t i = 2; i < corners; ++i)
      surface.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }
  return reader.isGood();
}

}  // namespace

Bytes surfaceContent(const IgtlSurface& surface) {
  BigEndianWriter writer;
  const std::size_t polygons = surface.triangles.size();
  writer.bytes.reserve(40 + 12 * surface.points_mm.size() + 16 * polygons);
  writer.put(surface.points_mm.size(), 4);
  for (int i = 0; i < 4; ++i) writer.put(0, 4);  // no vertices, no lines
  writer.put(polygons, 4);
  writer.put(16 * polygons, 4);
  for (int i = 0; i < 3; ++i) writer.put(0, 4);  // no strips, no attributes
  for (const auto& point : surface.points_mm)
    for (int i = 0; i < 3; ++i) writer.putFloat(point[i]);
  for (const auto& triangle : surface.triangles) {
    writer.put(3, 4);
    for (const auto point : triangle) writer.put(point, 4);
  }
  return writer.bytes;
}

std::optional<IgtlSurface> readSurface(const Bytes& content) {
  BigEndianReader reader(content);
  const std::size_t points = reader.take(4);
  reader.take(4);
  const std::size_t vertices_size = reader.take(4);
  reader.take(4);
  const std::size_t lines_size = reader.take(4);
  const std::size_t polygons = reader.take(4), polygons_size = reader.take(4);
  reader.take(8);  // strips
  reader.take(4);  // attributes
  if (!reader.isGood() || points > reader.left() / 12) return std::nullopt;
  IgtlSurface surface;
  surface.points_mm.resize(points);
  for (auto& point : surface.points_mm) {
    for (int i = 0; i < 3; ++i) point[i] = reader.takeFloat();
    if (!point.allFinite()) return std::nullopt;
  }
  if (vertices_size + lines_size + polygons_size > reader.left()) return std::nullopt;
  reader.takeText(vertices_size + lines_size);
  const Bytes bytes = reader.takeBytes(polygons_size);
  BigEndianReader corners(bytes);
  if (!addPolygons(corners, polygons, surface)) return std::nullopt;
  return surface;
}

Bytes imageContent(const IgtlImage& image) {
  for (const int size : image.size)
    if (size < 1 || size > 65535)
      throw Error("an image of " + std::to_string(size) + " voxels along an axis cannot be sent");
  BigEndianWriter writer;
  writer.bytes.reserve(kImageHeaderSize + 4 * image.voxels.size());
  writer.put(1, 2);
  for (const int value : {1, kFloat32, kLittleEndian, kRas}) writer.put(std::uint64_t(value), 1);
  for (const int size : image.size) writer.put(std::uint64_t(size), 2);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) writer.putFloat(image.steps_mm(row, column));
  for (int row = 0; row < 3; ++row) writer.putFloat(image.centre_mm[row]);
  for (int i = 0; i < 3; ++i) writer.put(0, 2);
  for (const int size : image.size) writer.put(std::uint64_t(size), 2);
  for (const float voxel : image.voxels) {
    std::uint32_t bits;
    std::memcpy(&bits, &voxel, sizeof bits);
    for (int i = 0; i < 4; ++i) writer.bytes.push_back(std::uint8_t(bits >> (8 * i)));
  }
  return writer.bytes;
}

std::optional<IgtlImage> readImage(const Bytes& content) {
  BigEndianReader reader(content);
  IgtlImage image;
  reader.take(2);
  const int components = int(reader.take(1)), type = int(reader.take(1)), endian = int(reader.take(1)),
            axes = int(reader.take(1));
  for (auto& size : image.size) size = int(reader.take(2));
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) image.steps_mm(row, column) = reader.takeFloat();
  for (int row = 0; row < 3; ++row) image.centre_mm[row] = reader.takeFloat();
  reader.take(6);  // corner of the part that is sent
  std::array<int, 3> part{};
  for (auto& size : part) size = int(reader.take(2));
  const auto scalar = std::size_t(sizeOfScalar(type));
  const std::size_t voxels =
      std::size_t(image.size[0]) * std::size_t(image.size[1]) * std::size_t(image.size[2]);
  const bool is_known = components == 1 && scalar > 0 && (endian == kBigEndian || endian == kLittleEndian) &&
                        (axes == kRas || axes == kLps);
  if (!reader.isGood() || !is_known || part != image.size || voxels * scalar != reader.left() ||
      !image.steps_mm.allFinite() || !image.centre_mm.allFinite())
    return std::nullopt;
  image.voxels = voxelsFrom(reader.takeBytes(reader.left()), type, endian == kLittleEndian);
  if (axes == kLps) {
    image.steps_mm.topRows<2>() *= -1;
    image.centre_mm.head<2>() *= -1;
  }
  return image;
}

}  // namespace facenav::links
