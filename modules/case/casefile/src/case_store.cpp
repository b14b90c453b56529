#include "facenav/casefile/case_store.h"

#include <array>
#include <cmath>
#include <future>

#include "case_json.h"
#include "case_path.h"
#include "facenav/casefile/case_place.h"
#include "facenav/casefile/edited_brain.h"
#include "facenav/casefile/file_group.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/navigation_check_file.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/whole_folder.h"
#include "facenav/volume/nifti.h"
#include "utc_now.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

constexpr char kScalpField[] = "scalp_field.bin", kMri[] = "mri.nii.gz";

bool has(const CaseJson& content, const std::string& file) {
  for (const std::string& name : content.files)
    if (name == file) return true;
  return false;
}

void requireMri(const CaseStore& store) {
  if (!store.hasMri())
    throw Error("this case holds no MRI, only the face as cameras measured it", store.folder().string(),
                "use it with 'facenav-gui --home' or 'facenav track'");
}

std::vector<std::string> writeContent(const PreparedCase& prepared, const fs::path& folder) {
  std::vector<std::string> files{"mri.nii.gz", "head_mask.nii.gz", "scalp.vtp"};
  auto large = std::async(std::launch::async, [&] {  // compression takes longest: run it in parallel
    volume::writeNifti(prepared.mri, folder / "mri.nii.gz");
    if (prepared.cortex) surface::writeCortex(*prepared.cortex, folder / "cortex.vtp");
  });
  volume::writeMask(prepared.head_mask, folder / "head_mask.nii.gz");
  surface::writeScalp(prepared.scalp, folder / "scalp.vtp");
  if (prepared.scalp_field) prepared.scalp_field->write(folder / kScalpField);
  if (prepared.brain_mask) {
    volume::writeMask(*prepared.brain_mask, folder / "brain_mask.nii.gz");
    files.push_back("brain_mask.nii.gz");
  }
  if (prepared.brain) {
    surface::writeBrain(*prepared.brain, folder / "brain.vtp", folder / "brain_texture.png");
    files.insert(files.end(), {"brain.vtp", "brain_texture.png"});
  }
  if (prepared.atlas) {
    atlas::writeAtlasMap(*prepared.atlas, folder / "atlas.vti");
    files.push_back("atlas.vti");
  }
  if (prepared.navigation_check) {
    writeNavigationCheck(*prepared.navigation_check, folder / "navigation_check.json");
    files.push_back("navigation_check.json");
  }
  large.get();
  return files;
}

/// Moves a voxel position that rounding put just outside the grid back onto its edge.
Eigen::Vector3d within(const volume::VoxelGrid& grid, const Eigen::Vector3d& ijk) {
  constexpr double kHair = 0.02;
  const Eigen::Vector3d last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const Eigen::Vector3d nearest = ijk.cwiseMax(0).cwiseMin(last);
  return (nearest - ijk).norm() < kHair ? nearest : ijk;
}

/// True for equal values at equal places; the order of the axes does not matter. A mirrored or shifted head
/// is another scan.
bool isSameScan(const volume::Volume& old, const volume::Volume& fresh) {
  constexpr int kPointsAnAxis = 24;
  constexpr double kSame = 0.995;  // correlation of the values; rounding and compression leave 0.9999
  double n = 0, sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (int p = 0; p < kPointsAnAxis * kPointsAnAxis * kPointsAnAxis; ++p) {
    const std::array<int, 3> step{p % kPointsAnAxis, p / kPointsAnAxis % kPointsAnAxis,
                                  p / (kPointsAnAxis * kPointsAnAxis)};
    Eigen::Vector3d ijk;
    for (int a = 0; a < 3; ++a) ijk[a] = std::floor((step[a] + 0.5) * fresh.grid.size[a] / kPointsAnAxis);
    const double a = volume::sampleLinear(fresh, ijk);
    const double b = volume::sampleLinear(old, within(old.grid, old.grid.toVoxel(fresh.grid.toMri(ijk))));
    n += 1, sum_a += a, sum_b += b, sum_aa += a * a, sum_bb += b * b, sum_ab += a * b;
  }
  const double spread = std::sqrt((n * sum_aa - sum_a * sum_a) * (n * sum_bb - sum_b * sum_b));
  if (!(spread > 0)) return old.grid.matches(fresh.grid);
  return (n * sum_ab - sum_a * sum_b) / spread > kSame;
}

/// Hard-links the files: recordings are large, and the swap stays atomic. Copies them if the disk has no hard
/// links.
void keepFolder(const fs::path& old_folder, const fs::path& fresh) {
  if (!fs::is_directory(old_folder)) return;
  std::error_code fault;
  fs::copy(old_folder, fresh, fs::copy_options::recursive | fs::copy_options::create_hard_links, fault);
  if (!fault) return;
  fs::remove_all(fresh);
  fs::copy(old_folder, fresh, fs::copy_options::recursive);
}

