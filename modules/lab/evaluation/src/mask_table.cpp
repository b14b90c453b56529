#include "facenav/evaluation/mask_table.h"

#include <algorithm>
#include <map>

#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "markdown_cell.h"

namespace facenav::evaluation {
namespace {

using Row = std::vector<std::string>;

std::string markdown(const Row& header, const std::vector<Row>& rows) {
  const auto line = [](const Row& row) {
    std::string text = "|";
    for (const auto& cell : row) text += " " + (cell.empty() ? std::string("-") : markdownCell(cell)) + " |";
    return text + "\n";
  };
  std::string text = line(header) + line(Row(header.size(), "---"));
  for (const auto& row : rows) text += line(row);
  return text;
}

std::string csv(const Row& header, const std::vector<Row>& rows) {
  const auto line = [](const Row& row) {
    std::string text;
    for (const auto& cell : row) {
      if (&cell != &row.front()) text += ",";
      std::string quoted;
      for (char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
      text += cell.find_first_of(",\"\n") == std::string::npos ? cell : "\"" + quoted + "\"";
    }
    return text + "\n";
  };
  std::string text = line(header);
  for (const auto& row : rows) text += line(row);
  return text;
}

/// Adds Dice, 95 % Hausdorff, mean distance and inside; empty cells if there is no agreement.
void addAgreement(const std::optional<MaskAgreement>& a, Row& row) {
  if (!a) return void(row.insert(row.end(), 4, ""));
  row.insert(row.end(), {fixed(a->dice, 4), fixed(a->hausdorff95_mm, 2), fixed(a->mean_distance_mm, 2),
                         fixed(100 * a->inside, 2)});
}

std::vector<Row> cells(const std::vector<MaskRow>& rows) {
  std::vector<Row> all;
  for (const auto& r : rows) {
    Row row{r.volume, r.truth, r.method};
    addAgreement(r.agreement, row);
    row.insert(row.end(), {r.failure.empty() ? fixed(r.brain_ml, 0) : "", fixed(r.wall_s, 2),
                           fixed(r.processor_s, 2), fixed(r.peak_mib, 0), r.failure, r.contrast});
    all.push_back(row);
  }
  return all;
}

std::vector<Row> cells(const std::vector<PerturbationRow>& rows) {
  std::vector<Row> all;
  for (const auto& r : rows) {
    Row row{r.volume,
            r.method,
            r.perturbation,
            r.must_hold ? "yes" : "no",
            r.moved && r.must_hold ? fixed(1 - r.moved->dice, 4) : "",
            r.moved && r.must_hold ? fixed(r.moved->hausdorff95_mm, 2) : ""};
    addAgreement(r.truth, row);
    row.push_back(r.failure);
    all.push_back(row);
  }
  return all;
}

}  // namespace

std::string maskMarkdown(const std::vector<MaskRow>& rows) {
  return markdown({"volume", "truth", "method", "Dice", "95 % Hausdorff (mm)", "mean (mm)", "inside (%)",
                   "brain (ml)", "time (s)", "processor (s)", "peak (MiB)", "failure", "seen as"},
                  cells(rows));
}

std::string maskCsv(const std::vector<MaskRow>& rows) {
  return csv({"volume", "truth", "method", "dice", "hausdorff95_mm", "mean_distance_mm", "inside_percent",
              "brain_ml", "wall_s", "processor_s", "peak_mib", "failure", "seen_as"},
             cells(rows));
}

std::string maskSummaryMarkdown(const std::vector<MaskRow>& rows) {
  struct Summary {
    std::vector<double> dice;
    double least = 1;
    int refused = 0;
  };
  std::map<std::string, Summary> by_method;
  for (const auto& row : rows) {
    Summary& summary = by_method[row.method];
    summary.dice.push_back(row.agreement ? row.agreement->dice : 0);
    if (row.agreement) summary.least = std::min(summary.least, row.agreement->dice);
    summary.refused += !row.failure.empty();
  }
  std::vector<Row> table;
  for (const auto& [method, s] : by_method)
    table.push_back({method, std::to_string(s.dice.size()), std::to_string(s.refused),
                     fixed(median(s.dice), 4), s.refused < int(s.dice.size()) ? fixed(s.least, 4) : ""});
  return markdown({"method", "heads", "refused", "Dice median (refused: 0)", "Dice least (found)"}, table);
}

std::string perturbationMarkdown(const std::vector<PerturbationRow>& rows) {
  return markdown({"volume", "method", "perturbation", "must hold", "moved (1 - Dice)", "moved 95 % (mm)",
                   "Dice", "95 % Hausdorff (mm)", "mean (mm)", "inside (%)", "failure"},
                  cells(rows));
}

std::string perturbationCsv(const std::vector<PerturbationRow>& rows) {
  return csv({"volume", "method", "perturbation", "must_hold", "moved_1_minus_dice", "moved_hausdorff95_mm",
              "dice", "hausdorff95_mm", "mean_distance_mm", "inside_percent", "failure"},
             cells(rows));
}

}  // namespace facenav::evaluation
