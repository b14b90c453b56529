#pragma once
// FollowedCoil: which coil the window follows: a recording's, or one of the library. The choice from the
// library is remembered, because live cameras do not identify the coil.

#include <QString>
#include <QStringList>
#include <optional>

#include "facenav/coil_tracking/coil_card.h"
#include "facenav/guidance/target.h"
#include "facenav/treat/treatment.h"

namespace facenav::ui {

class FollowedCoil {
 public:
  FollowedCoil();
  /// Follows the coil filmed in a recording.
  void useFilm(const steps::TreatmentFilm& film);
  /// Follows the remembered coil, for live cameras.
  void useRemembered();
  /// Names to choose from: the recording's own coil, then the library.
  QStringList names() const;
  QString name() const { return QString::fromStdString(model_.name); }
  /// Chooses a coil; `use` follows it in a running session. If `use` throws Error, nothing has changed.
  /// Throws Error also if there is no such coil.
  void choose(const QString& name, const std::function<void(const coil_tracking::CoilModel&)>& use);
  /// Reminds that `target` (may be null) was found with another coil, that the coil's field is not strongest
  /// under its centre, or that its calibration is old or not recorded; empty if none applies.
  QString reminder(const guidance::Target* target) const;
  /// Adds what a treatment must log about the coil.
  void noteIn(steps::TreatmentRequest& request) const;
  const coil_tracking::CoilModel& model() const { return model_; }

 private:
  coil_tracking::CoilModel model_;
  coil_tracking::CoilCard card_;
  std::optional<steps::TreatmentFilm> film_;  // the recording whose coil can be chosen again
};

}  // namespace facenav::ui
