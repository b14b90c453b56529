#include "evaluate/gate_table.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "facenav/core/number_text.h"
#include "facenav/evaluation/error_statistics.h"

namespace facenav::app {
namespace {

using Columns = std::vector<std::pair<std::string, std::string>>;

std::string joined(const std::set<std::string>& words) {
  std::string all;
  for (const auto& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

/// Text in quotes, on one line.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
  return out + "\"";
}

double share(int part, int whole) { return whole > 0 ? double(part) / whole : 0.0; }

Columns columnsOf(const GateRow& row) {
  Columns all{
      {"seed", std::to_string(row.world.seed)},
      {"fault", room::nameOf(row.fault.kind)},
      {"fault_size", fixed(row.fault.size, 2)},
      {"fault_from_start", row.fault.kind != room::WorldFault::none && row.fault.is_from_start ? "1" : "0"},
      {"head", row.head}};
  for (auto& column : room::columnsOf(row.world)) all.push_back(std::move(column));
  const auto errors = evaluation::summarise(row.errors_mm);
  const Columns results{{"calibration_px", fixed(row.calibration_px, 3)},
                        {"size_measured", fixed(row.size_measured, 4)},
                        {"accepted", row.is_accepted ? "1" : "0"},
                        {"confirmed", row.is_confirmed ? "1" : "0"},
                        {"from", row.from},
                        {"start_mm", fixed(row.start_mm, 2)},
                        {"start_deg", fixed(row.start_deg, 2)},
                        {"bound_mm", fixed(row.bound_mm, 2)},
                        {"inside_bound", row.isInsideBound() ? "1" : "0"},
                        {"tracked", fixed(share(row.tracked, row.visible), 2)},
                        {"found_again", row.is_found_again ? "1" : "0"},
                        {"second_tracked", fixed(share(row.second_tracked, row.second_visible), 2)},
                        {"median_mm", fixed(errors.median, 2)},
                        {"worst_mm", fixed(errors.max, 2)},
                        {"over_tolerance", std::to_string(row.over_tolerance)},
                        {"wrong_shown", std::to_string(row.wrong_shown)},
                        {"named", quoted(joined(row.named))},
                        {"delay_found", row.is_delay_found ? "1" : "0"},
                        {"named_rightly", row.isNamedRightly() ? "1" : "0"},
                        {"tracked_alone", fixed(row.tracked_alone, 2)},
                        {"room_s", fixed(row.room_s, 1)},
                        {"product_s", fixed(row.product_s, 1)},
                        {"losses", quoted(row.losses)},
                        {"refusal", quoted(row.refusal)},
                        {"refusal_alone", quoted(row.refusal_alone)}};
  all.insert(all.end(), results.begin(), results.end());
  return all;
}

std::string percent(int part, int whole) {
  return whole > 0 ? formatted("%d of %d (%.0f %%)", part, whole, 100.0 * part / whole) : "-";
}

/// Row of the summary for the trials of one fault.
std::string summaryRow(const std::string& name, const std::vector<const GateRow*>& rows) {
  int accepted = 0, found = 0, inside = 0, over = 0, wrong = 0, wrong_trials = 0, named = 0, right = 0;
  int visible = 0, tracked = 0, seen = 0, confirmed = 0;
  std::vector<double> start_mm, errors_mm;
  for (const auto* row : rows) {
    accepted += row->is_accepted, confirmed += row->is_accepted && row->is_confirmed;
    found += row->is_found_again, inside += row->isInsideBound();
    visible += row->visible > 0 ? row->visible : room::WorldRoom::frameCount(), tracked += row->tracked;
    over += row->over_tolerance, wrong += row->wrong_shown, wrong_trials += row->wrong_shown > 0;
    seen += row->isFaultSeen();
    named += row->isFaultSeen() && row->isNamed();
    right += row->isFaultSeen() && row->isNamed() && row->isNamedRightly();
    if (row->is_accepted) start_mm.push_back(row->start_mm);
    errors_mm.insert(errors_mm.end(), row->errors_mm.begin(), row->errors_mm.end());
  }
  const int count = int(rows.size());
  const auto start = evaluation::summarise(start_mm), all = evaluation::summarise(errors_mm);
  return formatted("| %s | %s | %d | %s | %s | %.2f / %.2f | %s | %.2f / %.2f | %d in %d | %d | %s | %s |\n",
                   name.c_str(), percent(accepted, count).c_str(), confirmed,
                   percent(tracked, visible).c_str(), percent(found, count).c_str(), start.median, start.p95,
                   percent(inside, accepted).c_str(), all.median, all.p95, wrong, wrong_trials, over,
                   percent(named, seen).c_str(), percent(right, named).c_str());
}

/// The words without their numbers, so that equal reasons count together.
std::string withoutNumbers(const std::string& words) {
  std::string plain;
  for (const char c : words) {
    if (std::isdigit(static_cast<unsigned char>(c))) {
      if (plain.empty() || plain.back() != '#') plain += '#';
    } else if (c != '.' || plain.empty() || plain.back() != '#') {
      plain += c;
    }
  }
  return plain.substr(0, plain.find(';'));
}

void countReasons(const std::vector<const GateRow*>& rows, std::string& text) {
  std::map<std::string, int> reasons;
  for (const auto* row : rows) {
    if (!row->refusal.empty()) ++reasons["refused: " + withoutNumbers(row->refusal)];
    if (!row->losses.empty()) ++reasons["lost: " + row->losses];
  }
  std::vector<std::pair<int, std::string>> sorted;
  for (const auto& [reason, count] : reasons) sorted.emplace_back(-count, reason);
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [count, reason] : sorted) text += "- " + std::to_string(-count) + ": " + reason + "\n";
}

}  // namespace

std::string gateHeader() {
  std::string line;
  for (const auto& [name, ignored] : columnsOf(GateRow{})) line += (line.empty() ? "" : ",") + name;
  return line + "\n";
}

std::string gateLine(const GateRow& row) {
  std::string line;
  bool is_first = true;
  for (const auto& [ignored, value] : columnsOf(row)) {
    if (!is_first) line += ",";
    is_first = false;
    line += value;
  }
  return line + "\n";
}

std::string gateSummary(const std::vector<GateRow>& rows) {
  std::string text;
  for (const bool is_odd : {false, true}) {
    std::vector<const GateRow*> of_none;
    std::vector<std::pair<std::string, std::vector<const GateRow*>>> by_fault;
    for (const auto& row : rows) {
      if ((row.world.seed % 2 == 1) != is_odd) continue;
      const std::string name = room::nameOf(row.fault.kind);
      auto at =
          std::find_if(by_fault.begin(), by_fault.end(), [&](const auto& one) { return one.first == name; });
      if (at == by_fault.end()) at = by_fault.insert(by_fault.end(), {name, {}});
      at->second.push_back(&row);
      if (row.fault.kind == room::WorldFault::none) of_none.push_back(&row);
    }
    if (by_fault.empty()) continue;
    text += is_odd ? "Odd seeds (for scoring):\n\n" : "Even seeds (for fitting):\n\n";
    text +=
        "| fault | accepted | of them after a person confirmed the patient | frames tracked | found again in "
        "0.2 s | start mm, median / p95 | start inside "
        "its "
        "bound | frames mm, median / p95 | wrong poses shown | over 3 mm or 2 deg | fault named | of those "
        "rightly |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const auto& [name, of_fault] : by_fault) text += summaryRow(name, of_fault);
    text += "\n";
    if (!of_none.empty()) text += "Without a fault, refused or lost:\n";
    countReasons(of_none, text);
    text += "\n";
  }
  return text;
}

}  // namespace facenav::app
