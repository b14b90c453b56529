#include "facenav/evaluation/evaluation_report.h"

#include <cmath>

#include "evaluation_plots.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "facenav/evaluation/goals.h"
#include "facenav/evaluation/html_report.h"
#include "facenav/evaluation/run_table.h"
#include "markdown_cell.h"

namespace facenav::evaluation {
namespace {

ReportTable goalTable(const std::vector<RunRecord>& runs) {
  ReportTable table{"", {"quantity", "goal", "measured", "", "over"}, {}};
  for (const auto& row : judge(runs))
    table.rows.push_back(
        {row.quantity, row.goal,
         row.verdict == Verdict::not_measured && row.basis[0] == '0' ? "not measured" : row.measured,
         inWords(row.verdict), row.basis});
  return table;
}

std::string failureOf(const RunRecord& run) {
  return run.failure.empty() && run.alignment ? run.alignment->refusal : run.failure;
}

std::string nameOf(const RunRecord& run) {
  return run.scenario + (run.from.empty() ? "" : " from " + run.from) + ", " + run.head + ", " + run.rig +
         ", seed " + std::to_string(run.seed);
}

/// The main values of each run; evaluation.csv has all of them.
ReportTable runTable(const std::vector<RunRecord>& runs) {
  const std::vector<std::pair<std::string, std::string>> shown{
      {"alignment_target_mm", "alignment, mm"},
      {"alignment_bound95_mm", "its bound"},
      {"frames_head_tracked", "head tracked"},
      {"frames", "of frames"},
      {"motion_rms_mm", "motion rms, mm"},
      {"motion_p95_mm", "p95"},
      {"motion_max_mm", "max"},
      {"motion_rms_deg", "rms, deg"},
      {"coil_rms_mm", "coil rms, mm"},
      {"coil_rms_deg", "deg"},
      {"coil_on_head_p95_mm", "coil on head p95, mm"},
      {"head_wrong_as_tracked", "wrong head"},
      {"coil_wrong_as_tracked", "wrong coil"},
      {"longest_loss_s", "longest loss, s"}};
  ReportTable table{"", {"run"}, {}};
  for (const auto& [ignored, title] : shown) table.columns.push_back(title);
  for (const auto& run : runs) {
    std::vector<std::string> row{nameOf(run)};
    const auto figures = figuresOf(run);
    for (const auto& [name, ignored] : shown)
      for (const auto& [figure, value] : figures) {
        if (figure != name) continue;
        row.push_back(std::isfinite(value) ? fixed(value, value == std::floor(value) ? 0 : 3) : "");
      }
    table.rows.push_back(row);
  }
  return table;
}

ReportTable failureTable(const std::vector<RunRecord>& runs) {
  ReportTable table{"Refused or failed", {"run", "why"}, {}};
  for (const auto& run : runs)
    if (!failureOf(run).empty()) table.rows.push_back({nameOf(run), failureOf(run)});
  return table;
}

std::string markdown(const ReportTable& table) {
  std::string text = "|", rule = "|";
  for (const auto& column : table.columns) text += " " + column + " |", rule += "---|";
  text += "\n" + rule + "\n";
  for (const auto& row : table.rows) {
    text += "|";
    for (const auto& cell : row) text += " " + markdownCell(cell) + " |";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string goalsMarkdown(const std::vector<RunRecord>& runs) {
  std::string text = markdown(goalTable(runs));
  const auto failures = failureTable(runs);
  if (!failures.rows.empty()) text += "\n" + markdown(failures);
  return text;
}

void writeEvaluation(const std::vector<RunRecord>& runs, const std::string& about,
                     const std::filesystem::path& folder) {
  writeWholeFile(folder / "evaluation.csv", runsCsv(runs));
  writeWholeFile(folder / "evaluation.md", "# FaceNav's accuracy\n\n" + about + "\n\n" + goalsMarkdown(runs));
  const auto figures = writePlots(runs, folder);
  std::vector<ReportSection> sections{{"Goals", "", {goalTable(runs)}, {}}, {"Plots", "", {}, figures}};
  ReportSection each{"Each run", "All figures are in evaluation.csv.", {runTable(runs)}, {}};
  const auto failures = failureTable(runs);
  if (!failures.rows.empty()) each.tables.push_back(failures);
  sections.push_back(each);
  sections.push_back({"How it was measured",
                      "Errors are differences from the exact truth of the virtual room (or of the "
                      "recording's truth/ files). The "
                      "cortical target is the planned one, else the point 20 mm under the scalp below the "
                      "left hand area's coil pose. "
                      "'Head motion since alignment' puts the true alignment in, everything else is what the "
                      "clinician is shown. A pose "
                      "is wrong beyond 3 mm or 2 degrees, or where the patient is not there at all. Times "
                      "are processor time with one "
                      "thread.",
                      {},
                      {}});
  writeWholeFile(folder / "report.html", htmlReport("FaceNav: accuracy", about, sections));
}

}  // namespace facenav::evaluation
