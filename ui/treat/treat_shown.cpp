// What the Treat page shows of the newest state, in words and figures.

#include "treat/treat_workspace.h"

namespace facenav::ui {

/// The newest state in words; before guidance: what is missing for it.
ReadOut TreatWorkspace::readOut(const session::NavigationState& state, bool was_started) const {
  ReadOut read_out = makeReadOut(state);
  const QString doing = presenter_.isRunning() ? QString() : presenter_.doingWords();
  if (was_started) {
    if (presenter_.isPaused()) return whilePaused(read_out, presenter_.pauseWords());
    if (!presenter_.hasEnded() || !state.failure.empty()) return read_out;
    read_out.instruction = doing.isEmpty() ? tr("RECORDING ENDED: end the session, or start again") : doing;
    read_out.level = Level::idle;
    return read_out;
  }
  const bool has_moved = hasMoved();
  read_out.instruction = !doing.isEmpty()         ? doing
                         : has_moved              ? tr("CAMERAS MOVED: repair them (step 1)")
                         : !model_.isOpen()       ? tr("NO CASE OPEN")
                         : !presenter_.mayTreat() ? tr("NOT SIGNED OFF")
                         : !presenter_.otherChoiceWords().isEmpty()
                             ? tr("CAMERAS CHANGED: open them (step 1)")
                         : presenter_.isAligned() ? tr("READY: start guidance")
                                                  : tr("NOT ALIGNED");
  read_out.level = Level::idle;
  read_out.timing.clear();
  read_out.cameras = {has_moved                   ? tr("CAMERAS moved")
                      : presenter_.hasRecording() ? tr("CAMERAS ready")
                                                  : tr("CAMERAS none"),
                      {},
                      has_moved ? Level::lost : Level::idle};
  read_out.face = {tr("FACE idle"), {}, Level::idle};
  read_out.coil = {tr("COIL idle"), {}, Level::idle};
  return read_out;
}

/// The newest state. In a pause nobody is guided: its guidance is blank, in every view.
std::shared_ptr<const session::NavigationState> TreatWorkspace::shownState() const {
  const auto state = presenter_.state();
  if (!presenter_.isPaused()) return state;
  auto paused = std::make_shared<session::NavigationState>(*state);
  paused->guidance = {};
  return paused;
}

}  // namespace facenav::ui
