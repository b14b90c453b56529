#include "facenav/plan/overlays.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/surface/mesh_files.h"
#include "facenav/surface/mesh_reader.h"
#include "facenav/volume/for_slices.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

using casefile::OverlayEntry;
using casefile::OverlayKind;
using casefile::OverlaySpace;
using Eigen::Vector3d;

/// Content of a file, in its own space.
struct OverlayContent {
  OverlayKind kind = OverlayKind::map;
  volume::Volume volume;
  surface::TractLines tracts;
  surface::TriangleMesh mesh;
  std::string unit;
  bool is_template_space = false;
};

/// True for a volume whose values are 0 and one other.
bool isMask(const volume::Volume& volume) {
  float other = 0;
  for (const float v : volume.voxels) {
    if (v == 0 || v == other) continue;
    if (other != 0) return false;
    other = v;
  }
  return other > 0;
}

OverlayContent readNiftiOverlay(const fs::path& file) {
  OverlayContent content;
  auto read = volume::readNifti(file);
  content.is_template_space = read.is_template_space;
  content.unit = read.statistic;
  content.volume = std::move(read.volume);
  if (std::all_of(content.volume.voxels.begin(), content.volume.voxels.end(), [](float v) { return v == 0; }))
    throw Error("the map is 0 everywhere", file.string(), "choose another file");
  if (!isMask(content.volume)) return content;
  content.kind = OverlayKind::mask;
  for (float& v : content.volume.voxels) v = v != 0;
  return content;
}

OverlayContent readOverlayFile(const fs::path& file) {
  if (fs::is_directory(file))
    throw Error("is a folder, a file was expected", file.string(), "name the file in it");
  if (!fs::is_regular_file(file)) throw Error("file does not exist", file.string(), "check the path");
  if (volume::isNiftiName(file)) return readNiftiOverlay(file);
  OverlayContent content;
  if (surface::isTractName(file) || (surface::isMeshName(file) && surface::holdsLines(file))) {
    content.kind = OverlayKind::tracts;
    content.tracts = surface::readTracts(file);
  } else if (surface::isMeshName(file)) {
    content.kind = OverlayKind::mesh;
    content.mesh = surface::readMesh(file);
  } else {
    throw Error("this kind of file is not known", file.string(),
                "give NIfTI, .trk .tck .trx, .ply .stl .obj .vtk or .vtp");
  }
  return content;
}

/// Some thousand points of the visible content, in the file's own space.
std::vector<Vector3d> placesOf(const OverlayContent& content) {
  constexpr std::size_t kEnough = 4000;
  std::vector<Vector3d> all;
  const auto each = [&](std::size_t count, auto place) {
    const std::size_t step = std::max<std::size_t>(1, count / kEnough);
    for (std::size_t i = 0; i < count; i += step) all.push_back(place(i));
  };
  if (content.kind == OverlayKind::tracts)
    each(content.tracts.points_mm.size(),
         [&](std::size_t i) { return Vector3d(content.tracts.points_mm[i].cast<double>()); });
  if (content.kind == OverlayKind::mesh)
    each(content.mesh.vertices_mm.size(), [&](std::size_t i) { return content.mesh.vertices_mm[i]; });
  if (!content.volume.voxels.empty()) {
    const auto& grid = content.volume.grid;
    std::vector<std::size_t> set;
    for (std::size_t i = 0; i < content.volume.voxels.size(); ++i)
      if (content.volume.voxels[i] != 0) set.push_back(i);
    each(set.size(), [&](std::size_t n) {
      const std::size_t i = set[n], w = std::size_t(grid.size[0]), h = std::size_t(grid.size[1]);
      return Vector3d(grid.mri_from_voxel * Vector3d(double(i % w), double(i / w % h), double(i / (w * h))));
    });
  }
  return all;
}

atlas::AtlasMap atlasFor(const casefile::CaseStore& store) {
  if (auto map = store.atlas()) return *map;
  throw Error("the case has no atlas registration, which MNI space needs", store.folder().string(),
              "prepare it again with --replace (its targets are kept)");
}

