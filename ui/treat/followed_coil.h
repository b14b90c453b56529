#pragma once
// FollowedCoil: which coil the window follows: that of a recording, or one of the library. The choice from
// the library is remembered, because with live cameras nothing else says which coil is held.

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
  /// The coil filmed in a recording.
  void useFilm(const steps::TreatmentFilm& film);
  /// Of live cameras: the remembered one.
  void useRemembered();
  /// The recording's own one, then those of the library.
  QStringList names() const;
  QString name() const { return QString::fromStdString(model_.name); }
  /// `use` follows it in a running session; where it throws Error, nothing has changed. Throws Error, also
  /// where there is no such coil.
  void choose(const QString& name, const std::function<void(const coil_tracking::CoilModel&)>& use);
  /// That `target` (may be null) was found with another coil, or that its field is not strongest under its
  /// centre, its calibration old or not recorded; empty: nothing to say.
  QString reminder(const guidance::Target* target) const;
  /// What a treatment must log of it.
  void noteIn(steps::TreatmentRequest& request) const;
  const coil_tracking::CoilModel& model() const { return model_; }

 private:
  coil_tracking::CoilModel model_;
  coil_tracking::CoilCard card_;
  std::optional<steps::TreatmentFilm> film_;  // whose coil may be chosen again
};

}  // namespace facenav::ui
