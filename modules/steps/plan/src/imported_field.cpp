#include "facenav/plan/imported_field.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "facenav/geometry/pose_error.h"
#include "imported_field_checks.h"
#include "imported_field_file.h"
#include "imported_samples.h"
#include "kept_shells.h"

namespace facenav::steps {
namespace {

constexpr double kKept_mm = 80;    // farther from the coil the field is small; its values are not kept
constexpr float kOffValue_mm = 6;  // of a place from the value that it takes: a sulcus' width
// A mesh with edges of 1.5 mm and elements of first order is at least 7 % off (Gomez 2020, Brain Stimul
// 13:157). How well the other program knew the tissues is not in it.
constexpr double kElements = 0.07;
constexpr double kFarPeak_mm = 30;

/// Value that a share of the weight does not exceed.
double percentileOf(const efield::FieldSamples& samples, double share) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(samples.magnitude.size()));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return samples.magnitude[a] < samples.magnitude[b]; });
  const double wanted = share * samples.weight.sum();
  double sum = 0;
  for (const Eigen::Index i : order)
    if ((sum += samples.weight[i]) >= wanted) return samples.magnitude[i];
  return samples.magnitude[order.back()];
}

/// The samples within reach of the coil.
efield::FieldSamples nearCoil(const efield::FieldSamples& all, const CoilPose& pose) {
  std::vector<Eigen::Index> near;
  for (Eigen::Index i = 0; i < all.points_mm.cols(); ++i)
    if ((all.points_mm.col(i) - pose.translation_mm()).norm() <= kKept_mm) near.push_back(i);
  efield::FieldSamples kept;
  const auto count = Eigen::Index(near.size());
  kept.points_mm.resize(3, count);
  kept.magnitude.resize(count);
  if (all.field.cols() > 0) kept.field.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index from = near[std::size_t(i)];
    kept.points_mm.col(i) = all.points_mm.col(from);
    kept.magnitude[i] = all.magnitude[from];
    if (all.field.cols() > 0) kept.field.col(i) = all.field.col(from);
  }
  return kept;
}

struct JudgedField {
  ImportedField field;
  efield::FieldSamples near;
};

void requireAtTarget(const efield::FieldSamples& near, const guidance::Target& target,
                     const std::filesystem::path& file) {
  double least_mm = 1e300;
  for (Eigen::Index i = 0; i < near.points_mm.cols(); ++i)
    least_mm = std::min(least_mm, (near.points_mm.col(i) - target.cortex_point.mm).norm());
  if (!(least_mm <= kOffValue_mm))
    throw Error("the field has no value at the target '" + target.name + "'", file.string(),
                "import a field that reaches this part of the brain");
}

/// The brain's samples of a file, and those whose maximum is stated.
std::pair<efield::FieldSamples, efield::FieldSamples> brainAndGrey(OtherField& other,
                                                                   const FieldSurfaces& surfaces,
                                                                   const std::filesystem::path& file) {
  if (!other.image) return {std::move(other.samples.brain), std::move(other.samples.grey)};
  if (!surfaces.brain_mask)
    throw Error("the case has no brain mask, so the brain's part of a volume is not known", file.string(),
                "import the field's mesh (.msh)");
  auto brain = samplesIn(*other.image, *surfaces.brain_mask);
  if (brain.magnitude.size() == 0)
    throw Error("the volume has no field in the brain of the case", file.string(),
                "import a field of this patient");
  return {brain, brain};
}

