#include "facenav/surface/surface_values.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "gifti_reader.h"

namespace facenav::surface {
namespace {

constexpr char kCurvMagic[] = "\xff\xff\xff";
constexpr std::size_t kCurvHeader_bytes = 15;  // magic; vertices, faces and values a vertex as int32
constexpr std::size_t kGiftiStart_bytes = 4096;

bool isCurv(const std::string& content) {
  return content.size() >= kCurvHeader_bytes && content.compare(0, 3, kCurvMagic) == 0;
}

bool isGifti(const std::string& content) {
  return content.substr(0, kGiftiStart_bytes).find("<GIFTI") != std::string::npos;
}

std::int32_t bigEndian(const std::string& content, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint8_t(content[at + i]);
  return std::int32_t(value);
}

std::vector<float> curvValues(const std::string& content, const std::string& path) {
  const std::int32_t vertices = bigEndian(content, 3);
  if (bigEndian(content, 11) != 1)
    throw Error("the file holds more than one value a vertex", path, "export the magnitude alone");
  if (vertices < 0 || content.size() < kCurvHeader_bytes + 4 * std::size_t(vertices))
    throw Error("the file ends too early", path, "export it again");
  std::vector<float> values(static_cast<std::size_t>(vertices));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::int32_t bits = bigEndian(content, kCurvHeader_bytes + 4 * i);
    std::memcpy(&values[i], &bits, sizeof bits);
  }
  return values;
}

/// The array of an intent; null: none.
const GiftiArray* arrayOf(const std::vector<GiftiArray>& arrays, const std::string& intent) {
  for (const auto& array : arrays)
    if (array.intent == intent) return &array;
  return nullptr;
}

std::vector<float> giftiValues(const std::filesystem::path& path) {
  const auto arrays = readGifti(path);
  if (arrays.size() > 1)
    throw Error("the file holds more than one value a vertex", path.string(), "export one of them");
  if (arrays.empty() || arrays.front().columns != 1)
    throw Error("the GIFTI file holds no value a vertex", path.string(), "export the field's magnitude");
  const auto& values = arrays.front().values;
  return {values.begin(), values.end()};
}

/// Normals as means of the faces' ones.
void addNormals(TriangleMesh& mesh) {
  mesh.normals.assign(mesh.vertices_mm.size(), Eigen::Vector3d::Zero());
  for (const auto& t : mesh.triangles) {
    const auto& p = mesh.vertices_mm;
    const Eigen::Vector3d across =
        (p[std::size_t(t[1])] - p[std::size_t(t[0])]).cross(p[std::size_t(t[2])] - p[std::size_t(t[0])]);
    for (int c = 0; c < 3; ++c) mesh.normals[std::size_t(t[c])] += across;
  }
  for (auto& normal : mesh.normals) normal.normalize();
}

}  // namespace

bool holdsSurfaceValues(const std::string& content) {
  if (isCurv(content)) return true;
  return isGifti(content) && content.find("NIFTI_INTENT_POINTSET") == std::string::npos;
}

std::vector<float> readSurfaceValues(const std::filesystem::path& path) {
  const std::string content = readWholeFile(path);
  if (!isCurv(content) && !isGifti(content))
    throw Error("is no file with a value a vertex", path.string(), "give a FreeSurfer curv or a GIFTI file");
  const auto values = isCurv(content) ? curvValues(content, path.string()) : giftiValues(path);
  for (const float value : values)
    if (!std::isfinite(value))
      throw Error("holds a value that is no number", path.string(), "export it again");
  return values;
}

TriangleMesh readGiftiSurface(const std::filesystem::path& path) {
  if (!isGifti(readWholeFile(path)))
    throw Error("is no GIFTI surface", path.string(), "give the .gii file of the surface");
  const auto arrays = readGifti(path);
  const auto *points = arrayOf(arrays, "NIFTI_INTENT_POINTSET"),
             *faces = arrayOf(arrays, "NIFTI_INTENT_TRIANGLE");
  if (!points || !faces || points->columns != 3 || faces->columns != 3)
    throw Error("the GIFTI file holds no surface", path.string(), "give the file with the coordinates");
  for (const std::string& space : points->dataspaces)
    if (space.find("MNI") != std::string::npos || space.find("TALAIRACH") != std::string::npos)
      throw Error("the surface lies in the space of a template", path.string(),
                  "give the surface in the subject's space");
  TriangleMesh mesh;
  for (std::size_t i = 0; i < points->rows; ++i)
    mesh.vertices_mm.emplace_back(points->at(i, 0), points->at(i, 1), points->at(i, 2));
  for (std::size_t i = 0; i < faces->rows; ++i) {
    const Eigen::Vector3i t(int(faces->at(i, 0)), int(faces->at(i, 1)), int(faces->at(i, 2)));
    if (t.minCoeff() < 0 || t.maxCoeff() >= int(mesh.vertices_mm.size()))
      throw Error("the surface has a triangle of a vertex that is not there", path.string(),
                  "export it again");
    mesh.triangles.push_back(t);
  }
  for (const auto& p : mesh.vertices_mm)
    if (!p.allFinite()) throw Error("holds a coordinate that is no number", path.string(), "export it again");
  addNormals(mesh);
  return mesh;
}

}  // namespace facenav::surface