/// Throws Error unless at least half of the content lies inside the MRI.
void requireAtHead(const casefile::CaseStore& store, const OverlayContent& content, OverlaySpace space,
                   const fs::path& file) {
  const volume::VoxelGrid grid = store.headMask().grid;
  std::optional<atlas::AtlasMap> map;
  if (space == OverlaySpace::mni) map = atlasFor(store);
  const auto places = placesOf(content);
  std::size_t within = 0;
  for (const Vector3d& p : places) {
    const Point<Mri> at = map ? map->toMri(Point<Mni>(p)) : Point<Mri>(p);
    const Vector3d ijk = grid.toVoxel(at);
    within +=
        ijk.minCoeff() >= -0.5 && ijk.x() < grid.size[0] && ijk.y() < grid.size[1] && ijk.z() < grid.size[2];
  }
  if (2 * within < places.size())
    throw Error("most of it lies beside the head (" + std::to_string(100 * within / places.size()) +
                    " % within the MRI)",
                file.string(), "is it of another person, in another space (--space), or LPS?");
}

void chooseColours(OverlayEntry& entry, const NewOverlay& wanted, const volume::Volume& map) {
  std::vector<float> sizes;
  for (const float v : map.voxels)
    if (v != 0) sizes.push_back(std::abs(v));
  const auto at = sizes.begin() + std::ptrdiff_t(0.95 * double(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  const auto threeDigits = [](double value) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 2);
    return std::round(value / step) * step;
  };
  entry.threshold = wanted.threshold.value_or(threeDigits(*at));
  const double largest = *std::max_element(sizes.begin(), sizes.end());
  entry.full =
      wanted.full.value_or(largest > entry.threshold ? threeDigits(largest) : 2 * entry.threshold + 1);
  if (entry.full <= entry.threshold && !wanted.full)
    entry.full = entry.threshold + 0.01 * std::max(1.0, largest);
}

std::string freeOverlayName(const std::vector<OverlayEntry>& entries, OverlayKind kind) {
  for (int n = 1;; ++n) {
    const std::string name = toString(kind) + " " + std::to_string(n);
    if (std::none_of(entries.begin(), entries.end(), [&](const auto& e) { return e.name == name; }))
      return name;
  }
}

/// Returns the first number that no file of the folder has.
std::string freeOverlayFile(const fs::path& case_folder, OverlayKind kind) {
  const char* ending = kind == OverlayKind::tracts ? ".tck" : kind == OverlayKind::mesh ? ".ply" : ".nii.gz";
  for (int n = 1;; ++n) {
    const std::string name = "overlays/" + std::to_string(n) + ending;
    if (!fs::exists(case_folder / name)) return name;
  }
}

void writeContent(const OverlayContent& content, const fs::path& file) {
  std::error_code fault;
  fs::create_directory(file.parent_path(), fault);
  if (fault) throw Error("the folder cannot be made (" + fault.message() + ")", file.parent_path().string());
  fs::permissions(file.parent_path(), fs::perms::owner_all, fault);
  switch (content.kind) {
    case OverlayKind::tracts:
      return surface::writeTck(content.tracts, file, FileAccess::owner_only);
    case OverlayKind::mesh:
      return surface::writeMesh(content.mesh, surface::MeshFormat::ply, file, FileAccess::owner_only);
    default:
      return volume::writeNifti(content.volume, file, FileAccess::owner_only);
  }
}

std::vector<OverlayEntry>::iterator findEntry(std::vector<OverlayEntry>& entries, const std::string& name,
                                              const fs::path& case_folder) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.name == name; });
  if (found == entries.end())
    throw Error("the case has no overlay '" + name + "'", case_folder.string(),
                "--list-overlays shows its names");
  return found;
}

/// Resamples a volume of MNI space to this head.
volume::Volume inHead(const volume::Volume& mni, const atlas::AtlasMap& atlas, const volume::VoxelGrid& mri) {
  constexpr double kSpacing_mm = 1.5;  // finer than maps of 2 mm, so that their peaks remain
  volume::Volume native;
  native.grid = volume::isotropicGrid(mri, kSpacing_mm);
  native.voxels.assign(native.grid.count(), 0.f);
  const Eigen::Affine3d voxel_from_mni = mni.grid.mri_from_voxel.inverse();
  volume::forSlices(native.grid.size[2], [&](int k) {
    for (int j = 0; j < native.grid.size[1]; ++j)
      for (int i = 0; i < native.grid.size[0]; ++i) {
        const auto p = atlas.toMni(native.grid.toMri(Vector3d(i, j, k)));
        native.voxels[native.grid.index(i, j, k)] = volume::sampleLinear(mni, voxel_from_mni * p.mm);
      }
  });
  return native;
}

}  // namespace