JudgedField judgedField(const casefile::CaseStore& store, const FieldImport& order) {
  const auto target = store.targets().find(order.target);
  if (!store.hasMri())
    throw Error("the case has no MRI, to which an imported field refers", store.folder().string());
  const auto surfaces = fieldSurfaces(store);
  auto other = readOtherField(order.file, order.surface);
  JudgedField judged;
  auto& field = judged.field;
  field.words = other.words;
  for (const auto& finding : checkedAgainst(store, surfaces, other, order)) field.words += "; " + finding;
  field.fills_brain = other.image || other.samples.fills_brain;
  const auto [brain, grey] = brainAndGrey(other, surfaces, order.file);
  field.has_directions = brain.field.cols() > 0;
  Eigen::Index strongest = 0;
  field.peak = grey.magnitude.maxCoeff(&strongest);
  if (!(field.peak > 0)) throw Error("the field is 0 everywhere", order.file.string(), "export it again");
  field.peak_place = Point<Mri>(Eigen::Vector3d(grey.points_mm.col(strongest)));
  field.percentile_99_9 = percentileOf(grey, 0.999);
  field.target = target.name;
  field.mri_T_target = target.mri_T_target;
  field.rate_A_per_us = order.rate_A_per_us.value_or(1);
  if (!order.rate_A_per_us)
    field.notes.push_back("the file does not say its rate: taken as 1 A/us, SimNIBS's default (--didt)");
  for (const auto& note : poseNotes(target, order.file)) field.notes.push_back(note);
  judged.near = nearCoil(brain, coilPoseOf(target));
  requireAtTarget(judged.near, target, order.file);
  const double off_mm = (field.peak_place.mm - target.cortex_point.mm).norm();
  if (off_mm > kFarPeak_mm)
    field.notes.push_back(
        formatted("its maximum lies %.0f mm from the target: was it computed for it?", off_mm));
  field.utc = isoUtc(std::chrono::system_clock::now());
  return judged;
}

/// The imported field at its pose, at a rate of 1 A/us.
class ImportedHead : public HeadField {
 public:
  ImportedHead(ImportedField facts, efield::FieldSamples samples)
      : facts_(std::move(facts)), samples_(std::move(samples)), places_(samples_.points_mm.cast<float>()) {}
  FieldTier tier() const override { return FieldTier::imported; }
  std::string inWords() const override { return "an imported field (" + facts_.words + ")"; }
  double usualError() const override { return kElements; }
  bool hasDirections() const override { return facts_.has_directions; }
  bool fillsBrain() const override { return facts_.fills_brain; }
  Eigen::Matrix3Xd at(const efield::CoilDipoles&, const CoilPose& mri_T_coil,
                      const Eigen::Matrix3Xd& points_mm) const override {
    if (!isSamePlace(mri_T_coil.reframe<Mri, frames::Target>(), facts_.mri_T_target))
      throw Error("the imported field is that of the pose of '" + facts_.target + "' alone", {},
                  "use another tier for other poses");
    Eigen::Matrix3Xd field = Eigen::Matrix3Xd::Zero(3, points_mm.cols());
    for (Eigen::Index i = 0; i < points_mm.cols(); ++i) {
      const Eigen::Vector3f p_mm = points_mm.col(i).cast<float>();
      const auto nearest = places_.nearestWithin(p_mm, kOffValue_mm);
      if (nearest < 0) continue;
      if (facts_.has_directions)
        field.col(i) = samples_.field.col(nearest) / facts_.rate_A_per_us;
      else  // any direction: hasDirections() is false
        field(0, i) = samples_.magnitude[nearest] / facts_.rate_A_per_us;
    }
    return field;
  }

 private:
  ImportedField facts_;
  efield::FieldSamples samples_;
  KeptPlaces places_;
};

}  // namespace

bool isFieldFile(const std::filesystem::path& file) {
  const auto kind = fieldFileOf(file);
  return kind != FieldFile::other && kind != FieldFile::vtp;
}

bool needsSurface(const std::filesystem::path& file) {
  return fieldFileOf(file) == FieldFile::surface_values;
}

ImportedField previewField(const casefile::CaseStore& store, const FieldImport& order) {
  return judgedField(store, order).field;
}

ImportedField importField(const casefile::CaseStore& store, const FieldImport& order) {
  auto judged = judgedField(store, order);
  keepImportedField(store, judged.field, judged.near);
  return judged.field;
}

std::unique_ptr<HeadField> importedHead(const casefile::CaseStore& store, const guidance::Target& target) {
  auto facts = importedField(store, target);
  if (!facts)
    throw Error("no field was imported for the pose that '" + target.name + "' has now",
                store.folder().string(), "import one ('facenav import CASE FIELD --target NAME')");
  auto samples = efield::readFieldMsh(store.folder() / facts->file);
  return std::make_unique<ImportedHead>(std::move(*facts), std::move(samples));
}

}  // namespace facenav::steps
