#include "facenav/prepare/case_source.h"

#include <algorithm>
#include <array>

#include "facenav/casefile/sha256.h"
#include "facenav/core/error.h"
#include "facenav/volume/regrid.h"

namespace facenav::steps {
namespace {

constexpr const char* kRemedy =
    "give the folder of the DICOM files that the case was prepared from with --source";

/// Hash of the Series Instance UID as the last preparation kept it; empty in older cases, and if the case was
/// made of a NIfTI.
std::string seriesHashOf(const casefile::CaseStore& store) {
  std::string hash;
  for (const auto& step : store.provenance())
    if (step.step == "prepare") {
      const auto kept = step.input_sha256.find(kSeriesUidHash);
      hash = kept == step.input_sha256.end() ? "" : kept->second;
    }
  return hash;
}

std::array<int, 3> sorted(std::array<int, 3> size) {
  std::sort(size.begin(), size.end());
  return size;
}

/// True for the same voxels at the same places, whatever the order and direction of the axes: a NIfTI that
/// another program made of the series may have its rows turned round.
bool isSameImage(const volume::Volume& a, const volume::Volume& b) {
  if (a.grid.matches(b.grid)) return a.voxels == b.voxels;
  const auto x = volume::toRasOrder(a), y = volume::toRasOrder(b);
  return x.grid.matches(y.grid) && x.voxels == y.voxels;
}

}  // namespace

CaseSource sourceOf(const casefile::CaseStore& store, const std::filesystem::path& folder,
                    TaskMonitor& monitor) {
  if (!store.hasMri())
    throw Error("the case has no MRI, so that no series belongs to it", store.folder().string());
  const std::string hash = seriesHashOf(store);
  const auto mri = store.mri();
  bool is_uid_there = false;
  for (const auto& info : dicom::listSeries(folder, monitor)) {
    if (!hash.empty() && casefile::sha256OfText(info.series_uid) != hash) continue;
    is_uid_there = true;
    if (!info.is_loadable || sorted({info.columns, info.rows, info.slices}) != sorted(mri.grid.size))
      continue;
    auto volume = dicom::loadSeries(info, monitor);
    if (isSameImage(volume, mri)) return {info, std::move(volume)};
  }
  if (!is_uid_there)
    throw Error("holds no series with the Series Instance UID of the case's MRI", folder.string(), kRemedy);
  throw Error("holds no series with the voxels of the case's MRI", folder.string(), kRemedy);
}

}  // namespace facenav::steps
