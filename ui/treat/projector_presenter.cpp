#include "treat/projector_presenter.h"

#include <QFileInfo>
#include <QSettings>

#include "facenav/core/error.h"
#include "facenav/pictures/projected_guide.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

const char* const kProjectorFile = "treat/projector";

/// Draws the guide on the worker's thread. Making the guide takes a moment, so the first picture makes it.
struct GuideDrawer {
  cameras::ProjectorModel projector;
  std::shared_ptr<const surface::ScalpSurface> scalp;
  guidance::CoilPlate plate;
  std::optional<pictures::ProjectedGuide> guide = {};

  pictures::CameraOverlay draw(const pictures::OverlayOrder& order) {
    if (!guide) guide.emplace(projector, scalp->mesh, plate);
    const auto& state = *order.state;
    const auto pose = state.camera_T_mri ? std::optional(*state.camera_T_mri) : std::nullopt;
    if (!order.target) return {guide->black(), {}};
    return {guide->draw(pose, *order.target, state.guidance), {}};
  }
};

}  // namespace

ProjectorPresenter::ProjectorPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent)
    : QObject(parent), treat_(treat), model_(model) {
  connect(&model_, &CaseModel::opened, this, &ProjectorPresenter::begin);
}

ProjectorPresenter::~ProjectorPresenter() = default;

QString ProjectorPresenter::knownFile() const {
  const QString beside = treat_.recordingFolder() + "/projector.yml";
  if (!treat_.recordingFolder().isEmpty() && QFileInfo::exists(beside)) return beside;
  const QString last = QSettings().value(kProjectorFile).toString();
  return QFileInfo::exists(last) ? last : QString();
}

bool ProjectorPresenter::open(const QString& file) {
  try {
    projector_ = cameras::readProjector(file.toStdString());
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return false;
  }
  QSettings().setValue(kProjectorFile, file);
  begin();
  return true;
}

void ProjectorPresenter::close() {
  worker_.reset();
  projector_.reset();
  emit changed();
}

QSize ProjectorPresenter::size() const {
  return projector_ ? QSize(projector_->width_px, projector_->height_px) : QSize();
}

void ProjectorPresenter::begin() {
  worker_.reset();
  if (projector_ && model_.isOpen()) {
    auto drawer = std::make_shared<GuideDrawer>(
        GuideDrawer{*projector_, model_.current().scalp, model_.current().coil.plate});
    worker_ = std::make_unique<pictures::OverlayWorker>(
        [this](std::shared_ptr<const pictures::DrawnOverlay> picture) {
          QMetaObject::invokeMethod(
              this, [this, picture] { emit drawn(picture); }, Qt::QueuedConnection);
        },
        [drawer](const pictures::OverlayOrder& order) { return drawer->draw(order); });
  }
  emit changed();
}

void ProjectorPresenter::ask(std::shared_ptr<const session::NavigationState> state) {
  if (!worker_ || !state->camera_T_mri) return;  // the screen is then black
  const auto* target = treat_.target();
  worker_->ask({{}, std::move(state), target ? std::optional(*target) : std::nullopt, {}});
}

}  // namespace facenav::ui
