#include "facenav/plan/import_other.h"

#include <algorithm>
#include <map>

#include "facenav/casefile/landmarks_file.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/plain_words.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/interop/formats.h"
#include "facenav/plan/plan_edits.h"
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

/// What an item is compared with.
struct Known {
  guidance::TreatmentPlan plan;             // of the case, with the targets of earlier files
  std::set<std::string> of_earlier_files;   // names of those
  std::set<std::string> imported_sessions;  // of this file, which the case has already
};

/// Judges a target that has a pose by the targets of its name.
void judgeName(PreviewedItem& previewed, const Known& known, bool replaces) {
  const auto* old = find(known.plan, previewed.item.name);
  previewed.fate = old ? ItemFate::replaced : ItemFate::added;
  if (!old) return;
  const std::string holder = known.of_earlier_files.count(old->name) ? "a file before it" : "the case";
  if (isSamePose(*old, *previewed.item.mri_T_coil)) {
    previewed.fate = ItemFate::unchanged;
  } else if (old->is_locked || !replaces) {
    previewed.fate = ItemFate::refused;
    previewed.reason =
        holder + (old->is_locked
                      ? " has a target of this name, and it is locked"
                      : " has a target of this name with another pose: give --replace, or rename it");
  }
}

void judgeTarget(PreviewedItem& previewed, const Known& known, const OtherImport& order) {
  const Item& item = previewed.item;
  if (!item.mri_T_coil) {
    previewed.fate = ItemFate::listed;
    previewed.reason = item.reason.empty() ? "no pose" : item.reason;
    return;
  }
  if (const std::string fault = faultOfWords(item.name, kLongestName); !fault.empty()) {
    previewed.fate = ItemFate::refused;
    previewed.reason = "its name " + fault;
    return;
  }
  previewed.fate = ItemFate::left_out;
  if (!order.left_out_targets.count(item.name)) judgeName(previewed, known, order.replaces);
}

void judgePulse(PreviewedItem& previewed, const Known& known, const OtherImport& order) {
  const Item& item = previewed.item;
  previewed.fate = order.left_out_sessions.count(item.session) ? ItemFate::left_out : ItemFate::added;
  if (!item.mri_T_coil) previewed.reason = item.reason;
  if (!known.imported_sessions.count(item.session)) return;
  previewed.fate = ItemFate::unchanged;
  previewed.reason = "its session was imported before";
}

PreviewedItem judged(const Item& item, const Known& known, const OtherImport& order) {
  PreviewedItem previewed;
  previewed.item = item;
  if (!item.refusal.empty()) {
    previewed.fate = ItemFate::refused;
    previewed.reason = item.refusal;
  } else if (item.kind == Kind::target) {
    judgeTarget(previewed, known, order);
  } else if (item.kind == Kind::pulse) {
    judgePulse(previewed, known, order);
  } else {
    previewed.reason =
        item.reason.empty() ? "a place only; facenav target makes a target there" : item.reason;
  }
  return previewed;
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

/// Judges the items of `preview.file`, which check() has seen, against the case's plan.
ImportPreview withFates(const casefile::CaseStore& store, const OtherImport& order, ImportPreview preview,
                        Known known) {
  known.imported_sessions = importedSessions(store, order, preview);
  std::map<std::string, int> names;
  for (auto& item : preview.file.items) {
    if (item.kind == Kind::target && item.mri_T_coil) makeNameSingle(item, names);
    preview.items.push_back(judged(item, known, order));
  }
  preview.file.items.clear();
  noteClock(order, preview);
  return preview;
}

ImportPreview previewOf(const casefile::CaseStore& store, const interop::CaseHead& head,
                        const OtherImport& order, Known known) {
  std::optional<interop::T1> file_t1;
  if (!order.t1.empty()) file_t1 = interop::readT1(order.t1);
  ImportPreview preview;
  preview.file = interop::readOther(order.file, file_t1 ? &*file_t1 : &head.t1);
  if (!file_t1) file_t1 = intendedT1(preview.file);
  if (file_t1) requireSameImage(store, *file_t1, head.t1);
  interop::check(preview.file, head, order.answers, file_t1);
  return withFates(store, order, std::move(preview), std::move(known));
}

}  // namespace

std::string toString(ItemFate fate) {
  constexpr const char* kWords[] = {"added", "replaced", "unchanged", "listed", "refused", "left out"};
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

std::vector<RefusedItems> ImportPreview::refusals() const {
  std::vector<RefusedItems> all;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].fate != ItemFate::refused) continue;
    const auto [place, is_new] = places.emplace(items[i].reason, all.size());
    if (is_new) all.push_back({items[i].reason, {}});
    all[place->second].items.push_back(i);
  }
  return all;
}

std::string ImportPreview::refusal() const {
  const auto refused = refusals();
  if (refused.empty()) return {};
  const auto& first = items[refused.front().items.front()].item;
  const int alike = int(refused.front().items.size());
  std::string line = alike > 1 ? formatted("%d items, the first ", alike) : std::string();
  line += toString(first.kind) + " '" + first.name + "' (" + first.where + "): " + refused.front().reason;
  if (const int others = count(ItemFate::refused) - alike) line += formatted("; and %d more", others);
  return line;
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

ImportPreview previewItems(const casefile::CaseStore& store, const interop::CaseHead& head,
                           const OtherImport& order, interop::OtherFile items) {
  ImportPreview preview;
  preview.file = std::move(items);
  interop::check(preview.file, head, order.answers);
  return withFates(store, order, std::move(preview), {store.targets(), {}, {}});
}

ImportPreview previewImport(const casefile::CaseStore& store, const OtherImport& order) {
  return previewOf(store, caseHead(store), order, {store.targets(), {}, {}});
}

std::vector<PreviewedFile> previewImports(const casefile::CaseStore& store, const interop::CaseHead& head,
                                          const std::vector<OtherImport>& orders) {
  Known known{store.targets(), {}, {}};
  std::vector<PreviewedFile> files;
  for (const auto& order : orders) {
    PreviewedFile& file = files.emplace_back(PreviewedFile{order, {}, {}});
    try {
      file.preview = previewOf(store, head, order, known);
    } catch (const Error& error) {
      file.failure = error.what();
    }
    for (const auto& [item, fate, reason] : file.preview.items) {
      if (item.kind != Kind::target || (fate != ItemFate::added && fate != ItemFate::replaced)) continue;
      guidance::Target target;
      target.name = item.name;
      target.mri_T_target = item.mri_T_coil->reframe<Mri, frames::Target>();
      known.plan = with(std::move(known.plan), item.name, target);
      known.of_earlier_files.insert(item.name);
    }
  }
  return files;
}

}  // namespace facenav::steps
