#pragma once
// SecondScreens: the windows beside the main one during treatment: guidance alone on the patient's side, and
// the projector's picture. Each fills another screen if there is one, else it is a window.

#include <QObject>
#include <QPointer>

#include "treat/guidance_screen.h"
#include "treat/projector_presenter.h"
#include "treat/projector_screen.h"
#include "treat/read_out.h"

class QScreen;

namespace facenav::ui {

class SecondScreens : public QObject {
  Q_OBJECT

 public:
  /// `page`: the widget that they belong to; they close with it.
  SecondScreens(ProjectorPresenter& projector, QWidget& page);

  void showGuidance(bool is_shown);
  bool showsGuidance() const;
  /// Opens the projector's window; the projector must be open in its presenter.
  void showProjector(bool is_shown);
  bool showsProjector() const;
  bool areShown() const { return showsGuidance() || showsProjector(); }
  /// Shows each new state.
  void follow(std::shared_ptr<const session::NavigationState> state, const ReadOut& read_out);

  GuidanceScreen* guidance() const { return guidance_; }
  ProjectorScreen* projector() const { return projector_screen_; }

 signals:
  void changed();

 private:
  QScreen* freeScreen(const QSize& wanted) const;
  void place(QWidget& window, const QSize& usual, const QSize& wanted) const;

  ProjectorPresenter& projector_;
  QWidget& page_;
  QPointer<GuidanceScreen> guidance_;
  QPointer<ProjectorScreen> projector_screen_;
};

}  // namespace facenav::ui
