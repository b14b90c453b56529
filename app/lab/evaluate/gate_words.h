#pragma once
// The faults that the program's words name.

#include <set>
#include <string>

#include "facenav/room/world.h"

namespace facenav::app {

/// Faults named by a message or by the word of a loss ("out_of_step", "moved", "other_person", ..).
std::set<std::string> faultsNamedIn(const std::string& words);
/// The name that is right for a fault; empty for none.
std::string rightNameOf(room::WorldFault fault);

}  // namespace facenav::app
