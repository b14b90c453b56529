#include "plan/overlay_presenter.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "shell/shown_words.h"

namespace facenav::ui {

OverlayPresenter::OverlayPresenter(CaseModel& model, QObject* parent) : QObject(parent), model_(model) {
  connect(&model_, &CaseModel::opened, this, [this] {
    ++subject_;
    entries_.clear();
    loaded_.clear();
    emit changed();
    runner_.cancel();
    load();
  });
  connect(&runner_, &TaskRunner::cancelled, this,
          &OverlayPresenter::load);  // another case was opened meanwhile
  connect(&runner_, &TaskRunner::failed, this, [this](const QString& words) {
    emit changed();
    emit refused(words);
  });
}

/// Loads all overlays of the case; names one that cannot be read, and shows the others.
void OverlayPresenter::load() {
  if (!model_.isOpen() || runner_.isRunning() ||
      !std::filesystem::exists(model_.current().store.folder() / "overlays.json"))
    return;
  const auto& current = model_.current();
  runner_.start(tr("Reading the overlays"),
                [this, subject = subject_, store = current.store, mri = current.mri](TaskMonitor&) {
                  auto entries = casefile::readOverlays(store.folder());
                  std::vector<scene::Overlay> loaded;
                  QString fault_words;
                  for (const auto& entry : entries) try {
                      loaded.push_back(steps::loadOverlay(store, entry, mri->grid));
                    } catch (const Error& fault) {
                      fault_words = shownWords(fault);
                    }
                  return TaskRunner::Delivery([this, subject, entries, loaded, fault_words] {
                    if (subject != subject_) return;
                    if (!fault_words.isEmpty()) emit refused(fault_words);
                    entries_ = entries;
                    loaded_ = loaded;
                    emit changed();
                  });
                });
}

const casefile::OverlayEntry* OverlayPresenter::find(const QString& name) const {
  for (const auto& entry : entries_)
    if (QString::fromStdString(entry.name) == name) return &entry;
  return nullptr;
}

/// Drops what was loaded under a name: another file may get the same name later.
void OverlayPresenter::forget(const QString& name) {
  const auto is_it = [&](const scene::Overlay& overlay) {
    return QString::fromStdString(overlay.name) == name;
  };
  loaded_.erase(std::remove_if(loaded_.begin(), loaded_.end(), is_it), loaded_.end());
}

std::vector<scene::Overlay> OverlayPresenter::shown() const {
  std::vector<scene::Overlay> all;
  for (const auto& overlay : loaded_) {
    const auto* entry = find(QString::fromStdString(overlay.name));
    if (!entry || !entry->is_shown) continue;
    all.push_back(overlay);
    all.back().opacity = entry->opacity;
    all.back().threshold = entry->threshold;
    all.back().full = entry->full;
  }
  return all;
}

void OverlayPresenter::add(const QString& file, std::optional<casefile::OverlaySpace> space,
                           const QString& name) {
  if (!model_.isOpen()) return;
  const auto& current = model_.current();
  steps::NewOverlay wanted;
  wanted.file = file.toStdString();
  wanted.space = space;
  wanted.name = name.trimmed().toStdString();
  const bool has_begun = runner_.start(
      tr("Adding an overlay"),
      [this, subject = subject_, store = current.store, mri = current.mri, wanted](TaskMonitor&) {
        const auto entry = steps::addOverlay(store, wanted);
        const auto overlay = steps::loadOverlay(store, entry, mri->grid);
        return TaskRunner::Delivery([this, subject, entry, overlay] {
          if (subject != subject_) return;  // another case was opened; this overlay belongs to `subject`
          forget(QString::fromStdString(entry.name));
          entries_.push_back(entry);
          loaded_.push_back(overlay);
          emit changed();
        });
      });
  has_begun ? emit changed() : emit refused(tr("an overlay is being read; wait a moment"));
}

void OverlayPresenter::remove(const QString& name) {
  if (!model_.isOpen() || !find(name)) return;
  try {
    steps::removeOverlay(model_.current().store, name.toStdString());
    entries_ = casefile::readOverlays(model_.current().store.folder());
    forget(name);
  } catch (const std::exception& fault) {
    emit refused(shownWords(fault));
  }
  emit changed();
}

void OverlayPresenter::change(const casefile::OverlayEntry& entry) {
  if (!model_.isOpen()) return;
  try {
    casefile::requireSensible(entry);
    steps::changeOverlay(model_.current().store, entry);
    for (auto& known : entries_)
      if (known.name == entry.name) known = entry;
  } catch (const std::exception& fault) {
    emit refused(shownWords(fault));
  }
  emit changed();
}

QString OverlayPresenter::describe(const casefile::OverlayEntry& entry) const {
  const QString kinds[] = {tr("map"), tr("mask"), tr("tracts"), tr("surface")};
  const QString space = entry.space == casefile::OverlaySpace::mni ? tr("MNI") : tr("this MRI");
  if (entry.kind != casefile::OverlayKind::map) return kinds[int(entry.kind)] + ", " + space;
  return tr("map, %1, from \u00b1%2 to \u00b1%3 %4")
      .arg(space)
      .arg(entry.threshold, 0, 'g', 3)
      .arg(entry.full, 0, 'g', 3)
      .arg(QString::fromStdString(entry.unit))
      .trimmed();
}

}  // namespace facenav::ui
