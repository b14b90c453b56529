#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>

#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "tract_formats.h"

namespace facenav::surface {
namespace {

/// Reads the text before the data, by key; throws if it has no end.
std::map<std::string, std::string> readTckHeader(const std::string& bytes,
                                                 const std::filesystem::path& path) {
  constexpr std::size_t kLongest = 1 << 20;
  const auto end = bytes.compare(0, 13, "mrtrix tracks") == 0 ? bytes.substr(0, kLongest).find("\nEND")
                                                              : std::string::npos;
  if (end == std::string::npos) refuseTracts(path, "it is no .tck file");
  std::istringstream lines(bytes.substr(0, end));
  std::map<std::string, std::string> header;
  for (std::string line; std::getline(lines, line);) {
    const auto colon = line.find(": ");
    if (colon != std::string::npos) header[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return header;
}

template <class T>
T swapped(T value) {
  unsigned char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  for (std::size_t i = 0; i < sizeof value / 2; ++i) std::swap(bytes[i], bytes[sizeof value - 1 - i]);
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Reads triplets; three NaN end a line, three infinities the file.
template <class T>
TractLines readTriplets(const std::string& bytes, std::size_t at, bool is_swapped,
                        const std::filesystem::path& path) {
  TractLines tracts;
  tracts.points_mm.reserve((bytes.size() - at) / (3 * sizeof(T)));
  for (; bytes.size() - at >= 3 * sizeof(T); at += 3 * sizeof(T)) {
    T p[3];
    std::memcpy(p, bytes.data() + at, sizeof p);
    if (is_swapped)
      for (T& value : p) value = swapped(value);
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) {
      tracts.points_mm.emplace_back(float(p[0]), float(p[1]), float(p[2]));
      continue;
    }
    const std::size_t begun = tracts.ends.empty() ? 0 : tracts.ends.back();
    if (std::isinf(p[0])) {
      if (tracts.points_mm.size() > begun) tracts.ends.push_back(tracts.points_mm.size());
      return tracts;
    }
    if (tracts.points_mm.size() > begun) tracts.ends.push_back(tracts.points_mm.size());
  }
  refuseTracts(path, "it is cut short");
}

}  // namespace

TractLines readTck(const std::filesystem::path& path) {
  const std::string bytes = readWholeFile(path);
  const auto header = readTckHeader(bytes, path);
  const auto file = header.find("file"), type = header.find("datatype");
  std::size_t offset = 0;
  if (file == header.end() || file->second.compare(0, 2, ". ") != 0 ||
      (offset = std::strtoul(file->second.c_str() + 2, nullptr, 10)) == 0 || offset > bytes.size())
    refuseTracts(path, "its header does not say where its data begin");
  const std::string kind = type == header.end() ? "" : type->second;
  if (kind == "Float32LE") return readTriplets<float>(bytes, offset, false, path);
  if (kind == "Float32BE") return readTriplets<float>(bytes, offset, true, path);
  if (kind == "Float64LE") return readTriplets<double>(bytes, offset, false, path);
  if (kind == "Float64BE") return readTriplets<double>(bytes, offset, true, path);
  refuseTracts(path, "its data type '" + kind + "' is not known");
}

void writeTck(const TractLines& tracts, const std::filesystem::path& path, FileAccess access) {
  constexpr std::size_t kHeader = 128;
  std::string bytes = "mrtrix tracks\ndatatype: Float32LE\ncount: " + std::to_string(tracts.lines()) +
                      "\nfile: . " + std::to_string(kHeader) + "\nEND\n";
  bytes.resize(kHeader, '\0');
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  const float line_end[3] = {nan, nan, nan}, file_end[3] = {infinity, infinity, infinity};
  for (std::size_t line = 0; line < tracts.lines(); ++line) {
    const std::size_t begin = tracts.begin(line), count = tracts.ends[line] - begin;
    bytes.append(reinterpret_cast<const char*>(tracts.points_mm.data() + begin),
                 count * sizeof(Eigen::Vector3f));
    bytes.append(reinterpret_cast<const char*>(line_end), sizeof line_end);
  }
  bytes.append(reinterpret_cast<const char*>(file_end), sizeof file_end);
  writeWholeFile(path, bytes, access);
}

}  // namespace facenav::surface
