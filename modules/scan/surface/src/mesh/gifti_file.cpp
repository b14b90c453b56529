#include "gifti_file.h"

extern "C" {
#include <gifti/gifti_io.h>
}

#include <cstdlib>
#include <memory>

namespace facenav::surface {
namespace {

using Image = std::unique_ptr<gifti_image, decltype(&gifti_free_image)>;

/// One array of rows x 3. gifti_io allocates it; the caller fills it through `data`.
giiDataArray* addArray(gifti_image& image, int index, int intent, int datatype, std::size_t rows) {
  giiDataArray* array = image.darray[index];
  array->intent = intent;
  array->datatype = datatype;
  array->num_dim = 2;
  array->dims[0] = static_cast<long long>(rows);
  array->dims[1] = 3;
  array->ind_ord = GIFTI_IND_ORD_ROW_MAJOR;
  array->encoding = GIFTI_ENCODING_B64GZ;
  array->endian = gifti_get_this_endian();
  array->nvals = static_cast<long long>(rows * 3);
  gifti_datatype_sizes(datatype, &array->nbyper, nullptr);
  array->data = std::calloc(rows * 3, std::size_t(array->nbyper));
  return array;
}

void stateScannerRas(giiDataArray& pointset) {
  gifti_add_empty_CS(&pointset);
  giiCoordSystem& system = *pointset.coordsys[0];
  system.dataspace = gifti_strdup("NIFTI_XFORM_SCANNER_ANAT");
  system.xformspace = gifti_strdup("NIFTI_XFORM_SCANNER_ANAT");
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) system.xform[r][c] = r == c;
}

}  // namespace

bool writeGifti(const TriangleMesh& mesh, const std::filesystem::path& path) {
  const Image image(gifti_create_image(2, NIFTI_INTENT_NONE, NIFTI_TYPE_FLOAT32, 0, nullptr, 0),
                    gifti_free_image);
  if (!image) return false;
  auto* points = addArray(*image, 0, NIFTI_INTENT_POINTSET, NIFTI_TYPE_FLOAT32, mesh.vertices_mm.size());
  auto* triangles = addArray(*image, 1, NIFTI_INTENT_TRIANGLE, NIFTI_TYPE_INT32, mesh.triangles.size());
  if (!points->data || !triangles->data) return false;
  stateScannerRas(*points);
  auto* xyz = static_cast<float*>(points->data);
  for (const auto& v : mesh.vertices_mm)
    for (int c = 0; c < 3; ++c) *xyz++ = float(v[c]);
  auto* corners = static_cast<int*>(triangles->data);
  for (const auto& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) *corners++ = t[c];
  return gifti_write_image(image.get(), path.c_str(), 1) == 0;
}

}  // namespace facenav::surface
