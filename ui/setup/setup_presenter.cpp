#include "setup/setup_presenter.h"

#include <QSettings>
#include <QSize>

#include "facenav/cameras/board_page.h"
#include "facenav/core/error.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

using Step = steps::SetupStep;

const char* const kBoard = "setup/board";
const char* const kSquare = "setup/square_mm";

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

QSize sizeOf(const QString& text) {
  const auto parts = text.split("x");
  return {parts.value(0).toInt(), parts.value(1).toInt()};
}

}  // namespace

SetupPresenter::SetupPresenter(const Services& services, TaskRunner& tasks, QObject* parent)
    : QObject(parent), services_(services), tasks_(tasks) {
  const QSettings settings;
  size_ = settings.value("setup/size", sizes().first()).toString();
  const QSize corners = sizeOf(settings.value(kBoard, "9x6").toString());
  if (corners.width() >= 3 && corners.height() >= 3) {
    board_.columns = corners.width();
    board_.rows = corners.height();
  }
  board_.square_mm = settings.value(kSquare, 25.0).toDouble();
  name_ = tr("room 1");
}

SetupPresenter::~SetupPresenter() = default;

void SetupPresenter::begin(std::unique_ptr<capture::FrameSource> source,
                           std::optional<cameras::StereoRig> rig) {
  steps::SetupOptions options;
  options.board = board_;
  options.rig = std::move(rig);
  if (const auto* chosen = coil()) options.coil = chosen->model;
  step_ = Step::place;
  is_kept_ = false;
  kept_row_times_s_.reset();
  setup_ = std::make_shared<steps::RigSetup>(std::move(source), options, services_.makeSetupMethods());
  emit changed();
}

std::shared_ptr<const steps::SetupView> SetupPresenter::view() const {
  static const auto kNothing = std::make_shared<const steps::SetupView>();
  return setup_ ? setup_->latest() : kNothing;
}

bool SetupPresenter::canGo(Step step) const {
  if (!setup_) return false;
  return step == Step::place || step == Step::calibrate || setup_->rig().has_value();
}

void SetupPresenter::go(Step step) {
  if (!canGo(step)) return;
  step_ = step;
  setup_->go(step);
  emit changed();
}

QString SetupPresenter::sentence() const {
  if (!setup_) return choiceWords();
  const auto now = view();
  if (!now->frame && now->failure.empty()) return tr("waiting for the first picture");
  QString words = shownWords(now->sentence);
  if (now->step == Step::check && now->is_done && !is_kept_) words += tr(": keep it under a name");
  if (now->step == Step::coil && kept_row_times_s_ && setup_ && setup_->rowTimes_s() == kept_row_times_s_)
    words += tr("; kept with the pair");
  return words.replace("+-", QString::fromUtf8("\u00b1"));
}

void SetupPresenter::setBoard(int columns, int rows, double square_mm) {
  if (columns == board_.columns && rows == board_.rows && square_mm == board_.square_mm) return;
  board_.columns = columns;
  board_.rows = rows;
  board_.square_mm = square_mm;
  QSettings settings;
  settings.setValue(kBoard, QString("%1x%2").arg(columns).arg(rows));
  settings.setValue(kSquare, square_mm);
  if (setup_) setup_->useBoard(board_);
  emit changed();
}

void SetupPresenter::finishViews() {
  if (setup_) setup_->finishViews();
}

void SetupPresenter::takeMoreViews() {
  if (setup_) setup_->takeMoreViews();
}

void SetupPresenter::repeatViews() {
  if (!setup_) return;
  setup_->repeatViews();
  is_kept_ = false;
  opened_rig_.clear();
  go(Step::calibrate);
}

QString SetupPresenter::resultWords() const {
  const auto uncertainty = setup_ ? setup_->uncertainty() : std::nullopt;
  if (!uncertainty) return {};
  return tr("\u00b1%1 mm at %2 mm")
      .arg(uncertainty->point_mm, 0, 'f', 2)
      .arg(uncertainty->distance_mm, 0, 'f', 0);
}

bool SetupPresenter::printBoard(const QString& file) {
  try {
    cameras::writeBoardPage(board_, file.toStdString());
    return true;
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return false;
  }
}

