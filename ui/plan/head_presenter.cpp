#include "plan/head_presenter.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/plan/case_landmarks.h"
#include "shell/author.h"
#include "shell/shown_words.h"

namespace facenav::ui {

QString landmarkWords(surface::Landmark which) {
  switch (which) {
    case surface::Landmark::nasion:
      return HeadPresenter::tr("nasion");
    case surface::Landmark::inion:
      return HeadPresenter::tr("inion");
    case surface::Landmark::tragus_left:
      return HeadPresenter::tr("left tragus");
    case surface::Landmark::tragus_right:
      return HeadPresenter::tr("right tragus");
  }
  return {};
}

HeadPresenter::HeadPresenter(CaseModel& model, QObject* parent) : QObject(parent), model_(model) {
  connect(&model_, &CaseModel::opened, this, [this] {
    measures_.reset();
    emit changed();
  });
}

template <class Step>
void HeadPresenter::attempt(Step step) {
  if (!model_.isOpen()) return;
  try {
    step();
  } catch (const std::exception& error) {  // includes errors of the file system
    emit refused(shownWords(error));
  }
}

const steps::HeadMeasures* HeadPresenter::measures() {
  if (!measures_)
    attempt([this] {
      const auto& current = model_.current();
      measures_.emplace(current.scalp, steps::landmarksOf(current.store, *current.scalp));
    });
  return measures_ ? &*measures_ : nullptr;
}

void HeadPresenter::setLandmark(surface::Landmark which, const Point<Mri>& p) {
  attempt([&] {
    const auto& current = model_.current();
    measures_.emplace(current.scalp,
                      steps::setLandmark(current.store, *current.scalp, which, p, recordedAuthor()));
    emit changed();
  });
}

void HeadPresenter::findAgain(surface::Landmark which) {
  attempt([&] {
    const auto& current = model_.current();
    measures_.emplace(current.scalp, steps::findLandmarkAgain(current.store, *current.scalp, which));
    emit changed();
  });
}

QString HeadPresenter::describe() {
  const auto* all = measures();
  if (!all) return {};
  QStringList lines;
  for (const auto which : surface::kLandmarks) {
    const auto& landmark = all->landmarks()[which];
    if (!landmark) {
      lines << tr("%1: not found, set it").arg(landmarkWords(which));
      continue;
    }
    const QString from = landmark->source == surface::LandmarkSource::skin    ? tr("found")
                         : landmark->source == surface::LandmarkSource::atlas ? tr("by the atlas")
                                                                              : tr("by hand");
    lines << tr("%1: %2, \u00b1 %3 mm%4")
                 .arg(landmarkWords(which), from)
                 .arg(std::lround(landmark->sd_mm))
                 .arg(landmark->is_cut ? tr(", at the scan's edge") : QString());
  }
  return lines.join('\n');
}

std::optional<Point<Mri>> HeadPresenter::site(const QString& name) {
  std::optional<Point<Mri>> place;
  const auto* all = measures();
  if (all)
    attempt([&] {
      if (name == "Beam F3" || name == "Beam F4")
        place = all->beamF3(name == "Beam F3" ? guidance::Side::left : guidance::Side::right).point;
      else
        place = all->eegSites().find(name.toStdString()).point;
    });
  return place;
}

std::vector<guidance::EegSite> HeadPresenter::sites() {
  std::vector<guidance::EegSite> all;
  if (const auto* head = measures()) attempt([&] { all = head->eegSites().sites; });
  return all;
}

}  // namespace facenav::ui
