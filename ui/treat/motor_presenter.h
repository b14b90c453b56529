#pragma once
// MotorPresenter: the motor hotspot and threshold as the Treat page shows them: a hunting grid of sites, one
// answer of the muscle a pulse, the search for the threshold (treat/motor_threshold.h, hotspot.h).

#include <QObject>

#include "facenav/treat/hotspot.h"
#include "facenav/treat/motor_threshold.h"
#include "treat/treat_presenter.h"

namespace facenav::ui {

class MotorPresenter : public QObject {
  Q_OBJECT

 public:
  MotorPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent = nullptr);

  /// Stores the muscle's answer with the newest pulse, one a pulse; a running search uses it, with that
  /// pulse's intensity, if the pulse was given after the search began.
  void answer(bool has_response);
  void answerWithMep(double mep_uv);
  /// True if a pulse waits for its answer.
  bool canAnswer() const { return treat_.openPulse().has_value(); }
  /// Asks for the newest pulse by its number: "pulse 12: did the muscle move?", or what to do.
  QString question() const;

  /// Continues an unfinished search of the case, or begins one. The intensity becomes its next one.
  void search(stimulation::ThresholdMethod method, const QString& muscle);
  void endSearch();
  /// Withdraws the last answer; its pulse can be answered again.
  void takeBack();
  /// True if there is an answer to withdraw.
  bool canTakeBack() const { return answered_ > 0 || (search_ && search_->state().pulses > 0); }
  bool isSearching() const { return search_ != nullptr; }
  /// State of the search; null if none runs.
  const stimulation::ThresholdState* state() const { return search_ ? &search_->state() : nullptr; }
  /// "52.3 % (95 % interval ..), bayes, 9 responses of 18 pulses; set the output to 52 %", or what to do.
  QString thresholdWords() const;

  /// Sets what the dose by field says of the chosen target; empty: nothing (live_field_presenter.h).
  void setDose(const QString& words);
  QString doseWords() const { return dose_; }

  /// Makes sites around the chosen target, its own site first, and guides to it.
  void hunt();
  void endHunt();
  /// Guides to the next site, or back by one.
  void nextSite(int step = 1);
  bool isHunting() const { return !sites_.empty(); }
  /// "site 3 of 25: M1 hand L 2/3"; empty without a hunt.
  QString siteWords() const;

 signals:
  void changed();
  /// A search ended with a threshold.
  void found();
  void refused(const QString& words);

 private:
  template <class Keep>
  void take(const session::AddedPulse& pulse, Keep keep);
  void showIntensity();

  TreatPresenter& treat_;
  CaseModel& model_;
  std::unique_ptr<steps::MotorThreshold> search_;
  int answered_ = 0;           // number of the pulse answered last in this session; 0: none
  int before_search_ = 0;      // number of the newest pulse when the search began
  bool was_searched_ = false;  // the search uses the last answer
  QString dose_;
  std::vector<guidance::Target> sites_;
  std::size_t site_ = 0;
};

}  // namespace facenav::ui
