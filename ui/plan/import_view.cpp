#include "plan/import_view.h"

#include <QVBoxLayout>

#include "plan/other_words.h"
#include "shell/appearance.h"

namespace facenav::ui {
namespace {

constexpr double kPick_mm = 25;  // a coil over thick hair lies so far from the skin under the mouse
constexpr int kMostNames = 40;   // more would cover the head

bool isOfRow(const ImportRow& row, int file, int item, const steps::PreviewedItem& previewed) {
  const auto& of = previewed.item;
  if (row.file != file) return false;
  if (row.item >= 0) return row.item == item;
  if (!row.reason.isEmpty())
    return previewed.fate == steps::ItemFate::refused && previewed.reason == row.reason.toStdString();
  return !row.is_session || (of.kind == interop::Kind::pulse && of.session == row.name.toStdString());
}

}  // namespace

ImportView::ImportView(ImportPresenter& presenter, CaseModel& model, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      model_(model),
      view_(new SceneView(this)),
      coils_(std::make_unique<scene::PulseLayer>(view_->scene())),
      names_(std::make_unique<scene::SiteLayer>(view_->scene())) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(view_);
  view_->setAccessibleName(tr("the head with the coils of the files"));
  connect(&presenter_, &ImportPresenter::changed, this, &ImportView::draw);
  connect(view_, &SceneView::picked, this, [this](double x, double y, double z) { pickNear({x, y, z}); });
  connect(&TextScaleNotice::instance(), &TextScaleNotice::changed, this, &ImportView::draw);
}

ImportView::~ImportView() = default;

void ImportView::setChosen(const ImportRow& row) {
  const bool is_other = !(row == chosen_);
  chosen_ = row;
  draw();
  if (is_other) showChosen();
}

/// Turns the head so that the chosen coil is in front.
void ImportView::showChosen() {
  if (!has_case_) return;
  view_->scene().setView(scene::ViewPreset::target);
  view_->refresh();
}

void ImportView::draw() {
  if (!has_case_ || presenter_.isReading()) return;
  std::vector<scene::PulseMark> marks;
  std::vector<scene::ScalpSite> names;
  std::vector<guidance::Target> targets;
  const auto& files = presenter_.files();
  for (int file = 0; file < int(files.size()); ++file)
    for (int i = 0; i < int(files[std::size_t(file)].preview.items.size()); ++i) {
      const auto& previewed = files[std::size_t(file)].preview.items[std::size_t(i)];
      const auto& [item, fate, reason] = previewed;
      const auto place = importedPlace(item);
      if (!place) continue;
      const bool is_chosen = isOfRow(chosen_, file, i, previewed);
      const bool stays_out = fate == steps::ItemFate::refused || fate == steps::ItemFate::left_out;
      if (item.kind != interop::Kind::pulse) names.push_back({item.name, *place});
      if (!item.mri_T_coil) continue;
      marks.push_back({*item.mri_T_coil, {}, scene::palette::kBlue, stays_out, is_chosen});
      if (is_chosen && targets.empty()) targets.push_back(shownTarget("chosen", *item.mri_T_coil));
    }
  coils_->set(marks);
  if (names.size() > kMostNames) names.clear();
  names_->set(names, sized(100) / 100.0);
  view_->scene().setTargets(targets, targets.empty() ? "" : targets.front().name);
  view_->scene().setCoilGhost(targets.empty() ? std::nullopt : std::optional(targets.front().mri_T_target));
  view_->refresh();
}

void ImportView::pickNear(const Point<Mri>& point) {
  const auto& files = presenter_.files();
  double nearest_mm = kPick_mm;
  ImportRow nearest;
  for (int file = 0; file < int(files.size()); ++file)
    for (int i = 0; i < int(files[std::size_t(file)].preview.items.size()); ++i) {
      const auto& item = files[std::size_t(file)].preview.items[std::size_t(i)].item;
      const auto place = importedPlace(item);
      if (!place || (place->mm - point.mm).norm() >= nearest_mm) continue;
      nearest_mm = (place->mm - point.mm).norm();
      nearest = {file, i, false, QString::fromStdString(item.name)};
    }
  if (nearest.file >= 0) emit picked(nearest);
}

void ImportView::showEvent(QShowEvent*) {
  if (has_case_ || !model_.isOpen()) return;
  has_case_ = true;
  view_->show(model_.current());
  draw();
  showChosen();
}

}  // namespace facenav::ui
