#pragma once
// Reads a number that was typed into a field, as options and files are read.

#include <QString>
#include <optional>

namespace facenav::ui {

/// Reads "350", "-38.5", "12,5" (a decimal comma); nothing for other text, infinity, or a number too large to
/// be meant.
std::optional<double> typedNumber(const QString& typed);

}  // namespace facenav::ui
