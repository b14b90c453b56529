#include "plan/fluid_presenter.h"

#include <sys/resource.h>

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/prepare/case_field.h"

namespace facenav::ui {
namespace {

constexpr int kFluidNiceness = 10;  // planning goes on meanwhile

/// False also for a damaged file: it is then built again.
bool hasFluid(const casefile::CaseStore& store) {
  try {
    return steps::hasField(store, steps::FieldTier::four_shells);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

FluidPresenter::FluidPresenter(CaseModel& model, QObject* parent) : QObject(parent), model_(model) {
  for (auto signal : {&CaseModel::opened, &CaseModel::brainChanged})
    connect(&model_, signal, this, &FluidPresenter::follow);
  connect(&runner_, &TaskRunner::progressed, this, [this](const QString& step, double fraction) {
    progress_ = tr("%1 %2 %").arg(step.section(": ", -1)).arg(std::lround(100 * fraction));
    emit changed();
  });
  connect(&runner_, &TaskRunner::failed, this, [this](const QString& words) {
    failure_ = words;
    emit changed();
    emit failed();
  });
  for (auto signal : {&TaskRunner::succeeded, &TaskRunner::cancelled})
    connect(&runner_, signal, this, &FluidPresenter::changed);
  if (model_.isOpen()) follow();
}

FluidPresenter::~FluidPresenter() { disconnect(&runner_, nullptr, this, nullptr); }

/// Learns what the open case has; a model under way belongs to the last one.
void FluidPresenter::follow() {
  ++subject_;
  runner_.cancel();
  failure_.clear();
  can_have_ = model_.isOpen() && steps::canHaveField(model_.current().store);
  is_present_ = can_have_ && hasFluid(model_.current().store);
  emit changed();
}

void FluidPresenter::build() {
  if (!isPossible() || isBuilding()) return;
  failure_.clear();
  progress_ = tr("begins");
  runner_.start(tr("Electric field with the fluid"),
                [this, subject = subject_,
                 store = model_.current().store](TaskMonitor& monitor) -> TaskRunner::Delivery {
                  ::setpriority(PRIO_PROCESS, 0, kFluidNiceness);
                  steps::buildField(store, monitor, steps::FieldTier::four_shells);
                  return [this, subject] {
                    if (subject != subject_) return;
                    is_present_ = true;
                    emit built();
                  };
                });
  emit changed();
}

QString FluidPresenter::words() const {
  if (isBuilding()) return tr("%1: stop").arg(progress_);
  if (is_present_) return tr("with the fluid: built");
  return tr("with the fluid (takes about %1 s)").arg(std::lround(steps::kFourShells_s));
}

}  // namespace facenav::ui
