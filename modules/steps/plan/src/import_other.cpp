#include "facenav/plan/import_other.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "facenav/casefile/landmarks_file.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/plain_words.h"
#include "facenav/core/utc_time.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/interop/formats.h"
#include "facenav/plan/plan_edits.h"
#include "facenav/plan/pose_target.h"
#include "facenav/volume/nifti.h"
#include "imported_session.h"
#include "same_image.h"

namespace facenav::steps {
namespace {

using interop::Item;
using interop::Kind;

/// Differences below them come from the digits of a file.
constexpr double kSame_mm = 0.05, kSame_deg = 0.05;
constexpr std::size_t kSkinPoints = 4000;  // of the skin, to judge poses by: some mm apart

std::string originOf(const OtherImport& order, const interop::OtherFile& file) {
  return nameOf(order) + " (" + file.words + ")";
}

bool isSamePose(const guidance::Target& target, const RigidTransform<Mri, Coil>& pose) {
  const auto error = poseError(target.mri_T_target.reframe<Mri, Coil>(), pose);
  return error.translation_mm < kSame_mm && error.rotation_rad * kDegPerRad < kSame_deg;
}

/// A name that no other item of the file has: the second "M1" becomes "M1 (2)". `names`: those in use, and
/// how often each was met.
void makeNameSingle(Item& item, std::map<std::string, int>& names) {
  const std::string name = item.name;
  while (names.count(item.name) > 0) item.name = name + formatted(" (%d)", ++names[name]);
  names[item.name] = 1;
  if (item.name != name) item.notes.push_back("the file has the name '" + name + "' twice");
}

void judgeTarget(PreviewedItem& previewed, const guidance::TreatmentPlan& plan, bool replaces) {
  const Item& item = previewed.item;
  const auto refuse = [&](const std::string& why) {
    previewed.fate = ItemFate::refused;
    previewed.reason = why;
  };
  if (!item.mri_T_coil) {
    previewed.fate = ItemFate::listed;
    previewed.reason = item.reason.empty() ? "no pose" : item.reason;
    return;
  }
  if (const std::string fault = faultOfWords(item.name, kLongestName); !fault.empty())
    return refuse("its name " + fault);
  const auto* old = find(plan, item.name);
  previewed.fate = old ? ItemFate::replaced : ItemFate::added;
  if (!old) return;
  if (isSamePose(*old, *item.mri_T_coil))
    previewed.fate = ItemFate::unchanged;
  else if (old->is_locked)
    refuse("the case has a target of this name, and it is locked");
  else if (!replaces)
    refuse("the case has a target of this name with another pose: give --replace, or rename it");
}

PreviewedItem judged(const Item& item, const guidance::TreatmentPlan& plan, bool replaces) {
  PreviewedItem previewed;
  previewed.item = item;
  if (!item.refusal.empty()) {
    previewed.fate = ItemFate::refused;
    previewed.reason = item.refusal;
  } else if (item.kind == Kind::target) {
    judgeTarget(previewed, plan, replaces);
  } else if (item.kind == Kind::pulse) {
    previewed.fate = ItemFate::added;
    if (!item.mri_T_coil) previewed.reason = item.reason;
  } else {
    previewed.reason =
        item.reason.empty() ? "a place only; facenav target makes a target there" : item.reason;
  }
  return previewed;
}

guidance::Target targetOf(const casefile::CaseStore& store, const surface::ScalpSurface& scalp,
                          const Item& item, const OtherImport& order, const interop::OtherFile& file) {
  guidance::Target target;
  target.name = item.name;
  target.mri_T_target = item.mri_T_coil->reframe<Mri, frames::Target>();
  target.cortex_point =
      item.cortex_point_mm ? Point<Mri>(*item.cortex_point_mm) : cortexOnAxis(store, *item.mri_T_coil);
  target.scalp_point =
      item.scalp_point_mm ? Point<Mri>(*item.scalp_point_mm) : skinOnAxis(scalp, *item.mri_T_coil);
  target.note = "from " + originOf(order, file);
  target.changes = {
      {isoUtc(std::chrono::system_clock::now()), order.by, "imported from " + originOf(order, file)}};
  return target;
}

guidance::TreatmentPlan planWith(const casefile::CaseStore& store, const OtherImport& order,
                                 const ImportPreview& preview, int& count) {
  auto plan = store.targets();
  std::optional<surface::ScalpSurface> scalp;
  for (const auto& [item, fate, reason] : preview.items) {
    if (item.kind != Kind::target || (fate != ItemFate::added && fate != ItemFate::replaced)) continue;
    if (!scalp) scalp = store.scalp();
    const auto target = targetOf(store, *scalp, item, order, preview.file);
    guidance::requireSound(target);
    plan = with(std::move(plan), item.name, target);
    ++count;
  }
  return plan;
}

/// The T1 that a data set names and holds. Some sets hold an empty file in its place.
std::optional<interop::T1> intendedT1(interop::OtherFile& file) {
  if (file.intended_t1.empty()) return std::nullopt;
  try {
    return interop::readT1(file.intended_t1);
  } catch (const Error& error) {
    file.notes.push_back("its T1 '" + file.image_words +
                         "' cannot be compared with the case's: " + error.what());
    return std::nullopt;
  }
}

void noteClock(const OtherImport& order, ImportPreview& preview) {
  const auto has_clock = [](const PreviewedItem& item) { return item.item.clock_s.has_value(); };
  if (preview.pulses() == 0 || preview.file.is_clock_utc) return;
  if (std::none_of(preview.items.begin(), preview.items.end(), has_clock)) return;
  preview.file.notes.push_back(
      formatted("the times of its pulses name no zone: taken as UTC%+g (--utc-offset)", order.utc_offset_h));
}

}  // namespace

std::string toString(ItemFate fate) {
  constexpr const char* kWords[] = {"added", "replaced", "unchanged", "listed", "refused"};
  return kWords[int(fate)];
}

int ImportPreview::count(ItemFate fate) const {
  return int(std::count_if(items.begin(), items.end(), [&](const auto& item) { return item.fate == fate; }));
}

int ImportPreview::pulses() const {
  return int(std::count_if(items.begin(), items.end(), [](const auto& item) {
    return item.item.kind == Kind::pulse && item.fate == ItemFate::added;
  }));
}

std::string ImportPreview::refusal() const {
  const int refused = count(ItemFate::refused);
  for (const auto& item : items) {
    if (item.fate != ItemFate::refused) continue;
    std::string line =
        toString(item.item.kind) + " '" + item.item.name + "' (" + item.item.where + "): " + item.reason;
    if (refused > 1) line += formatted("; and %d more", refused - 1);
    return line;
  }
  return {};
}

interop::CaseHead caseHead(const casefile::CaseStore& store) {
  if (!store.hasMri())
    throw Error("the case has no MRI, to which other programs' coordinates refer", store.folder().string());
  interop::CaseHead head;
  head.t1 = interop::readT1(store.folder() / "mri.nii.gz");
  const auto& vertices = store.scalp().mesh.vertices_mm;
  head.centre_mm = head.t1.grid.centre().mm;
  if (!vertices.empty()) {
    Eigen::Vector3d low = vertices.front(), high = low;
    for (const auto& v : vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
    head.centre_mm = (low + high) / 2;
  }
  if (const auto landmarks = casefile::readLandmarks(store.folder())) {
    const auto &left = (*landmarks)[surface::Landmark::tragus_left],
               &nasion = (*landmarks)[surface::Landmark::nasion],
               &right = (*landmarks)[surface::Landmark::tragus_right];
    if (left && nasion && right)
      head.points = interop::HeadPoints{left->point.mm, nasion->point.mm, right->point.mm};
  }
  const std::size_t step = std::max<std::size_t>(1, vertices.size() / kSkinPoints);
  for (std::size_t i = 0; i < vertices.size(); i += step) head.skin_mm.push_back(vertices[i]);
  for (const auto& finding : store.findings()) {  // the words of volume::readNifti
    if (finding.find("sform and qform ") == std::string::npos) continue;
    if (finding.find("the sform is used") != std::string::npos) head.used_of_two = interop::Form::sform;
    if (finding.find("the qform is used") != std::string::npos) head.used_of_two = interop::Form::qform;
  }
  return head;
}

namespace {

/// Judges the items of `preview.file`, which check() has seen, against the case's plan.
ImportPreview withFates(const casefile::CaseStore& store, const OtherImport& order, ImportPreview preview) {
  const auto plan = store.targets();
  std::map<std::string, int> names;
  for (auto& item : preview.file.items) {
    if (item.kind == Kind::target && item.mri_T_coil) makeNameSingle(item, names);
    preview.items.push_back(judged(item, plan, order.replaces));
  }
  preview.file.items.clear();
  noteClock(order, preview);
  return preview;
}

}  // namespace

ImportPreview previewItems(const casefile::CaseStore& store, const interop::CaseHead& head,
                           const OtherImport& order, interop::OtherFile items) {
  ImportPreview preview;
  preview.file = std::move(items);
  interop::check(preview.file, head, order.answers);
  return withFates(store, order, std::move(preview));
}

ImportPreview previewImport(const casefile::CaseStore& store, const OtherImport& order) {
  const auto head = caseHead(store);
  std::optional<interop::T1> file_t1;
  if (!order.t1.empty()) file_t1 = interop::readT1(order.t1);
  ImportPreview preview;
  preview.file = interop::readOther(order.file, file_t1 ? &*file_t1 : &head.t1);
  if (!file_t1) file_t1 = intendedT1(preview.file);
  if (file_t1) requireSameImage(store, *file_t1, head.t1);
  interop::check(preview.file, head, order.answers, file_t1);
  return withFates(store, order, std::move(preview));
}

ImportedItems importOther(const casefile::CaseStore& store, const OtherImport& order,
                          const ImportPreview& preview) {
  if (!order.skips_refused && preview.count(ItemFate::refused) > 0)
    throw Error(preview.refusal(), order.file.string(), "nothing was imported");
  ImportedItems imported;
  const auto before = store.targets();
  const auto plan = planWith(store, order, preview, imported.targets);
  auto sessions = newSessions(store, order, preview, plan);
  if (imported.targets > 0) store.setTargets(plan);
  try {
    for (auto& session : sessions) {
      session.whole->commit();
      imported.sessions.push_back(session.folder);
      imported.pulses += session.pulses;
    }
  } catch (...) {
    for (const auto& folder : imported.sessions) std::filesystem::remove_all(folder);
    if (imported.targets > 0) store.setTargets(before);
    throw;
  }
  return imported;
}

}  // namespace facenav::steps