/// Copies targets, protocol, coil, landmarks and overlays (of the same scan), sessions and threshold
/// searches.
void keepFromOld(const fs::path& old_case, const fs::path& fresh, const volume::Volume& mri) {
  for (const char* file : {"targets.json", "protocol.json", "coil.json"})
    if (fs::exists(old_case / file)) fs::copy_file(old_case / file, fresh / file);
  const bool has_places = fs::exists(old_case / kMri) &&
                          (fs::exists(old_case / "landmarks.json") || fs::exists(old_case / "overlays.json"));
  if (has_places && isSameScan(volume::readNifti(old_case / kMri).volume, mri)) {
    for (const char* name : {"landmarks.json", "overlays.json", "overlays"})
      if (fs::exists(old_case / name)) fs::copy(old_case / name, fresh / name, fs::copy_options::recursive);
  }
  for (const char* name : {"sessions", "thresholds"}) keepFolder(old_case / name, fresh / name);
}

bool hasTargets(const fs::path& folder) {
  const fs::path file = folder / "targets.json";
  if (!fs::exists(file)) return false;
  const auto plan = guidance::readTargets(file);
  return !plan.targets.empty() || !plan.damaged.empty();
}

}  // namespace

std::string asLabel(const std::string& words) {
  std::string label;
  for (const char c : words) {
    const bool is_blank = static_cast<unsigned char>(c) <= 0x20 || c == 0x7F;
    if (!is_blank)
      label += c;
    else if (!label.empty() && label.back() != ' ')
      label += ' ';
  }
  if (!label.empty() && label.back() == ' ') label.pop_back();
  if (label.size() > std::size_t(kLongestLabel))
    throw Error("the label is longer than " + std::to_string(kLongestLabel) + " bytes", {},
                "choose a shorter one");
  return label;
}

void requireTargetsStay(const fs::path& folder, const volume::Volume& mri) {
  if (!isCase(folder)) return;
  const bool has_targets = hasTargets(folder), has_sessions = !sessionFolders(folder).empty();
  if (!has_targets && !has_sessions) return;
  FACENAV_EXPECT(mri.voxels.size() == mri.grid.count(), "volume and grid differ in size");
  const bool has_mri = fs::exists(folder / kMri);
  if (has_mri && isSameScan(volume::readNifti(folder / kMri).volume, mri)) return;
  throw Error(std::string(has_mri ? "this scan does not lie where the case's scan lies: "
                                  : "the case has no MRI that this scan could be compared with: ") +
                  (has_targets ? "its targets" : "the poses of its sessions") + " would point elsewhere",
              folder.string(),
              has_sessions ? "make a new case" : "make a new case, or remove the targets first");
}

CaseStore CaseStore::openToReplace(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw Error("no such case folder", folder.string(), "prepare the case first");
  if (!isCase(folder))
    throw Error("is no case (no case.json in it)", folder.string(), "prepare the case first");
  requireNotNewer(folder / "case.json");
  removeAbandonedGroups(folder);
  return CaseStore(cleaned(folder));
}

CaseStore CaseStore::open(const fs::path& folder) {
  CaseStore store = openToReplace(folder);
  for (const std::string& file : readCaseJson(folder / "case.json").files)
    if (!fs::is_regular_file(folder / file))
      throw Error("the case is incomplete, a file is missing", (folder / file).string(),
                  "prepare the case again");
  return store;
}

CaseStore CaseStore::create(const fs::path& folder, const PreparedCase& prepared,
                            const std::vector<Provenance>& provenance, bool replace, bool discard_edits) {
  const fs::path place = cleaned(folder);
  try {
    requireReplaceable(place, replace);
    if (!discard_edits) requireNoEditsIn(place);
    requireTargetsStay(place, prepared.mri);
    WholeFolder fresh(place, FileAccess::owner_only, Existing::replace);
    CaseJson content;
    const auto old = isCase(place) ? std::optional(readCaseJson(place / "case.json")) : std::nullopt;
    content.case_id = old ? old->case_id : makeCaseId();
    content.label = prepared.label.empty() && old ? old->label : asLabel(prepared.label);
    content.created_utc = utcNow();
    content.modality = prepared.mri.modality;
    content.orientation_source = prepared.mri.orientation_source;
    content.files = writeContent(prepared, fresh.temporaryPath());
    content.findings = prepared.findings;
    content.brain_quality = prepared.brain_quality;
    content.provenance = provenance;
    writeCaseJson(content, fresh.temporaryPath() / "case.json");
    if (isCase(place)) keepFromOld(place, fresh.temporaryPath(), prepared.mri);
    fresh.commit();
  } catch (const fs::filesystem_error& fault) {
    throw Error("cannot be written (" + fault.code().message() + ")", place.string(),
                "check disk space and permissions");
  }
  return CaseStore(place);
}

