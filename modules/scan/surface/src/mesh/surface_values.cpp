#include "facenav/surface/surface_values.h"

extern "C" {
#include <gifti/gifti_io.h>
}

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::surface {
namespace {

using GiftiImage = std::unique_ptr<gifti_image, decltype(&gifti_free_image)>;

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

GiftiImage readGifti(const std::filesystem::path& path) {
  gifti_set_verb(0);  // faults become an Error here
  GiftiImage image(gifti_read_image(path.c_str(), 1), gifti_free_image);
  if (!image) throw Error("is no readable GIFTI file", path.string(), "export it again");
  return image;
}

/// The array of an intent; null: none.
const giiDataArray* arrayOf(const gifti_image& image, int intent) {
  for (int i = 0; i < image.numDA; ++i)
    if (image.darray[i] && image.darray[i]->intent == intent && image.darray[i]->data) return image.darray[i];
  return nullptr;
}

double numberAt(const giiDataArray& array, long long i, const std::string& path) {
  switch (array.datatype) {
    case NIFTI_TYPE_FLOAT32:
      return static_cast<const float*>(array.data)[i];
    case NIFTI_TYPE_FLOAT64:
      return static_cast<const double*>(array.data)[i];
    case NIFTI_TYPE_INT32:
      return static_cast<const std::int32_t*>(array.data)[i];
    case NIFTI_TYPE_UINT8:
      return static_cast<const std::uint8_t*>(array.data)[i];
    default:
      throw Error("the GIFTI file holds numbers of an unknown type", path, "export it as float32");
  }
}

/// Value of a row and column, whatever the order of the file.
double numberAt(const giiDataArray& array, long long row, long long column, const std::string& path) {
  const bool is_by_columns = array.ind_ord == GIFTI_IND_ORD_COL_MAJOR;
  return numberAt(array, is_by_columns ? column * array.dims[0] + row : row * array.dims[1] + column, path);
}

std::vector<float> giftiValues(const std::filesystem::path& path) {
  const auto image = readGifti(path);
  const giiDataArray* found = nullptr;
  for (int i = 0; i < image->numDA; ++i) {
    const giiDataArray* array = image->darray[i];
    if (!array || !array->data) continue;
    if (found)
      throw Error("the file holds more than one value a vertex", path.string(), "export one of them");
    found = array;
  }
  if (!found || found->nvals != found->dims[0])
    throw Error("the GIFTI file holds no value a vertex", path.string(), "export the field's magnitude");
  std::vector<float> values;
  for (long long i = 0; i < found->nvals; ++i) values.push_back(float(numberAt(*found, i, path.string())));
  return values;
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
  const auto image = readGifti(path);
  const auto *points = arrayOf(*image, NIFTI_INTENT_POINTSET),
             *faces = arrayOf(*image, NIFTI_INTENT_TRIANGLE);
  if (!points || !faces || points->nvals != 3 * points->dims[0] || faces->nvals != 3 * faces->dims[0])
    throw Error("the GIFTI file holds no surface", path.string(), "give the file with the coordinates");
  for (int i = 0; i < points->numCS; ++i)
    if (const char* space = points->coordsys[i]->dataspace;
        space && (std::strstr(space, "MNI") || std::strstr(space, "TALAIRACH")))
      throw Error("the surface lies in the space of a template", path.string(),
                  "give the surface in the subject's space");
  TriangleMesh mesh;
  for (long long i = 0; i < points->dims[0]; ++i)
    mesh.vertices_mm.emplace_back(numberAt(*points, i, 0, path.string()),
                                  numberAt(*points, i, 1, path.string()),
                                  numberAt(*points, i, 2, path.string()));
  for (long long i = 0; i < faces->dims[0]; ++i) {
    Eigen::Vector3i t;
    for (int c = 0; c < 3; ++c) t[c] = int(numberAt(*faces, i, c, path.string()));
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
