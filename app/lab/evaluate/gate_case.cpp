#include "evaluate/gate_case.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

/// A scan whose voxels nobody reads: alignment and tracking use the skin alone.
volume::Volume emptyScan() {
  volume::Volume scan;
  scan.grid.size = {8, 8, 8};
  scan.grid.mri_from_voxel = Eigen::Affine3d(Eigen::Translation3d(-112, -112, -112)) * Eigen::Scaling(32.0);
  scan.voxels.assign(512, 0.f);
  scan.orientation_source = "sform";
  return scan;
}

}  // namespace

casefile::CaseStore makeGateCase(const WorldScan& scan, const fs::path& folder) {
  casefile::PreparedCase prepared;
  prepared.mri = emptyScan();
  prepared.head_mask = {prepared.mri.grid, std::vector<std::uint8_t>(512, 1)};
  prepared.scalp = scan.scalp;
  auto store = casefile::CaseStore::create(folder, prepared, {}, true);
  guidance::Target there;
  there.name = kGateTarget;
  there.cortex_point = there.scalp_point = scan.target;
  there.mri_T_target = {Eigen::Quaterniond::Identity(), scan.target.mm};
  store.setTargets({{there}});
  return store;
}

fs::path gateRecordingIn(const fs::path& folder) { return folder / "recording"; }

steps::TrackRequest gateRequest(const Context& context, const fs::path& recording) {
  steps::TrackRequest request;
  request.recording = recording;
  request.aligner = context.registrations.aligners.defaultName();
  request.head_tracker = context.registrations.head_trackers.defaultName();
  request.coil_tracker = context.registrations.coil_trackers.defaultName();
  return request;
}

std::string gateWords(const Error& refusal, const fs::path& folder) {
  std::string words = refusal.what();
  const std::string prefix = folder.string() + "/";
  for (std::size_t at; (at = words.find(prefix)) != std::string::npos;) words.erase(at, prefix.size());
  return words;
}

}  // namespace facenav::app
