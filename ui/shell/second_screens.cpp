#include "shell/second_screens.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWindow>

namespace facenav::ui {

SecondScreens::SecondScreens(ProjectorPresenter& projector, QWidget& page)
    : QObject(&page), projector_(projector), page_(page) {
  connect(&projector_, &ProjectorPresenter::drawn, this,
          [this](std::shared_ptr<const pictures::DrawnOverlay> picture) {
            if (projector_screen_) projector_screen_->showDrawn(std::move(picture));
          });
  connect(&projector_, &ProjectorPresenter::changed, this, [this] {
    if (!projector_.isOpen()) showProjector(false);
  });
}

/// Returns a screen that none of our windows uses, preferably one of the wanted size.
QScreen* SecondScreens::freeScreen(const QSize& wanted) const {
  const QWindow* main = page_.window()->windowHandle();
  QScreen* found = nullptr;
  for (QScreen* screen : QGuiApplication::screens()) {
    const auto isOn = [screen](const QWidget* widget) {
      return widget && widget->isVisible() && widget->windowHandle() &&
             widget->windowHandle()->screen() == screen;
    };
    if ((main && main->screen() == screen) || isOn(guidance_) || isOn(projector_screen_)) continue;
    if (!found || screen->size() == wanted) found = screen;
  }
  return found;
}

void SecondScreens::place(QWidget& window, const QSize& usual, const QSize& wanted) const {
  if (QScreen* screen = freeScreen(wanted)) {
    window.setGeometry(screen->geometry());
    window.showFullScreen();
    return;
  }
  window.resize(usual);
  window.show();
}

bool SecondScreens::showsGuidance() const { return guidance_ && guidance_->isVisible(); }
bool SecondScreens::showsProjector() const { return projector_screen_ && projector_screen_->isVisible(); }

void SecondScreens::showGuidance(bool is_shown) {
  if (is_shown == showsGuidance()) return;
  if (!guidance_) {
    guidance_ = new GuidanceScreen(&page_);
    connect(guidance_, &GuidanceScreen::closed, this, &SecondScreens::changed);
  }
  is_shown ? place(*guidance_, {960, 540}, {}) : void(guidance_->close());
  emit changed();
}

void SecondScreens::showProjector(bool is_shown) {
  if (is_shown == showsProjector() || (is_shown && !projector_.isOpen())) return;
  if (!projector_screen_) {
    projector_screen_ = new ProjectorScreen(&page_);
    connect(projector_screen_, &ProjectorScreen::closed, this, &SecondScreens::changed);
  }
  is_shown ? place(*projector_screen_, projector_.size(), projector_.size())
           : void(projector_screen_->close());
  emit changed();
}

void SecondScreens::follow(std::shared_ptr<const session::NavigationState> state, const ReadOut& read_out) {
  if (showsGuidance()) guidance_->set(state->guidance, read_out);
  if (!showsProjector()) return;
  projector_screen_->follow(state);
  projector_.ask(std::move(state));
}

}  // namespace facenav::ui
