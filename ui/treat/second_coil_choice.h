#pragma once
// SecondCoilChoice: whether the window follows a second coil, which one of the library, its target, and which
// of both coils gives the pulses. Nothing of it is remembered: a person says it for each session.

#include <QStringList>

#include "facenav/treat/treatment.h"

namespace facenav::ui {

class SecondCoilChoice {
 public:
  /// Coils of the library.
  static QStringList names();
  const QString& coil() const { return coil_; }  // empty: no second coil
  const QString& target() const { return target_; }
  const QString& pulses() const { return pulses_; }  // name of the coil that gives them; empty: not said
  void chooseCoil(const QString& name) { coil_ = name; }
  void chooseTarget(const QString& name) { target_ = name; }
  void choosePulses(const QString& coil) { pulses_ = coil; }

  /// Adds the second coil to a session with this first coil; nothing if there is none. Throws Error: no such
  /// coil or target, a coil that cannot be told from the first one, or nobody said which gives the pulses.
  void addTo(steps::TreatmentRequest& request) const;

 private:
  QString coil_, target_, pulses_;
};

}  // namespace facenav::ui
