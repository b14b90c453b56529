#include <cmath>
#include <cstdint>
#include <cstring>

#include "facenav/core/json_reader.h"
#include "facenav/core/zip_file.h"
#include "tract_formats.h"

namespace facenav::surface {
namespace {

using Entries = std::map<std::string, std::string>;

float fromHalf(std::uint16_t half) {
  const int exponent = (half >> 10) & 31, fraction = half & 1023;
  const float size = exponent == 0    ? std::ldexp(float(fraction), -24)
                     : exponent == 31 ? (fraction ? NAN : INFINITY)
                                      : std::ldexp(float(fraction + 1024), exponent - 25);
  return half & 0x8000 ? -size : size;
}

template <class T>
std::vector<T> arrayOf(const std::string& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

/// Reads the points; `scale`: bytes a number.
template <class T, class Convert>
std::vector<Eigen::Vector3f> pointsOf(const std::string& bytes, Convert toFloat) {
  const auto numbers = arrayOf<T>(bytes);
  std::vector<Eigen::Vector3f> points;
  points.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    points.emplace_back(toFloat(numbers[i]), toFloat(numbers[i + 1]), toFloat(numbers[i + 2]));
  return points;
}

std::vector<Eigen::Vector3f> positionsOf(const Entries& entries, const std::filesystem::path& path) {
  const auto has = [&](const char* name) { return entries.count(name) > 0; };
  if (has("positions.3.float32"))
    return pointsOf<float>(entries.at("positions.3.float32"), [](float v) { return v; });
  if (has("positions.3.float16")) return pointsOf<std::uint16_t>(entries.at("positions.3.float16"), fromHalf);
  if (has("positions.3.float64"))
    return pointsOf<double>(entries.at("positions.3.float64"), [](double v) { return float(v); });
  refuseTracts(path, "it holds no positions");
}

std::vector<std::uint64_t> offsetsOf(const Entries& entries, const std::filesystem::path& path) {
  if (const auto wide = entries.find("offsets.uint64"); wide != entries.end())
    return arrayOf<std::uint64_t>(wide->second);
  const auto narrow = entries.find("offsets.uint32");
  if (narrow == entries.end()) refuseTracts(path, "it holds no offsets");
  const auto offsets = arrayOf<std::uint32_t>(narrow->second);
  return {offsets.begin(), offsets.end()};
}

}  // namespace

/// Reads a .trx file. Positions are RAS mm. An offset is the index where a line begins; a last one, if
/// present, is the number of points.
TractLines readTrx(const std::filesystem::path& path) {
  const Entries entries = readZip(path);
  if (!entries.count("header.json")) refuseTracts(path, "it holds no header.json");
  const JsonReader header = JsonReader::readText(entries.at("header.json"), path);
  TractLines tracts;
  tracts.points_mm = positionsOf(entries, path);
  auto offsets = offsetsOf(entries, path);
  const double lines = header.at("NB_STREAMLINES").number(), points = header.at("NB_VERTICES").number();
  if (double(tracts.points_mm.size()) != points) refuseTracts(path, "it holds fewer points than it states");
  if (double(offsets.size()) == lines) offsets.push_back(tracts.points_mm.size());
  if (double(offsets.size()) != lines + 1 || offsets.front() != 0 ||
      offsets.back() != tracts.points_mm.size())
    refuseTracts(path, "its lines do not fit its points");
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    if (offsets[i] < offsets[i - 1]) refuseTracts(path, "its lines do not fit its points");
    tracts.ends.push_back(offsets[i]);
  }
  return tracts;
}

}  // namespace facenav::surface
