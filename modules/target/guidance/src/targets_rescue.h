#pragma once
// Rescue of a targets.json that is no valid JSON: what can still be read of it.

#include <string>

namespace facenav::guidance {

/// Returns valid JSON with the targets that are complete in `text`; values that are no JSON (NaN, Infinity,
/// 1e999) become null. Empty if there is no complete target.
std::string rescuedTargets(const std::string& text);

}  // namespace facenav::guidance
