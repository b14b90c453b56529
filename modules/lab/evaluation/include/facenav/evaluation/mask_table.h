#pragma once
// The tables of `facenav evaluate prepare`: one row per volume and method (compared with a true mask, with
// time and memory), one row per perturbation. Markdown for people, CSV for programs; a cell is empty if not
// measured.

#include <optional>
#include <string>
#include <vector>

#include "facenav/evaluation/mask_agreement.h"

namespace facenav::evaluation {

struct MaskRow {
  std::string volume, truth, method;  // truth: "tissue, closed", "with fluid", "" if there is none
  std::optional<MaskAgreement> agreement;
  double brain_ml = 0;
  double wall_s = 0, processor_s = 0, peak_mib = 0;
  std::string failure;        // one line, if no mask was found
  std::string contrast = {};  // that the method found, in words
};

struct PerturbationRow {
  std::string volume, method, perturbation;
  bool must_hold = true;               // a standard perturbation, not a hard head
  std::optional<MaskAgreement> moved;  // against the unperturbed mask of the same method
  std::optional<MaskAgreement> truth;  // against the true mask
  std::string failure;
};

std::string maskMarkdown(const std::vector<MaskRow>& rows);
std::string maskCsv(const std::vector<MaskRow>& rows);
/// One row per method, over all volumes: number of volumes and refusals, median Dice (a refusal counts as 0)
/// and the least Dice of those found.
std::string maskSummaryMarkdown(const std::vector<MaskRow>& rows);
std::string perturbationMarkdown(const std::vector<PerturbationRow>& rows);
std::string perturbationCsv(const std::vector<PerturbationRow>& rows);

}  // namespace facenav::evaluation