OverlayEntry addOverlay(const casefile::CaseStore& store, const NewOverlay& wanted) {
  const OverlayContent content = readOverlayFile(wanted.file);
  if (!wanted.space && content.is_template_space)
    throw Error("the file says that it lies in a template's space", wanted.file.string(),
                "give --space mni, or --space native if it was made for this head");
  auto entries = casefile::readOverlays(store.folder());
  OverlayEntry entry;
  entry.kind = content.kind;
  entry.space = wanted.space.value_or(OverlaySpace::native);
  entry.opacity = wanted.opacity;
  entry.unit = content.unit;
  entry.name = wanted.name.empty() ? freeOverlayName(entries, content.kind) : wanted.name;
  if (entry.kind == OverlayKind::map) chooseColours(entry, wanted, content.volume);
  casefile::requireSensible(entry);
  requireAtHead(store, content, entry.space, wanted.file);
  entry.file = freeOverlayFile(store.folder(), content.kind);
  writeContent(content, store.folder() / entry.file);
  entries.push_back(entry);
  try {
    casefile::writeOverlays(entries, store.folder());
  } catch (...) {
    std::error_code ignored;
    fs::remove(store.folder() / entry.file, ignored);
    throw;
  }
  return entry;
}

void removeOverlay(const casefile::CaseStore& store, const std::string& name) {
  auto entries = casefile::readOverlays(store.folder());
  const auto found = findEntry(entries, name, store.folder());
  const fs::path file = store.folder() / found->file;
  entries.erase(found);
  casefile::writeOverlays(entries, store.folder());
  std::error_code ignored;
  fs::remove(file, ignored);
}

void changeOverlay(const casefile::CaseStore& store, const OverlayEntry& entry) {
  auto entries = casefile::readOverlays(store.folder());
  auto& known = *findEntry(entries, entry.name, store.folder());
  known.opacity = entry.opacity;
  known.threshold = entry.threshold;
  known.full = entry.full;
  known.unit = entry.unit;
  known.is_shown = entry.is_shown;
  casefile::writeOverlays(entries, store.folder());
}

scene::Overlay loadOverlay(const casefile::CaseStore& store, const OverlayEntry& entry,
                           const volume::VoxelGrid& mri) {
  OverlayContent content = readOverlayFile(store.folder() / entry.file);
  std::optional<atlas::AtlasMap> atlas;
  if (entry.space == OverlaySpace::mni) atlas = atlasFor(store);
  const auto toMri = [&](const Vector3d& p) { return atlas ? atlas->toMri(Point<Mni>(p)).mm : p; };
  scene::Overlay overlay;
  overlay.name = entry.name;
  overlay.opacity = entry.opacity;
  overlay.threshold = entry.threshold;
  overlay.full = entry.full;
  if (entry.kind == OverlayKind::tracts) {
    for (auto& p : content.tracts.points_mm) p = toMri(p.cast<double>()).cast<float>();
    overlay.tracts = std::make_shared<const scene::BoxedTracts>(scene::boxed(std::move(content.tracts)));
  } else if (entry.kind == OverlayKind::mesh) {
    for (auto& p : content.mesh.vertices_mm) p = toMri(p);
    overlay.mesh = std::make_shared<const surface::TriangleMesh>(std::move(content.mesh));
  } else {
    if (atlas) content.volume = inHead(content.volume, *atlas, mri);
    auto volume = std::make_shared<const volume::Volume>(std::move(content.volume));
    (entry.kind == OverlayKind::mask ? overlay.mask : overlay.map) = volume;
  }
  return overlay;
}

std::vector<scene::Overlay> loadOverlays(const casefile::CaseStore& store, const volume::VoxelGrid& mri) {
  std::vector<scene::Overlay> overlays;
  for (const OverlayEntry& entry : casefile::readOverlays(store.folder()))
    if (entry.is_shown) overlays.push_back(loadOverlay(store, entry, mri));
  return overlays;
}

}  // namespace facenav::steps
