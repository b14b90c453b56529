#pragma once
// PLAN: takes targets and pulses from files of other programs (interop). First a preview, which says of
// every item what would become of it; then all of it is written, or nothing.

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/interop/check.h"

namespace facenav::steps {

struct OtherImport {
  std::filesystem::path file;
  interop::Answers answers;
  std::filesystem::path t1;    // NIfTI that the other program used; empty: not named
  double utc_offset_h = 0;     // of the file's clock
  bool replaces = false;       // targets of the same name with another pose
  bool skips_refused = false;  // takes the rest
  std::string by;              // who imports; may be empty
  std::set<std::string> left_out_targets, left_out_sessions;  // names; the user wants the others only
};

/// What becomes of an item. listed: it is shown and not kept (landmarks, electrodes, targets without a pose).
/// left_out: the user does not want it.
enum class ItemFate { added, replaced, unchanged, listed, refused, left_out };
/// Returns "added", "replaced", ..
std::string toString(ItemFate fate);

struct PreviewedItem {
  interop::Item item;
  ItemFate fate = ItemFate::listed;
  std::string reason;  // why it is refused or only listed
};

/// Items of a file that are refused for the same reason.
struct RefusedItems {
  std::string reason;
  std::vector<std::size_t> items;  // places in ImportPreview::items
};

struct ImportPreview {
  interop::OtherFile file;  // its items stand in `items`
  std::vector<PreviewedItem> items;
  int count(ItemFate fate) const;
  int pulses() const;  // that would be kept
  /// The refused items by their reasons, in the file's order.
  std::vector<RefusedItems> refusals() const;
  /// One line that names the first refused item, why, how many are refused for that reason, and how many
  /// more; empty if none is refused.
  std::string refusal() const;
};

/// Reads the file and judges it against the case. Throws Error: no such file, unknown or damaged, or a case
/// without an MRI.
ImportPreview previewImport(const casefile::CaseStore& store, const OtherImport& order);

/// Holds one of several files that are taken together.
struct PreviewedFile {
  OtherImport order;
  ImportPreview preview;
  std::string failure;  // why it cannot be read; empty: `preview` holds what it has
};
/// Previews the files in their order. A target of one counts as the case's for those after it.
std::vector<PreviewedFile> previewImports(const casefile::CaseStore& store, const interop::CaseHead& head,
                                          const std::vector<OtherImport>& orders);

struct ImportedItems {
  int targets = 0;  // added or replaced
  int pulses = 0;
  std::vector<std::filesystem::path> sessions;
};
/// Writes what the preview says, all or nothing. Throws Error with the preview's refusal if an item is
/// refused and not skipped.
ImportedItems importOther(const casefile::CaseStore& store, const OtherImport& order,
                          const ImportPreview& preview);

/// Stores the plan with the new targets. Throws Error if it cannot, and then keeps the old plan.
using WritePlan = std::function<void(const guidance::TreatmentPlan&)>;
/// Writes what the previews of several files say, all or nothing; files that could not be read are left out.
/// Throws Error as importOther() does.
ImportedItems importOthers(const casefile::CaseStore& store, const std::vector<PreviewedFile>& files,
                           const WritePlan& write);

/// The case as items are judged by it. Throws Error for a case without an MRI.
interop::CaseHead caseHead(const casefile::CaseStore& store);

/// Judges items that came in another way than by a file; order.file names where from, order.t1 is ignored.
/// `head`: caseHead() of the case.
ImportPreview previewItems(const casefile::CaseStore& store, const interop::CaseHead& head,
                           const OtherImport& order, interop::OtherFile items);

}  // namespace facenav::steps
