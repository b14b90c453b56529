#pragma once
// Pages of resources/doc that are compiled in: where the fitted constants come from (evidence.md), and what
// refuses or withholds (gates.md).

namespace facenav::app {

/// The page's text; its rows are "| module::kConstant | evidence |".
const char* evidenceTable();
/// The page's text, with one table of gates for each part of a treatment.
const char* gatesTable();

}  // namespace facenav::app
