#pragma once
// ReadOut: a NavigationState as the words and figures of the Treat workspace. If lost, every figure is blank.

#include <QString>

#include "facenav/session/navigation_state.h"

namespace facenav::ui {

enum class Level { good, caution, lost, idle };  // idle: nothing is expected yet

struct Chip {
  QString words, tip;
  Level level = Level::lost;
};

struct ReadOut {
  QString across, depth, tilt, twist;  // "2.4", "+1.0", "3\u00b0"; a dash when there is none
  QString predicted;                   // "95 % within 1.4 mm at the target", or empty
  QString gap, gap_tip;                // "gap 4.6 mm, field -17 %; cameras 0.9 mm", or empty
  bool gap_disagrees = false;          // poses and cameras differ by more than their own error
  QString instruction;
  Level level = Level::lost;
  Chip cameras, face, coil;
  QString second;  // the second coil: "B: on target, across 1.2, depth +0.4 mm, tilt 2\u00b0"; empty: none
  QString timing;  // "4.1 ms   0 dropped"
};

ReadOut makeReadOut(const session::NavigationState& state);
/// The read-out while the session is paused: no figure and no "ON TARGET" stays; `words`: the pause's.
ReadOut whilePaused(ReadOut read_out, const QString& words);

}  // namespace facenav::ui
