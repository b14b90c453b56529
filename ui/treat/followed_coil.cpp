#include "treat/followed_coil.h"

#include <QSettings>

#include "facenav/coil_library/coil_library.h"
#include "facenav/plan/expert_pose.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

const char* const kCoil = "treat/coil";

}  // namespace

FollowedCoil::FollowedCoil()
    : model_(coil_tracking::defaultCoil()), card_{model_.name, {},          {}, {}, Eigen::Vector3d::Zero(),
                                                  false,       std::nullopt} {}

void FollowedCoil::useFilm(const steps::TreatmentFilm& film) {
  film_ = film;
  model_ = film.coil;
  card_ = film.card;
}

void FollowedCoil::useRemembered() {
  film_.reset();
  const auto name = QSettings().value(kCoil).toString().toStdString();
  for (const auto& coil : coil_library::coilsIn(coil_library::coilLibrary())) {
    if (coil.name != name || !coil.problem.empty()) continue;
    model_ = coil.model;
    card_ = coil.card;
  }
}

QStringList FollowedCoil::names() const {
  QStringList names{film_ ? QString::fromStdString(film_->coil.name) : name()};
  for (const auto& coil : coil_library::coilsIn(coil_library::coilLibrary()))
    if (coil.problem.empty()) names << QString::fromStdString(coil.name);
  names.removeDuplicates();
  return names;
}

void FollowedCoil::choose(const QString& wanted,
                          const std::function<void(const coil_tracking::CoilModel&)>& use) {
  auto model = model_;
  auto card = card_;
  if (film_ && QString::fromStdString(film_->coil.name) == wanted) {
    model = film_->coil, card = film_->card;
  } else if (wanted != name()) {
    const auto found = coil_library::findCoil(coil_library::coilLibrary(), wanted.toStdString());
    model = found.model, card = found.card;
    QSettings().setValue(kCoil, wanted);
  }
  use(model);
  model_ = model;
  card_ = card;
}

void FollowedCoil::noteIn(steps::TreatmentRequest& request) const {
  request.coil_reminder = coil_library::calibrationReminder(card_);
  request.focus_caution = coil_library::focusCaution(card_);
}

QString FollowedCoil::reminder(const guidance::Target* target) const {
  if (target)
    if (const auto caution = steps::otherCoilCaution(*target, model_.name)) return shownWords(*caution);
  QStringList words;
  for (const auto& reminder : {coil_library::focusCaution(card_), coil_library::calibrationReminder(card_)})
    if (reminder) words << shownWords(*reminder);
  return words.join("; ");
}

}  // namespace facenav::ui
