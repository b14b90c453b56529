#pragma once
// `facenav evaluate return`: the return error of the coil across visits of the virtual room: another capture,
// expression, hair, light, seat and cameras. With the MRI, with the face measured at the first visit's
// alignment, and with that face alone; with a projector at both visits, and with two cameras alone, the
// coil's marker in the picture.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "context.h"
#include "evaluate/evaluation_head.h"

namespace facenav::app {

/// Result of one later visit against the first.
struct ReturnRun {
  std::string head, model;  // the skin that the visit aligns to: "MRI", "face alone", ..
  std::string change;       // what differs from the first visit
  std::uint64_t seed = 1;
  bool must_be_refused = false;  // another person, or moved cameras
  std::string refusal;           // empty if aligned
  int frames = 0;                // frames with both poses
  // Medians over the frames, and the 95th percentile: distance of the true coil, when guidance reads 0, from
  // where the expert's true coil was.
  double off_mm = 0, off_deg = 0, p95_mm = 0, p95_deg = 0;
  double predicted_mm = 0, bound95_mm = 0;  // given by the second alignment, at the expert's pose
};

struct ReturnRequest {
  std::vector<std::uint64_t> seeds{1};
  int frames = 40;                         // frames of each visit
  bool has_dots = true, has_plain = true;  // first visits with a projector, and without
};

/// Runs all models and changes for one head. `other`: another person, who must be refused; may be null.
std::vector<ReturnRun> runReturns(Context& context, const EvaluationHead& head, const EvaluationHead* other,
                                  const ReturnRequest& request);

/// Formats as Markdown: a table of medians by model, then each run.
std::string returnsTable(const std::vector<ReturnRun>& runs);
std::string returnsCsv(const std::vector<ReturnRun>& runs);

}  // namespace facenav::app
