#include "commands/import_other.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>

#include "facenav/core/error.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/interop/formats.h"
#include "json_output.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;
using interop::Kind;

Json threeOf(const Point<Mri>& p) { return rowMajor(p); }

Json jsonOf(const steps::PreviewedItem& previewed) {
  const auto& item = previewed.item;
  Json json{{"kind", toString(item.kind)},
            {"name", item.name},
            {"where", item.where},
            {"fate", toString(previewed.fate)}};
  if (!previewed.reason.empty()) json["reason"] = previewed.reason;
  if (item.mri_T_coil)
    json["mri_T_coil"] = rowMajor(*item.mri_T_coil);
  else
    json["mri_T_coil"] = nullptr;
  if (item.mri_place) json["place_mm"] = threeOf(*item.mri_place);
  if (!item.time.empty()) json["time"] = item.time;
  if (!item.target.empty()) json["target"] = item.target;
  if (!item.session.empty()) json["session"] = item.session;
  if (item.intensity_pct) json["intensity_pct"] = *item.intensity_pct;
  if (item.didt_a_per_us) json["didt_a_per_us"] = *item.didt_a_per_us;
  if (item.mep_uv) json["mep_uv"] = *item.mep_uv;
  if (!item.values.empty()) json["values"] = item.values;
  if (!item.notes.empty()) json["notes"] = item.notes;
  return json;
}

/// Options that the reasons name: what only a person knows.
Json asksOf(const steps::ImportPreview& preview) {
  std::set<std::string> options;
  for (const auto& item : preview.items)
    for (std::size_t at = 0; (at = item.reason.find(" --", at)) != std::string::npos;) {
      const auto end = item.reason.find_first_of(" ,:;)", ++at);
      options.insert(item.reason.substr(at, end - at));
    }
  return options;
}

Json jsonOf(const steps::ImportPreview& preview) {
  Json items = Json::array();
  for (const auto& item : preview.items) items.push_back(jsonOf(item));
  return {{"format", preview.file.format},
          {"file", preview.file.words},
          {"space", toString(preview.file.space)},
          {"space_in_file", preview.file.space_words},
          {"refused", preview.count(steps::ItemFate::refused)},
          {"refusal", preview.refusal()},
          {"asks", asksOf(preview)},
          {"notes", preview.file.notes},
          {"items", items}};
}

/// Tells several items that are refused for one reason in one line.
void printRefused(const steps::ImportPreview& preview, const steps::RefusedItems& refused) {
  constexpr std::size_t kNamed = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(kNamed, refused.items.size()); ++i)
    names += (i > 0 ? ", '" : "'") + preview.items[refused.items[i]].item.name + "'";
  if (refused.items.size() > kNamed) names += ", ..";
  std::printf("refused   %zu items (%s): %s\n", refused.items.size(), names.c_str(), refused.reason.c_str());
}

void print(const steps::ImportPreview& preview) {
  std::printf("%s\n", preview.file.words.c_str());
  for (const auto& note : preview.file.notes) std::printf("note: %s\n", note.c_str());
  std::set<std::string> told;  // reasons of several items
  for (const auto& refused : preview.refusals())
    if (refused.items.size() > 1 && told.insert(refused.reason).second) printRefused(preview, refused);
  for (const auto& [item, fate, reason] : preview.items) {
    if (fate == steps::ItemFate::refused && told.count(reason) > 0) continue;
    std::printf("%-9s %-9s '%s'", toString(fate).c_str(), toString(item.kind).c_str(), item.name.c_str());
    if (item.mri_T_coil) {
      const auto p = item.mri_T_coil->translation_mm();
      std::printf("  %.1f %.1f %.1f mm", p.x(), p.y(), p.z());
    }
    if (item.mri_place)
      std::printf("  %.1f %.1f %.1f mm", item.mri_place->mm.x(), item.mri_place->mm.y(),
                  item.mri_place->mm.z());
    if (!item.time.empty()) std::printf("  %s", item.time.c_str());
    std::printf(reason.empty() ? "\n" : ": %s\n", reason.c_str());
    for (const auto& note : item.notes) std::printf("          note: %s\n", note.c_str());
  }
}

Json jsonOf(const steps::ImportedItems& imported) {
  Json sessions = Json::array();
  for (const auto& folder : imported.sessions) sessions.push_back(folder.filename().string());
  return {{"targets", imported.targets}, {"pulses", imported.pulses}, {"sessions", sessions}};
}

