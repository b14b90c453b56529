#include "review/field_map_presenter.h"

#include <utility>

#include "facenav/efield/coil_file.h"
#include "plan/field_presenter.h"
#include "shell/shown_words.h"

namespace facenav::ui {

FieldMapPresenter::FieldMapPresenter(ReviewPresenter& review, CaseModel& model, QObject* parent)
    : QObject(parent), review_(review), model_(model) {
  connect(&review_, &ReviewPresenter::sessionChanged, this, &FieldMapPresenter::follow);
  for (const auto ended : {&TaskRunner::succeeded, &TaskRunner::cancelled})
    connect(&runner_, ended, this, &FieldMapPresenter::compute);
  connect(&runner_, &TaskRunner::failed, this, [this](const QString& words) {
    failure_ = words;
    emit changed();
    compute();
  });
}

void FieldMapPresenter::setOn(bool is_on) {
  if (std::exchange(is_on_, is_on) == is_on) return;
  wanted_.reset();
  follow();
}

/// Drops the map if it is no longer that of the session, and computes the new one.
void FieldMapPresenter::follow() {
  const auto session = is_on_ ? review_.session() : nullptr;
  if (session == wanted_ && (is_on_ || !shown_)) return emit changed();
  wanted_ = session;
  shown_.reset();
  failure_.clear();
  runner_.cancel();
  emit changed();
  compute();
}

void FieldMapPresenter::compute() {
  if (!wanted_ || !wanted_->brain || shown_ || !failure_.isEmpty() || runner_.isRunning()) return;
  runner_.start(tr("MEPs by field"),
                [this, session = wanted_, coil = rememberedFieldCoil().toStdString(),
                 store = model_.current().store](TaskMonitor& monitor) -> TaskRunner::Delivery {
                  const steps::PoseFields fields(std::make_shared<const steps::ReadHead>(store),
                                                 efield::fieldCoil(coil).dipoles);
                  monitor.report("MEPs by field", 0.3);
                  auto made = std::make_shared<Shown>();
                  made->session = session;
                  made->coil = coil;
                  made->map = steps::mepByField(fields, session->kept.pulses);
                  monitor.report("MEPs by field", 0.9);
                  made->r2 = steps::r2On(session->brain->mesh, fields, made->map);
                  return [this, session, made = std::shared_ptr<const Shown>(made)] {
                    if (session != wanted_) return;  // succeeded() begins the newest wish
                    shown_ = made;
                    emit changed();
                  };
                });
}

QString FieldMapPresenter::words() const {
  if (!is_on_ || !review_.session()) return {};
  if (!review_.session()->brain) return tr("the case has no brain, so its field is not known");
  if (!failure_.isEmpty()) return failure_;
  if (!shown_) return tr("computing the fields of the pulses \u2026");
  QStringList lines;
  for (const auto& line : steps::inWords(shown_->map, shown_->coil)) lines << shownWords(line);
  return lines.join("; ");
}

}  // namespace facenav::ui
