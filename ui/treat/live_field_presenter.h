#pragma once
// LiveFieldPresenter: the electric field of the coil as it is held now (treat/live_field.h), for the Treat
// page: colours on the brain, and the strength at the target in words. Coil and rate are those of Plan's
// field; the output that is set has priority over the rate. Without a pose nothing is shown.

#include <QObject>

#include "facenav/plan/planned_field.h"
#include "facenav/scene/field_layer.h"
#include "facenav/treat/live_field.h"
#include "treat/treat_presenter.h"

namespace facenav::ui {

class LiveFieldPresenter : public QObject {
  Q_OBJECT

 public:
  LiveFieldPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent = nullptr);

  /// The user's choice, remembered (QSettings).
  bool isOn() const { return is_on_; }
  void setOn(bool is_on);
  /// Reads the choices of Plan and the motor threshold again: the page comes into sight, or a threshold was
  /// found.
  void readChoices();
  /// Takes the state that the page shows, and the newest field that may be shown with it. The fields are
  /// computed of the session's states beside the page, however seldom it asks.
  void follow(const session::NavigationState& state);
  /// Computes no field until the next follow(): the page is hidden.
  void rest();

  /// The field that may be shown with the last state; null: none.
  const steps::LiveField* shown() const { return shown_.get(); }
  std::optional<scene::FieldPicture> picture() const;
  /// "E at target 45 V/m (32 to 58), 97 % of the planned pose, 88 % of the threshold; ..", or why there is
  /// none; empty while off.
  QString words() const;
  /// "|E|, tier 1": name of the colour bar, whose unit is strengthUnit().
  QString barWords() const;
  QString strengthUnit() const;
  /// Factor from the field at 1 A/us to what is shown: the rate, or 1 where no rate is known.
  double factor() const;
  /// Number of fields computed so far.
  int computed() const { return worker_.computed(); }
  /// The output by field for the chosen target, as for Plan; empty: no motor threshold with its hotspot.
  QString doseInWords() const { return dose_words_; }

 signals:
  void changed();
  void doseChanged();

 private:
  void use();
  void followDose();
  std::optional<double> rate_A_per_us() const;
  QString rateWords() const;
  QString shareWords() const;
  QString missingWords() const;

  TreatPresenter& treat_;
  CaseModel& model_;
  bool is_on_ = false, is_paused_ = false, has_pose_ = false;
  QString coil_, dose_words_;
  steps::CurrentRate planned_rate_;
  std::shared_ptr<const surface::TriangleMesh> drawn_;
  std::optional<steps::HotspotThreshold> threshold_;
  std::shared_ptr<const steps::LiveField> shown_;
  std::optional<double> gap_mm_;
  steps::LiveFieldWorker worker_;
};

}  // namespace facenav::ui
