#pragma once
// TreatSide: the right column of Treat: the tools Aim, Motor, Session and Check, the figures below or beside
// the bull's eye, the pulses, and the re-check of the registration.

#include <QWidget>

#include "shell/second_screens.h"
#include "treat/check_presenter.h"
#include "treat/motor_presenter.h"
#include "treat/session_sounds.h"
#include "treat/tip_presenter.h"

class QBoxLayout;
class QScrollArea;
class QStackedWidget;
class QTabBar;

namespace facenav::ui {

class BullsEyeView;
class FiguresPanel;
class MotorPanel;
class PulseRow;

class TreatSide : public QWidget {
  Q_OBJECT

 public:
  /// Panel shown beside the figures.
  enum class Tool { aim, motor, session, check };
  TreatSide(TreatPresenter& treat, MotorPresenter& motor, CheckPresenter& check, TipPresenter& tip,
            SessionSounds& sounds, SecondScreens& screens, ProjectorPresenter& projector,
            QWidget* parent = nullptr);

  void showTool(Tool tool);
  bool isShown(Tool tool) const;
  /// Updates the pulses' figures at each refresh.
  void refreshPulses();
  /// Shows a new state: bull's eye and figures.
  void show(const guidance::GuidanceState& guidance, const ReadOut& read_out);
  static constexpr int kFigures_px = 520;  // two figures of 64 and 48 pt side by side

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QTabBar* makeTabs();
  void markOffers(const OffersPresenter& offers);
  void arrange();

  QStackedWidget* tools_;
  BullsEyeView* bulls_eye_;
  FiguresPanel* figures_;
  QBoxLayout* bulls_eye_and_figures_;
  QScrollArea* column_;
  QTabBar* tabs_;
  MotorPanel* motor_;
  PulseRow* pulses_;
};

}  // namespace facenav::ui
