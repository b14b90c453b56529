#pragma once
// The text of one cell of a Markdown table. Private to evaluation.

#include <string>

namespace facenav::evaluation {

/// Escapes a bar and replaces a line break by a blank, so that the row keeps its columns.
inline std::string markdownCell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c == '\n' || c == '\r' ? ' ' : c;
  }
  return cell;
}

}  // namespace facenav::evaluation
