#include "facenav/volume/nifti.h"

#include <nifti1_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <utility>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/volume/fast_compressor.h"
#include "nifti_world.h"

namespace facenav::volume {
namespace {

/// Reads the voxels without niftiio, which silently fills the missing part of a truncated file with zeros.
void readVoxels(nifti_image& image, const std::filesystem::path& path) {
  constexpr double kMostCompression = 1040;  // deflate's limit is 1032
  const auto refuse = [&] {
    throw Error("NIfTI file is truncated or damaged", path.string(), "copy or export it again");
  };
  const std::size_t size = image.nvox * std::size_t(image.nbyper);
  std::error_code error;
  const bool is_compressed = nifti_is_gzfile(image.iname);
  const auto file_size = double(std::filesystem::file_size(image.iname, error));
  if (error || size == 0 || file_size * (is_compressed ? kMostCompression : 1.0) < double(size)) refuse();
  image.data = std::malloc(size);  // freed by nifti_image_free
  if (!image.data) throw Error("not enough memory for this volume", path.string());
  znzFile file = znzopen(image.iname, "rb", is_compressed);
  if (znz_isnull(file)) refuse();
  const bool is_whole = image.iname_offset >= 0 && znzseek(file, image.iname_offset, SEEK_SET) >= 0 &&
                        znzread(image.data, 1, size, file) == size;
  Xznzclose(&file);
  if (!is_whole) refuse();
  if (image.swapsize > 1 && image.byteorder != nifti_short_order())
    nifti_swap_Nbytes(size / std::size_t(image.swapsize), image.swapsize, image.data);
}

/// True for the 540 bytes that a header of NIfTI-2 names first, in either byte order.
bool isNifti2(const std::filesystem::path& path) {
  unsigned char start[4] = {};
  if (znzFile file = znzopen(path.c_str(), "rb", nifti_is_gzfile(path.c_str())); !znz_isnull(file)) {
    if (znzread(start, 1, sizeof start, file) != sizeof start) start[0] = 0;
    Xznzclose(&file);
  }
  constexpr unsigned kHigh = 540 >> 8, kLow = 540 & 0xFF;
  return (start[0] == kLow && start[1] == kHigh && !start[2] && !start[3]) ||
         (!start[0] && !start[1] && start[2] == kHigh && start[3] == kLow);
}

/// `components`: values a voxel, 1 or 3.
ImagePtr readImage(const std::filesystem::path& path, int components) {
  if (!std::filesystem::exists(path)) throw Error("file does not exist", path.string(), "check the path");
  if (!std::filesystem::is_regular_file(path))  // a pipe would be waited for
    throw Error("is not a file", path.string(), "name a NIfTI file");
  nifti_set_debug_level(0);
  if (is_nifti_file(path.c_str()) < 0) {
    if (isNifti2(path))
      throw Error("is NIfTI-2, which is not read", path.string(), "save it as NIfTI-1 (.nii.gz)");
    throw Error("is not a NIfTI file", path.string(), "export it again as .nii.gz");
  }
  ImagePtr image = readHeader(path);
  if (!image || !image->iname)
    throw Error("NIfTI header is damaged", path.string(), "copy or export it again");
  const bool has_size = image->nx >= 1 && image->ny >= 1 && image->nz >= 1;
  if (!has_size || image->nvox != std::size_t(image->nx) * image->ny * image->nz * std::size_t(components)) {
    const std::string held = "holds " + std::to_string(image->ndim) + " dimensions, ";
    if (components == 1)
      throw Error(held + "one 3-D volume was expected", path.string(), "extract the T1 volume first");
    throw Error(held + "each voxel of vectors has 3 values", path.string(), "choose a file of vectors");
  }
  readVoxels(*image, path);
  return image;
}

template <class T>
void convert(const void* data, std::vector<float>& out, double slope, double intercept) {
  const T* values = static_cast<const T*>(data);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = float(slope * double(values[i]) + intercept);
}

std::vector<float> asInFile(const nifti_image& image, const std::string& where) {
  std::vector<float> out(image.nvox);
  const double slope = image.scl_slope != 0 && std::isfinite(image.scl_slope) ? image.scl_slope : 1.0;
  const double intercept = image.scl_slope != 0 && std::isfinite(image.scl_inter) ? image.scl_inter : 0.0;
  switch (image.datatype) {
    case DT_UINT8:
      convert<std::uint8_t>(image.data, out, slope, intercept);
      break;
    case DT_INT8:
      convert<std::int8_t>(image.data, out, slope, intercept);
      break;
    case DT_INT16:
      convert<std::int16_t>(image.data, out, slope, intercept);
      break;
    case DT_UINT16:
      convert<std::uint16_t>(image.data, out, slope, intercept);
      break;
    case DT_INT32:
      convert<std::int32_t>(image.data, out, slope, intercept);
      break;
    case DT_UINT32:
      convert<std::uint32_t>(image.data, out, slope, intercept);
      break;
    case DT_INT64:
      convert<std::int64_t>(image.data, out, slope, intercept);
      break;
    case DT_UINT64:
      convert<std::uint64_t>(image.data, out, slope, intercept);
      break;
    case DT_FLOAT32:
      convert<float>(image.data, out, slope, intercept);
      break;
    case DT_FLOAT64:
      convert<double>(image.data, out, slope, intercept);
      break;
    default:
      throw Error(std::string("voxel type ") + nifti_datatype_string(image.datatype) + " is not a scalar",
                  where, "export the T1 as a grey-value volume");
  }
  return out;
}

constexpr float kLargestValue = 1e15f;  // its square is a number, too

std::vector<float> toFloat(const nifti_image& image, const std::string& where) {
  std::vector<float> out = asInFile(image, where);
  for (float& value : out) {
    if (!std::isfinite(value)) value = 0.f;
    if (std::abs(value) > kLargestValue)
      throw Error("holds the value " + formatted("%.0e", double(value)) + ": no grey value of a scan", where,
                  "check the slope in its header (scl_slope), or export it again");
  }
  return out;
}

std::string statisticOf(int intent) {
  switch (intent) {
    case NIFTI_INTENT_CORREL:
      return "r";
    case NIFTI_INTENT_TTEST:
      return "t";
    case NIFTI_INTENT_FTEST:
      return "F";
    case NIFTI_INTENT_ZSCORE:
      return "z";
    case NIFTI_INTENT_CHISQ:
      return "chi2";
    case NIFTI_INTENT_PVAL:
      return "p";
    case NIFTI_INTENT_LOGPVAL:
      return "ln p";
    case NIFTI_INTENT_LOG10PVAL:
      return "log10 p";
    default:
      return {};
  }
}

ImagePtr makeImage(const VoxelGrid& grid, int datatype) {
  const int dims[8] = {3, grid.size[0], grid.size[1], grid.size[2], 1, 1, 1, 1};
  ImagePtr image(nifti_make_new_nim(dims, datatype, 1));
  if (!image) throw Error("not enough memory for a NIfTI volume");
  const Eigen::Vector3d spacing = grid.spacing_mm();
  image->dx = image->pixdim[1] = float(spacing[0]);
  image->dy = image->pixdim[2] = float(spacing[1]);
  image->dz = image->pixdim[3] = float(spacing[2]);
  image->xyz_units = NIFTI_UNITS_MM;
  mat44 world{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) world.m[r][c] = float(grid.mri_from_voxel(r, c));
  world.m[3][3] = 1;
  image->sform_code = image->qform_code = NIFTI_XFORM_SCANNER_ANAT;
  image->sto_xyz = world;
  image->sto_ijk = nifti_mat44_inverse(world);
  float dx, dy, dz;
  nifti_mat44_to_quatern(world, &image->quatern_b, &image->quatern_c, &image->quatern_d, &image->qoffset_x,
                         &image->qoffset_y, &image->qoffset_z, &dx, &dy, &dz, &image->qfac);
  image->qto_xyz =
      nifti_quatern_to_mat44(image->quatern_b, image->quatern_c, image->quatern_d, image->qoffset_x,
                             image->qoffset_y, image->qoffset_z, dx, dy, dz, image->qfac);
  image->qto_ijk = nifti_mat44_inverse(image->qto_xyz);
  return image;
}

/// Writes `image`, and releases its voxels as soon as they are copied.
void writeImage(nifti_image& image, const std::filesystem::path& path, FileAccess access) {
  const std::string name = path.filename().string();
  const bool is_gz = name.size() > 7 && name.substr(name.size() - 7) == ".nii.gz";
  if (!is_gz && path.extension() != ".nii") throw Error("name must end in .nii or .nii.gz", path.string());
  constexpr std::size_t kDataOffset = 352;  // header, and four bytes that mean: no extension
  image.nifti_type = NIFTI_FTYPE_NIFTI1_1;
  image.iname_offset = int(kDataOffset);
  const nifti_1_header header = nifti_convert_nim2nhdr(&image);
  std::vector<unsigned char> content(kDataOffset + image.nvox * std::size_t(image.nbyper));
  std::memcpy(content.data(), &header, sizeof header);
  std::memcpy(content.data() + kDataOffset, image.data, content.size() - kDataOffset);
  std::free(std::exchange(image.data, nullptr));
  if (is_gz) content = gzipped(content.data(), content.size());
  WholeFile file(path, access);
  std::ofstream stream(file.temporaryPath(), std::ios::binary);
  stream.write(reinterpret_cast<const char*>(content.data()), std::streamsize(content.size()));
  stream.close();
  if (!stream) throw Error("cannot be written", path.string(), "check free disk space and permissions");
  file.commit();
}

template <class T>
bool fits(const std::vector<float>& voxels) {
  return std::all_of(voxels.begin(), voxels.end(), [](float v) {
    return v >= float(std::numeric_limits<T>::min()) && v <= float(std::numeric_limits<T>::max()) &&
           v == std::floor(v);
  });
}

template <class T, class Source>
void fill(nifti_image& image, const std::vector<Source>& voxels) {
  std::transform(voxels.begin(), voxels.end(), static_cast<T*>(image.data), [](Source v) { return T(v); });
}

}  // namespace

const std::vector<std::string>& niftiEndings() {
  static const std::vector<std::string> kEndings{".nii", ".nii.gz", ".hdr", ".img"};
  return kEndings;
}

bool isNiftiName(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  const auto ends = [&](const std::string& end) {
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  return std::any_of(niftiEndings().begin(), niftiEndings().end(), ends);
}

NiftiTransform niftiTransformNamed(const std::string& name) {
  if (name == "automatic") return NiftiTransform::automatic;
  if (name == "sform") return NiftiTransform::sform;
  if (name == "qform") return NiftiTransform::qform;
  throw Error("no such NIfTI transform: " + name, {}, "one of automatic, sform, qform");
}

NiftiRead readNifti(const std::filesystem::path& path, NiftiTransform choice) {
  const ImagePtr image = readImage(path, 1);
  const WorldMap map = chooseMap(*image, choice, path.string());
  NiftiRead result;
  result.volume.grid = map.grid;
  result.volume.modality = "";
  result.volume.orientation_source = map.name;
  result.evidence = map.evidence;
  result.is_template_space = map.is_template_space;
  result.statistic = statisticOf(image->intent_code);
  result.warning = map.warning;
  result.volume.voxels = toFloat(*image, path.string());
  return result;
}

NiftiVectors readNiftiVectors(const std::filesystem::path& path) {
  const ImagePtr image = readImage(path, 3);
  NiftiVectors result;
  result.grid = chooseMap(*image, NiftiTransform::automatic, path.string()).grid;
  result.description.assign(image->descrip, strnlen(image->descrip, sizeof image->descrip));
  const std::vector<float> values = asInFile(*image, path.string());
  const std::size_t count = result.grid.count();
  result.vectors.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    result.vectors[i] = {values[i], values[i + count], values[i + 2 * count]};
  return result;
}

Mask readMask(const std::filesystem::path& path) { return maskOf(readNifti(path).volume); }

Mask maskOf(const Volume& volume) {
  Mask mask{volume.grid, {}};
  mask.voxels.resize(volume.voxels.size());
  std::transform(volume.voxels.begin(), volume.voxels.end(), mask.voxels.begin(),
                 [](float v) { return std::uint8_t(v > 0.5f); });
  return mask;
}

void writeNifti(const Volume& volume, const std::filesystem::path& path, FileAccess access) {
  FACENAV_EXPECT(volume.voxels.size() == volume.grid.count(), "volume and grid differ in size");
  if (fits<std::int16_t>(volume.voxels)) {
    const ImagePtr image = makeImage(volume.grid, DT_INT16);
    fill<std::int16_t>(*image, volume.voxels);
    writeImage(*image, path, access);
  } else if (fits<std::uint16_t>(volume.voxels)) {
    const ImagePtr image = makeImage(volume.grid, DT_UINT16);
    fill<std::uint16_t>(*image, volume.voxels);
    writeImage(*image, path, access);
  } else {
    const ImagePtr image = makeImage(volume.grid, DT_FLOAT32);
    fill<float>(*image, volume.voxels);
    writeImage(*image, path, access);
  }
}

void writeMask(const Mask& mask, const std::filesystem::path& path, FileAccess access) {
  FACENAV_EXPECT(mask.voxels.size() == mask.grid.count(), "mask and grid differ in size");
  const ImagePtr image = makeImage(mask.grid, DT_UINT8);
  fill<std::uint8_t>(*image, mask.voxels);
  writeImage(*image, path, access);
}

}  // namespace facenav::volume