void SetupPresenter::noteCheckOfKept() {
  const auto check = setup_ && !opened_rig_.isEmpty() && !is_kept_ ? setup_->verification() : std::nullopt;
  if (!check || check->state == health::RigState::unclear || !services_.noteRig) return;
  const std::string name = opened_rig_.toStdString();
  if (check->state == health::RigState::holds) is_kept_ = true;
  if (noted_ == check->words()) return;
  noted_ = check->words();
  try {
    services_.noteRig(name, {utcNow(), health::toString(check->state), check->words()});
    emit kept(opened_rig_);
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
}

bool SetupPresenter::isNameTaken() const {
  if (!services_.listRigs) return false;
  const auto rigs = services_.listRigs();
  return std::any_of(rigs.begin(), rigs.end(),
                     [&](const auto& entry) { return entry.name == name_.toStdString(); });
}

capture::NamedRig SetupPresenter::named() const {
  capture::NamedRig rig;
  rig.name = name_.trimmed().toStdString();
  rig.created_utc = utcNow();
  rig.left = left_camera_;
  rig.right = right_camera_;
  rig.rig = setup_->rig().value();
  rig.uncertainty = setup_->uncertainty();
  const auto check = setup_->verification().value();
  rig.last_check = {utcNow(), health::toString(check.state), check.words()};
  return rig;
}

bool SetupPresenter::keep(bool replaces) {
  const auto check = setup_ ? setup_->verification() : std::nullopt;
  if (!check || check->state != health::RigState::holds || !services_.keepRig) {
    emit refused(tr("the calibration is kept once its check holds"));
    return false;
  }
  try {
    services_.keepRig(named(), replaces ? Existing::replace : Existing::refuse);
  } catch (const Error& error) {
    faults_[SetupField::name] = shownWords(error);
    emit refused(shownWords(error));
    return false;
  }
  is_kept_ = true;
  emit changed();
  emit kept(name_.trimmed());
  return true;
}

QStringList SetupPresenter::coilNames() const {
  QStringList names;
  for (const auto& each : coils_) names << QString::fromStdString(each.name);
  return names;
}

const coil_library::LibraryCoil* SetupPresenter::coil() const {
  for (const auto& each : coils_)
    if (each.name == coil_name_.toStdString()) return &each;
  return nullptr;
}

void SetupPresenter::chooseCoil(const QString& name) {
  coils_.clear();
  for (auto& each : coil_library::coilsIn(coil_library::coilLibrary()))
    if (each.problem.empty()) coils_.push_back(std::move(each));
  coil_name_ = name;
  if (const auto* chosen = coil(); chosen && setup_) setup_->useCoil(chosen->model);
  emit changed();
}

void SetupPresenter::startPivots() {
  if (setup_) setup_->startPivots();
}

void SetupPresenter::startJig(const QString& file) {
  try {
    const auto jig = coil_tracking::readCoil(file.toStdString());
    if (setup_) setup_->startJig(jig);
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
}

void SetupPresenter::startWave() {
  if (setup_) setup_->startWave();
}

void SetupPresenter::keepRowTimes() {
  const auto times = setup_ ? setup_->rowTimes_s() : std::nullopt;
  if (!times || times == kept_row_times_s_ || !services_.keepLearnt) return;
  const QString name = is_kept_ ? name_.trimmed() : opened_rig_;
  if (name.isEmpty()) return;
  kept_row_times_s_ = times;
  steps::CamerasLearnt learnt;
  learnt.row_times_s = times;
  services_.keepLearnt(name.toStdString(), learnt);
}

bool SetupPresenter::keepCoil() {
  const auto calibration = setup_ ? setup_->coilCalibration() : std::nullopt;
  const auto* chosen = coil();
  if (!calibration || !chosen) {
    emit refused(!calibration ? tr("the coil is not calibrated yet")
                              : tr("choose the coil from the library first (facenav coil add)"));
    return false;
  }
  try {
    auto dated = *calibration;
    dated.utc = utcNow();
    coil_tracking::writeCalibratedCoil(chosen->model, dated, chosen->file, chosen->file);
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return false;
  }
  chooseCoil(coil_name_);
  return true;
}

void SetupPresenter::close() {
  if (setup_)
    retirement_.add([old = std::move(setup_)]() mutable { old.reset(); }, std::chrono::milliseconds(300));
  setup_.reset();
  emit changed();
}

}  // namespace facenav::ui
