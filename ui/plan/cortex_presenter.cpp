#include "plan/cortex_presenter.h"

#include <algorithm>
#include <cmath>

#include "facenav/prepare/brain_surfaces.h"

namespace facenav::ui {
namespace {

const char* const kPeel = "plan/peel_mm";
const char* const kLook = "plan/look";
constexpr int kBesideCortex = 3;  // index after the three looks

}  // namespace

CortexPresenter::CortexPresenter(CaseModel& model, QObject* parent) : QObject(parent), model_(model) {
  peel_mm_ = std::clamp(settings_.value(kPeel, peel_mm_).toDouble(), 0.0, double(scene::kMostPeel_mm));
  for (auto signal : {&CaseModel::opened, &CaseModel::brainChanged})
    connect(&model_, signal, this, &CortexPresenter::forget);
  connect(&runner_, &TaskRunner::progressed, this, [this](const QString&, double fraction) {
    percent_ = int(std::lround(100 * fraction));
    emit changed();
  });
  connect(&runner_, &TaskRunner::failed, this, [this](const QString& words) {
    failure_ = words;
    emit changed();
  });
  connect(&runner_, &TaskRunner::cancelled, this, &CortexPresenter::make);  // another brain was set meanwhile
}

bool CortexPresenter::isPossible() const {
  return model_.isOpen() && model_.current().brain && model_.current().brain_mask;
}

void CortexPresenter::forget() {
  ++subject_;
  cortex_.reset();
  failure_.clear();
  emit cortexChanged();
  emit changed();
  runner_.cancel();
  make();
}

void CortexPresenter::setLook(scene::BrainLook look) { choose(look, false); }

void CortexPresenter::setBesideModel() { choose(scene::BrainLook::distance, true); }

void CortexPresenter::restoreLook() {
  const int last = std::clamp(settings_.value(kLook, 0).toInt(), 0, kBesideCortex);
  last == kBesideCortex ? setBesideModel() : setLook(scene::BrainLook(last));
}

void CortexPresenter::choose(scene::BrainLook look, bool is_beside_model) {
  look_ = look;
  is_beside_model_ = is_beside_model;
  settings_.setValue(kLook, is_beside_model ? kBesideCortex : int(look));
  failure_.clear();
  make();
  emit changed();
}

void CortexPresenter::setPeel_mm(double peel_mm) {
  peel_mm_ = std::clamp(peel_mm, 0.0, double(scene::kMostPeel_mm));
  settings_.setValue(kPeel, peel_mm_);
  emit changed();
}

/// Takes the cortex from the case if it is stored there, else computes it.
void CortexPresenter::make() {
  const bool is_wanted = look_ != scene::BrainLook::model && !cortex_ && failure_.isEmpty();
  if (!is_wanted || !isPossible() || runner_.isRunning()) return;
  const auto& c = model_.current();
  percent_ = 0;
  runner_.start(tr("Making the cortex"),
                [this, subject = subject_, mri = c.mri, mask = c.brain_mask,
                 store = c.store](TaskMonitor& monitor) -> TaskRunner::Delivery {
                  auto cortex = store.cortex();
                  if (!cortex) cortex = steps::buildBrainSurfaces(*mri, *mask, monitor).cortex;
                  auto made = std::make_shared<scene::CortexPicture>(
                      scene::makeCortexPicture(*mri, *mask, std::move(*cortex), monitor));
                  return [this, subject, made] {
                    if (subject == subject_) cortex_ = made;  // otherwise it is another brain's
                    emit cortexChanged();
                    emit changed();
                    QMetaObject::invokeMethod(
                        this, [this] { make(); }, Qt::QueuedConnection);
                  };
                });
}

QString CortexPresenter::words() const {
  if (look_ == scene::BrainLook::model) return {};
  if (!isPossible()) return tr("no brain model in this case");
  if (!failure_.isEmpty()) return failure_;
  if (!cortex_) return tr("making the cortex %1 %").arg(percent_);
  if (look_ == scene::BrainLook::cortex) return {};
  return tr("median %1 mm, 95 % within %2 mm")
      .arg(cortex_->distance.median_mm, 0, 'f', 1)
      .arg(cortex_->distance.p95_mm, 0, 'f', 1);
}

}  // namespace facenav::ui
