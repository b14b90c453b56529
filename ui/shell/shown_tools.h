#pragma once
// ShownTools: what Plan shows beside the targets: overlays, the electric field, the dose, the slices along
// the coil, the EEG sites. The switches are remembered.

#include <QFrame>
#include <functional>

#include "plan/field_presenter.h"
#include "plan/overlay_presenter.h"
#include "plan/plan_presenter.h"

class QHBoxLayout;
class QPushButton;

namespace facenav::ui {

class ShownTools : public QFrame {
  Q_OBJECT

 public:
  ShownTools(PlanPresenter& plan, OverlayPresenter& overlays, FieldPresenter& field,
             QWidget* parent = nullptr);
  bool showsCoilSlices() const;
  bool showsSites() const;

 signals:
  void coilSlicesShown(bool are_shown);
  void sitesShown(bool are_shown);

 private:
  template <class Chooser>
  void addMenu(const QString& words, const QString& tip, Chooser* panel,
               const std::pair<QString, QString>& help);
  QPushButton* addSwitch(const QString& words, const QString& tip, const char* setting, bool is_on_at_first);

  QHBoxLayout* row_;
  QPushButton *slices_, *sites_;
};

}  // namespace facenav::ui
