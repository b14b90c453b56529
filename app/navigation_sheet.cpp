#include "navigation_sheet.h"

#include <cstdio>

namespace facenav::app {
namespace {

void print(const surface::FaceMeasure& measure) {
  std::printf("  %-42s %s%5.0f mm  +- %.0f", measure.name.c_str(), measure.is_lower_bound ? ">=" : "  ",
              measure.value_mm, measure.uncertainty_mm);
  if (measure.usual)
    std::printf("   adults %.0f-%.0f%s", measure.usual->low_mm, measure.usual->high_mm,
                measure.isUsual() ? "" : "  unusual");
  std::printf("\n");
}

}  // namespace

void printNavigationCheck(const surface::NavigationCheck& check) {
  std::printf("fit for navigation: %s\n", toString(check.verdict()).c_str());
  for (const auto& finding : check.findings) std::printf("  %s\n", inWords(finding).c_str());
  if (check.measures.empty()) return;
  std::printf("measures to hold against the person (>=: cut by the scan's edge):\n");
  for (const auto& measure : check.measures) print(measure);
}

}  // namespace facenav::app
