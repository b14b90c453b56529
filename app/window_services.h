#pragma once
// What the window can have done: the steps and implementations of the command line, handed to it as
// functions.

#include "presenters/services.h"

namespace facenav::app {

ui::Services windowServices();

}  // namespace facenav::app