void printSummary(const steps::ImportedItems& imported, const steps::ImportPreview& preview) {
  const auto same = std::count_if(preview.items.begin(), preview.items.end(), [](const auto& item) {
    return item.fate == steps::ItemFate::unchanged && item.item.kind == Kind::target;
  });
  std::printf("%d targets added", imported.targets);
  if (same > 0) std::printf(", %d there already", int(same));
  for (const auto& folder : imported.sessions) std::printf("; session %s", folder.filename().c_str());
  if (imported.pulses > 0) std::printf(" with %d pulses", imported.pulses);
  std::printf("\n");
}

void answer(ImportOtherRequest& request) {
  auto& answers = request.order.answers;
  if (request.y_sign == "as-written" && answers.flips_handle)
    throw WrongUsage("--y-sign as-written and --flip-handle exclude each other", "give one of them");
  answers.keeps_handle = request.y_sign == "as-written";
  answers.flips_handle |= request.y_sign == "flipped";
  if (!request.head_frame.empty())
    answers.head_frame =
        request.head_frame == "x-nasion" ? interop::HeadFrame::x_nasion : interop::HeadFrame::x_right;
  if (!request.space.empty())
    answers.space = request.space == "lps" ? interop::Space::lps : interop::Space::ras;
  if (!request.form.empty())
    answers.form = request.form == "qform" ? interop::Form::qform : interop::Form::sform;
}

}  // namespace

void addImportOtherOptions(CLI::App& verb, ImportOtherRequest& request) {
  verb.add_flag("--dry-run", request.is_dry_run,
                "of another program's file: prints what would come in; writes nothing");
  verb.add_option("--space", request.space,
                  "of another program's file: its coordinates, where it does not say")
      ->check(CLI::IsMember({"ras", "lps"}));
  verb.add_option("--form", request.form,
                  "of another program's file: the form of the T1's NIfTI that it means")
      ->check(CLI::IsMember({"sform", "qform"}));
  verb.add_option("--t1", request.order.t1, "of another program's file: the NIfTI that the program used");
  verb.add_flag("--flip-handle", request.order.answers.flips_handle,
                "of another program's file: its handle points the other way; the same as --y-sign flipped");
  verb.add_option("--y-sign", request.y_sign,
                  "of another program's file: where it leaves open which way the handle points (NIBS-BIDS), "
                  "its y is right as written, or flipped")
      ->check(CLI::IsMember({"as-written", "flipped"}));
  verb.add_option(
          "--head-frame", request.head_frame,
          "of another program's file: of a frame by nasion and ears without landmarks (visor2), where "
          "its x points: to the nasion, or to the right ear")
      ->check(CLI::IsMember({"x-nasion", "x-right"}));
  verb.add_option("--utc-offset", request.order.utc_offset_h,
                  "of another program's file: hours that its clock is ahead of UTC; default 0")
      ->check(CLI::Range(-14.0, 14.0));
  verb.add_flag("--replace", request.order.replaces,
                "of another program's file: replaces targets of the same name");
  verb.add_flag("--skip-refused", request.order.skips_refused,
                "of another program's file: takes what is not refused");
  verb.add_option("--by", request.order.by, "of another program's file: who imports, kept with the targets");
}

bool isOtherFile(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw Error("file does not exist", file.string(), "check the path");
  char start[2] = {};
  std::ifstream(file, std::ios::binary).read(start, sizeof start);
  return start[0] != 'P' || start[1] != 'K' || interop::isSessionArchive(file);
}

void importOtherFile(const Context& context, const std::filesystem::path& case_folder,
                     ImportOtherRequest request) {
  answer(request);
  const auto store = casefile::CaseStore::open(case_folder);
  const auto preview = steps::previewImport(store, request.order);
  const bool is_refused = !request.order.skips_refused && preview.count(steps::ItemFate::refused) > 0;
  Json json = jsonOf(preview);
  if (!request.is_json && request.is_dry_run) print(preview);
  if (is_refused || request.is_dry_run) {
    json["imported"] = nullptr;
    if (request.is_json) printJson(json);
    if (is_refused) throw Error(preview.refusal(), request.order.file.string(), "nothing was imported");
    return;
  }
  const auto imported = steps::importOther(store, request.order, preview);
  json["imported"] = jsonOf(imported);
  if (request.is_json) return printJson(json);
  if (context.is_quiet) return;
  print(preview);
  printSummary(imported, preview);
}

}  // namespace facenav::app