CaseStore CaseStore::createFromFace(const fs::path& folder, const FaceCase& face,
                                    const std::vector<Provenance>& provenance, bool replace) {
  const fs::path place = cleaned(folder);
  try {
    requireReplaceable(place, replace);
    const auto old = isCase(place) ? std::optional(readCaseJson(place / "case.json")) : std::nullopt;
    if (old && has(*old, kMri))
      throw Error("this case has an MRI: a face does not replace it", place.string(),
                  "choose another folder");
    WholeFolder fresh(place, FileAccess::owner_only, Existing::replace);
    CaseJson content;
    content.case_id = old ? old->case_id : !face.case_id.empty() ? face.case_id : makeCaseId();
    content.label = face.label.empty() && old ? old->label : asLabel(face.label);
    content.created_utc = utcNow();
    content.files = {"scalp.vtp"};
    content.findings = face.findings;
    content.provenance = provenance;
    surface::writeScalp(face.face, fresh.temporaryPath() / "scalp.vtp");
    writeCaseJson(content, fresh.temporaryPath() / "case.json");
    fresh.commit();
  } catch (const fs::filesystem_error& fault) {
    throw Error("cannot be written (" + fault.code().message() + ")", place.string(),
                "check disk space and permissions");
  }
  return CaseStore(place);
}

bool CaseStore::hasMri() const { return has(readCaseJson(folder_ / "case.json"), kMri); }

std::string CaseStore::caseId() const { return readCaseJson(folder_ / "case.json").case_id; }
std::string CaseStore::label() const { return readCaseJson(folder_ / "case.json").label; }
std::string CaseStore::createdUtc() const { return readCaseJson(folder_ / "case.json").created_utc; }
std::vector<std::string> CaseStore::findings() const { return readCaseJson(folder_ / "case.json").findings; }
std::optional<BrainQuality> CaseStore::brainQuality() const {
  return readCaseJson(folder_ / "case.json").brain_quality;
}
std::vector<Provenance> CaseStore::provenance() const {
  return readCaseJson(folder_ / "case.json").provenance;
}

void CaseStore::setLabel(const std::string& words) const {
  CaseJson content = readCaseJson(folder_ / "case.json");
  content.label = asLabel(words);
  writeCaseJson(content, folder_ / "case.json");
}

void CaseStore::addProvenance(const Provenance& step) const {
  CaseJson content = readCaseJson(folder_ / "case.json");
  content.provenance.push_back(step);
  writeCaseJson(content, folder_ / "case.json");
}

volume::Volume CaseStore::mri() const {
  requireMri(*this);
  volume::Volume mri = volume::readNifti(folder_ / kMri).volume;
  const CaseJson content = readCaseJson(folder_ / "case.json");
  if (!content.modality.empty()) mri.modality = content.modality;
  if (!content.orientation_source.empty()) mri.orientation_source = content.orientation_source;
  return mri;
}

volume::Mask CaseStore::headMask() const {
  requireMri(*this);
  return volume::readMask(folder_ / "head_mask.nii.gz");
}

std::optional<volume::Mask> CaseStore::brainMask() const {
  if (!has(readCaseJson(folder_ / "case.json"), "brain_mask.nii.gz")) return std::nullopt;
  return volume::readMask(folder_ / "brain_mask.nii.gz");
}

surface::ScalpSurface CaseStore::scalp() const { return surface::readScalp(folder_ / "scalp.vtp"); }

fs::path CaseStore::scalpField() const { return folder_ / kScalpField; }

std::optional<surface::BrainModel> CaseStore::brain() const {
  if (!has(readCaseJson(folder_ / "case.json"), "brain.vtp")) return std::nullopt;
  return surface::readBrain(folder_ / "brain.vtp", folder_ / "brain_texture.png");
}

std::optional<surface::DetailedCortex> CaseStore::cortex() const {
  if (!fs::exists(folder_ / "cortex.vtp")) return std::nullopt;
  return surface::readCortex(folder_ / "cortex.vtp");
}

std::optional<atlas::AtlasMap> CaseStore::atlas() const {
  if (!has(readCaseJson(folder_ / "case.json"), "atlas.vti")) return std::nullopt;
  return atlas::readAtlasMap(folder_ / "atlas.vti");
}

guidance::TreatmentPlan CaseStore::targets() const {
  if (!fs::exists(folder_ / "targets.json")) return {};
  auto plan = guidance::readTargets(folder_ / "targets.json");
  for (const auto& fault : plan.damaged) logWarningOnce(fault);
  return plan;
}

void CaseStore::setTargets(const guidance::TreatmentPlan& plan) const {
  guidance::writeTargets(plan, folder_ / "targets.json", FileAccess::owner_only);
}

std::optional<StoredAlignment> CaseStore::alignment() const {
  if (!fs::exists(folder_ / "alignment.json")) return std::nullopt;
  return readAlignment(folder_ / "alignment.json");
}

}  // namespace facenav::casefile
