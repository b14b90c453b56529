// Output of `facenav evaluate return`.

#include <algorithm>
#include <map>

#include "evaluate/return_run.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::app {
namespace {

std::string summaryRow(const std::string& model, const std::vector<const ReturnRun*>& runs) {
  std::vector<double> mm, deg;
  int refused = 0, inside = 0, met = 0;
  for (const auto* run : runs) {
    if (!run->refusal.empty() || run->frames == 0) {
      ++refused;
      continue;
    }
    mm.push_back(run->off_mm), deg.push_back(run->off_deg);
    inside += run->off_mm <= run->bound95_mm;
    met += run->off_mm <= 1 && run->off_deg <= 1;
  }
  if (mm.empty()) return formatted("| %s | all %d refused | | | | |\n", model.c_str(), refused);
  return formatted("| %s | %.2f mm, %.2f deg | %.2f mm, %.2f deg | %d of %zu | %d of %zu | %d |\n",
                   model.c_str(), upperMedian(mm), upperMedian(deg), *std::max_element(mm.begin(), mm.end()),
                   *std::max_element(deg.begin(), deg.end()), met, mm.size(), inside, mm.size(), refused);
}

}  // namespace

std::string returnsTable(const std::vector<ReturnRun>& runs) {
  std::map<std::string, std::vector<const ReturnRun*>> by_model, by_change;
  std::string refusals;
  for (const auto& run : runs) {
    if (run.must_be_refused) continue;
    by_model[run.model].push_back(&run);
    by_change[run.model + ": " + run.change].push_back(&run);
  }
  std::map<std::string, std::pair<int, int>> refused;
  for (const auto& run : runs)
    if (run.must_be_refused) {
      auto& [yes, all] = refused[run.model + ": " + run.change];
      yes += !run.refusal.empty(), ++all;
    }
  std::string text =
      "| model | median | largest | within 1 mm and 1 deg | inside the 95 % bound | refused "
      "|\n|---|---|---|---|---|---|\n";
  for (const auto& [model, group] : by_model) text += summaryRow(model, group);
  for (const auto& [change, group] : by_change) text += summaryRow(change, group);
  text += "\n| must be refused | was |\n|---|---|\n";
  for (const auto& [what, count] : refused)
    text += formatted("| %s | %d of %d |\n", what.c_str(), count.first, count.second);
  return text;
}

std::string returnsCsv(const std::vector<ReturnRun>& runs) {
  std::string csv =
      "head,model,change,seed,must_be_refused,refusal,frames,off_mm,off_deg,p95_mm,p95_deg,predicted_mm,"
      "bound95_mm\n";
  for (const auto& run : runs) {
    std::string refusal = run.refusal;
    std::replace(refusal.begin(), refusal.end(), '"', '\'');
    csv += run.head + ",\"" + run.model + "\",\"" + run.change + "\"," + std::to_string(run.seed) +
           (run.must_be_refused ? ",1," : ",0,") + "\"" + refusal + "\"" +
           formatted(",%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n", run.frames, run.off_mm, run.off_deg, run.p95_mm,
                     run.p95_deg, run.predicted_mm, run.bound95_mm);
  }
  return csv;
}

}  // namespace facenav::app
