#pragma once
// `facenav evaluate gates --strangers N`: other persons' scans, and the person's own one mirrored, are paired
// with the recording of a drawn world and aligned as `facenav track` aligns. Each should be refused. Where
// the program asks who the patient is, a second try has a false confirmation.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/gate_heads.h"

namespace facenav::app {

/// One alignment of a recording with another person's scan.
struct StrangerTry {
  bool is_accepted = false;
  std::string from;              // "dots", "plain", "film"
  double bound_mm = 0.0;         // 95 % at the target, as stated
  bool is_person_asked = false;  // refused only until a person confirms the patient
  std::string refusal;           // the program's words
  double align_s = 0.0;          // processor time
};

struct StrangerRow {
  std::uint64_t seed = 0;
  std::string head, scan;    // names; the same name for the mirrored scan
  bool is_mirrored = false;  // the person's own scan, left and right exchanged
  StrangerTry unconfirmed;
  std::optional<StrangerTry> confirmed;  // nothing: no person was asked
};

/// Aligns the recording in a trial's folder with the scans of `count` other heads (fewer if there are no
/// more) and with the mirrored one. No case is kept. Throws Error: no recording there.
std::vector<StrangerRow> pairStrangers(Context& context, GateHeads& heads, const room::World& world,
                                       std::size_t count, const std::filesystem::path& folder);

/// CSV: a header, then one line a pair.
std::string strangerTable(const std::vector<StrangerRow>& rows);
/// Markdown, even and odd seeds apart: how many pairs were accepted, asked about, and accepted with a false
/// confirmation; then each accepted pair.
std::string strangerSummary(const std::vector<StrangerRow>& rows);
/// First line of strangerSummary.
inline constexpr const char* kStrangersHeading = "## Other persons' scans";

}  // namespace facenav::app
