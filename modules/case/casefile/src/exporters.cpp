#include "facenav/casefile/exporter.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/whole_folder.h"
#include "facenav/surface/cortex_surface.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

void makeFolder(const fs::path& folder) {
  if (fs::is_directory(folder)) return;
  if (fs::exists(folder))
    throw Error("is not a folder", folder.string(), "choose another place to export to");
  makePrivateFolder(folder);
}

/// Path of the new file. Throws Error if it exists and `replace` is false.
fs::path placeFor(const fs::path& folder, const std::string& name, bool replace) {
  const fs::path path = folder / name;
  if (fs::exists(path) && !replace)
    throw Error("exists already", path.string(), "choose another folder, or --replace");
  return path;
}

class MeshExporter : public Exporter {
 public:
  explicit MeshExporter(surface::MeshFormat format) : format_(format) {}

  std::vector<fs::path> write(const CaseStore& store, const fs::path& folder, bool replace,
                              TaskMonitor& monitor) const override {
    const auto brain = store.brain();
    const auto brain_mask = store.brainMask();
    const std::string ending = surface::extensionOf(format_);
    makeFolder(folder);
    std::vector<fs::path> places{placeFor(folder, "scalp" + ending, replace)};
    if (brain) places.push_back(placeFor(folder, "brain" + ending, replace));
    if (brain_mask) places.push_back(placeFor(folder, "cortex" + ending, replace));

    auto place = places.begin();
    writeOne(store.scalp().mesh, *place++);
    if (brain) writeOne(brain->mesh, *place++);
    if (brain_mask) writeOne(surface::extractCortex(*brain_mask, {}, monitor), *place++);
    return places;
  }

 private:
  void writeOne(const surface::TriangleMesh& mesh, const fs::path& path) const {
    surface::writeMesh(mesh, format_, path, FileAccess::owner_only);
  }

  surface::MeshFormat format_;
};

class NiftiExporter : public Exporter {
 public:
  std::vector<fs::path> write(const CaseStore& store, const fs::path& folder, bool replace,
                              TaskMonitor& monitor) const override {
    makeFolder(folder);
    std::vector<fs::path> places;
    for (const char* name : {"mri.nii.gz", "head_mask.nii.gz", "brain_mask.nii.gz"})
      if (fs::exists(store.folder() / name)) places.push_back(placeFor(folder, name, replace));
    for (const auto& place : places) {
      monitor.report("exporting " + place.filename().string(), 0.0);
      writeWholeFile(place, readWholeFile(store.folder() / place.filename()), FileAccess::owner_only);
    }
    return places;
  }
};

}  // namespace

std::unique_ptr<Exporter> makeMeshExporter(surface::MeshFormat format) {
  return std::make_unique<MeshExporter>(format);
}

std::unique_ptr<Exporter> makeNiftiExporter() { return std::make_unique<NiftiExporter>(); }

}  // namespace facenav::casefile
