#pragma once
// CheckPresenter: the re-check of the registration as the Treat page shows it: measures for two seconds
// whether the MRI still matches the face. Monitoring asks for a check after a while
// (monitoring/registration_check.h); a failed check withholds guidance until one passes.

#include <QObject>
#include <optional>

#include "treat/read_out.h"
#include "treat/treat_presenter.h"

namespace facenav::ui {

class CheckPresenter : public QObject {
  Q_OBJECT

 public:
  explicit CheckPresenter(TreatPresenter& treat, QObject* parent = nullptr);

  /// Begins a check; the patient must hold still. Does nothing unless guidance runs.
  void begin();
  bool isMeasuring() const { return asked_.has_value(); }
  /// Takes the newest state; called about 30 times a second.
  void follow(const session::NavigationState& state);
  /// "Registration passed: 0.4 mm, 0.2\u00b0 off, 5 measurements" (the log has the same figures); "Measuring
  /// ..: the patient holds still"; or that a check is due. Empty without a session.
  QString words() const { return words_; }
  /// good: passed; lost: failed; caution: due, or not possible; idle: none yet.
  Level level() const { return level_; }

 signals:
  void changed();

 private:
  void set(const QString& words, Level level);

  TreatPresenter& treat_;
  std::optional<Timestamp> asked_;  // start of the running check
  int number_ = 0;                  // number of the newest finding when the check was requested
  int newest_ = 0;
  QString words_;
  Level level_ = Level::idle;
};

}  // namespace facenav::ui
