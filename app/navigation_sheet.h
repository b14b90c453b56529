#pragma once
// Prints the import check: one finding a line, then the sheet of measures to compare with the person.

#include "facenav/surface/navigation_check.h"

namespace facenav::app {

void printNavigationCheck(const surface::NavigationCheck& check);

}  // namespace facenav::app
