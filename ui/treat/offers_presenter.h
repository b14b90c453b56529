#pragma once
// OffersPresenter: the targets that clients of the OpenIGTLink server offer (treat/live_orders.h): a person
// looks at one, takes it into the plan, or refuses it. Nothing here chooses a target.

#include <QObject>
#include <functional>
#include <vector>

#include "facenav/treat/live_orders.h"
#include "shell/case_model.h"

namespace facenav::ui {

/// A target that can be taken.
struct OfferedPose {
  QString name, words;  // "from 127.0.0.1:50112, at -37.5 -11.9 57.6 (RAS, mm)"
  RigidTransform<Mri, Coil> mri_T_coil;
};

class OffersPresenter : public QObject {
  Q_OBJECT

 public:
  /// Stores a plan whose target of this name was taken. Throws Error, and keeps the old plan.
  using KeepPlan = std::function<void(const guidance::TreatmentPlan&, const QString& taken)>;

  explicit OffersPresenter(CaseModel& model, QObject* parent = nullptr);

  /// Has plans stored by `keep`, as a step that can be undone; else they go into the case.
  void keepBy(KeepPlan keep) { keep_ = std::move(keep); }
  /// The offers that can be taken, by name.
  std::vector<OfferedPose> all() const;
  void take(const QString& name);
  /// Puts an offer away; it returns only with another pose.
  void refuse(const QString& name);
  /// Asks for the page that shows the offer in the head.
  void show(const QString& name) { emit shown(name); }
  /// True while a target is taken: the plan changes, the chosen target stays.
  bool isTaking() const { return is_taking_; }

  /// The server hands orders over here. Who obeys them calls tellNews() afterwards.
  steps::LiveOrders& orders() { return orders_; }
  void tellNews() { emit changed(); }
  /// Forgets all offers: another case was opened.
  void forget();

 signals:
  void changed();
  void shown(const QString& name);
  void refused(const QString& words);
  /// A person took or refused an offer; for the log.
  void decided(const QString& event, const QString& words);

 private:
  CaseModel& model_;
  steps::LiveOrders orders_;
  KeepPlan keep_;
  bool is_taking_ = false;
};

}  // namespace facenav::ui
