#pragma once
// The import check on a terminal: findings one a line, then the sheet of measures to hold against the person.

#include "facenav/surface/navigation_check.h"

namespace facenav::app {

void printNavigationCheck(const surface::NavigationCheck& check);

}  // namespace facenav::app
