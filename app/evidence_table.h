#pragma once
// The table of resources/doc/evidence.md, compiled in: where the fitted constants of the code come from.

namespace facenav::app {

/// The page's text; its rows are "| module::kConstant | evidence |".
const char* evidenceTable();

}  // namespace facenav::app
