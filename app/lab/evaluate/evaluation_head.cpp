#include "evaluate/evaluation_head.h"

#include <algorithm>
#include <sstream>

#include "demo/virtual_patient_files.h"
#include "evaluate/painted_head.h"
#include "facenav/casefile/case_store.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"
#include "room_patient.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

constexpr const char* kColin27 = "/usr/share/mricron/templates/ch2.nii.gz";
constexpr double kCortexDepth_mm = 20.0, kPatientsHairGap_mm = 4.0;

struct Variant {
  const char* name;
  Eigen::Vector3d scale;  // along Mri's axes
  int landmark = -1;      // iBUG landmark at whose height the scan ends; -1: whole scan
  room::PatientOptions look = {};
};

room::PatientOptions withSkin(double contrast, double brightness) {
  room::PatientOptions options;
  options.skin_contrast = contrast;
  options.skin_brightness = brightness;
  return options;
}
room::PatientOptions bald() {
  room::PatientOptions options;
  options.has_hair = false;
  return options;
}

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all{{"child", {0.85, 0.85, 0.85}},
                                        {"big", {1.1, 1.1, 1.1}},
                                        {"wide", {1.08, 1.0, 0.95}},
                                        {"lip", {1, 1, 1}, 51},
                                        {"nose", {1, 1, 1}, 29},
                                        {"smooth", {1, 1, 1}, -1, withSkin(0.3, 1.0)},
                                        {"dark", {1, 1, 1}, -1, withSkin(1.0, 0.4)},
                                        {"bald", {1, 1, 1}, -1, bald()}};
  return all;
}

const Variant& variantOf(const std::string& word) {
  const auto found =
      std::find_if(variants().begin(), variants().end(), [&](const Variant& v) { return v.name == word; });
  if (found == variants().end()) throw Error("no variant of a head", word, "one of: " + headVariants());
  return *found;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

/// Returns the head in another size: voxels keep their values, the grid is scaled about its centre.
volume::Volume stretched(volume::Volume mri, const Eigen::Vector3d& scale) {
  const Eigen::Vector3d centre = mri.grid.centre().mm;
  Eigen::Affine3d about = Eigen::Affine3d::Identity();
  about.linear() = scale.asDiagonal();
  about.translation() = centre - scale.asDiagonal() * centre;
  mri.grid.mri_from_voxel = about * mri.grid.mri_from_voxel;
  return mri;
}

/// Returns the scan without everything below `z_mm`.
volume::Volume endingAt(const volume::Volume& mri, double z_mm) {
  const volume::Volume whole = volume::toRasOrder(mri);
  const int first = std::clamp(
      int(std::lround(
          whole.grid.toVoxel(Point<Mri>(whole.grid.centre().mm.x(), whole.grid.centre().mm.y(), z_mm)).z())),
      0, whole.grid.size[2] - 1);
  volume::Volume cut = whole;
  cut.grid.size[2] -= first;
  cut.grid.mri_from_voxel.translation() = whole.grid.toMri({0.0, 0.0, double(first)}).mm;
  cut.voxels.assign(whole.voxels.begin() + std::ptrdiff_t(whole.grid.index(0, 0, first)), whole.voxels.end());
  return cut;
}

surface::ScalpSurface scalpOf(Context& context, const volume::Volume& mri) {
  const auto segmenter =
      context.registrations.head_segmenters.create(context.registrations.head_segmenters.defaultName());
  return surface::extractScalp(mri, segmenter->segment(mri, context.monitor).mask, context.monitor);
}

guidance::Target leftHand(const room::VirtualPatient& patient) {
  guidance::Target target;
  target.name = "left hand area";
  target.mri_T_target = room::leftHandArea(patient, kPatientsHairGap_mm);
  target.scalp_point = target.mri_T_target * Point<frames::Target>(0.0, 0.0, kPatientsHairGap_mm);
  target.cortex_point =
      target.mri_T_target * Point<frames::Target>(0.0, 0.0, kPatientsHairGap_mm + kCortexDepth_mm);
  return target;
}

bool endsAboveTheChin(const volume::Volume& mri, const room::VirtualPatient& patient) {
  if (patient.landmarks68_mm.empty()) return true;
  const auto ras = volume::toRasOrder(mri);
  return ras.grid.toMri({0, 0, 0}).mm.z() > patient.landmarks68_mm[8].z();
}

volume::Volume volumeOf(const Context& context, const std::string& base) {
  if (base == "patient") return volume::readNifti(virtualPatientFiles(context).nifti).volume;
  return volume::readNifti(base == "colin27" ? fs::path(kColin27) : fs::path(base)).volume;
}

}  // namespace

std::string headVariants() {
  std::string names;
  for (const auto& variant : variants()) names += (names.empty() ? "" : ", ") + std::string(variant.name);
  return names;
}

void requireKnownHead(const std::string& spec) {
  const auto words = split(spec, ':');
  if (words.empty())
    throw Error("no head was named", spec, "say: patient, colin27, a NIfTI file or a case folder");
  for (auto word = words.begin() + 1; word != words.end(); ++word) variantOf(*word);
  const std::string& base = words.front();
  if (base != "patient" && base != "colin27" && !fs::exists(base))
    throw Error("there is no such head", base, "say: patient, colin27, a NIfTI file or a case folder");
}

EvaluationHead makeEvaluationHead(Context& context, const std::string& spec) {
  requireKnownHead(spec);
  const auto words = split(spec, ':');
  EvaluationHead head;
  head.name = spec;
  head.is_unseen = words.front() != "patient";
  std::optional<casefile::CaseStore> store;
  if (fs::exists(fs::path(words.front()) / "case.json")) store = casefile::CaseStore::open(words.front());
  const auto painted = paintedHead(words.front());
  volume::Volume mri = store ? store->mri() : painted ? painted->scan : volumeOf(context, words.front());
  volume::Volume person = painted ? painted->person : mri;
  int cut_at = -1;
  room::PatientOptions look;
  for (auto word = words.begin() + 1; word != words.end(); ++word) {
    const Variant& variant = variantOf(*word);
    mri = stretched(mri, variant.scale);
    person = stretched(person, variant.scale);
    head.is_unseen = head.is_unseen || !variant.scale.isOnes();
    if (variant.landmark >= 0) cut_at = variant.landmark;
    look.has_hair = look.has_hair && variant.look.has_hair;
    look.skin_contrast *= variant.look.skin_contrast;
    look.skin_brightness *= variant.look.skin_brightness;
  }
  const bool is_as_prepared = store && words.size() == 1;
  head.patient = std::make_shared<const room::VirtualPatient>(
      is_as_prepared ? roomPatient(context, *store, look) : room::makePatient(person, look, context.monitor));
  head.target = leftHand(*head.patient);
  if (cut_at >= 0) {
    if (head.patient->landmarks68_mm.empty())
      throw Error("no face was found in this head, so its scan cannot be ended there", spec,
                  "choose another head");
    mri = endingAt(mri, head.patient->landmarks68_mm[std::size_t(cut_at)].z());
  }
  head.is_scan_cut = cut_at >= 0 || endsAboveTheChin(mri, *head.patient);
  head.scalp = is_as_prepared ? store->scalp() : scalpOf(context, mri);
  if (is_as_prepared && !store->targets().targets.empty()) head.target = store->targets().targets.front();
  return head;
}

}  // namespace facenav::app
