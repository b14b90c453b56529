#include "plan/overlays_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "shell/appearance.h"

namespace facenav::ui {

OverlaysPanel::OverlaysPanel(OverlayPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter) {
  auto* column = new QVBoxLayout(this);
  list_ = new QListWidget(this);
  list_->setAccessibleName(tr("overlays"));
  whenTextScales(this, [this] {
    list_->setMinimumSize(sized(280), sized(90));
    list_->setMaximumHeight(sized(130));
  });
  list_->setToolTip(tr("what is shown over the MRI; the mark shows and hides it"));
  words_ = new QLabel(this);
  words_->setObjectName("muted");
  words_->setWordWrap(true);
  column->addWidget(list_);
  column->addWidget(words_);
  makeFields();
  connect(list_, &QListWidget::currentRowChanged, this, [this] {
    if (!is_filling_) showChosen();
  });
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    const auto* entry = presenter_.find(item->data(Qt::UserRole).toString());
    if (is_filling_ || !entry) return;
    auto changed = *entry;
    changed.is_shown = item->checkState() == Qt::Checked;
    presenter_.change(changed);
  });
  connect(&presenter_, &OverlayPresenter::changed, this, &OverlaysPanel::showEntries);
  showEntries();
}

void OverlaysPanel::makeFields() {
  auto* form = new QFormLayout;
  opacity_ = new QSlider(Qt::Horizontal, this);
  opacity_->setRange(0, 100);
  opacity_->setToolTip(tr("opacity, 0 to 100 %"));
  opacity_->setAccessibleName(tr("opacity"));
  form->addRow(tr("opacity"), opacity_);
  const auto number = [&](const QString& words, const QString& tip) {
    auto* field = new QDoubleSpinBox(this);
    field->setRange(0, 1e6);
    field->setDecimals(3);
    field->setKeyboardTracking(false);
    field->setToolTip(tip);
    form->addRow(words, field);
    connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &OverlaysPanel::changeChosen);
    return field;
  };
  threshold_ = number(tr("threshold"), tr("values of this size or more are shown, of both signs"));
  full_ = number(tr("colours end at"), tr("the size at which the colours are brightest"));
  unit_ = new QLineEdit(this);
  unit_->setToolTip(tr("unit of the map's values: z, t, V/m (Return)"));
  form->addRow(tr("unit"), unit_);
  static_cast<QVBoxLayout*>(layout())->addLayout(form);
  auto* row = new QHBoxLayout;
  space_ = new QComboBox(this);
  space_->setAccessibleName(tr("space of the next file"));
  space_->addItems({tr("as the file says"), tr("this MRI"), tr("MNI")});
  space_->setToolTip(tr("the space of the next file: this MRI, or MNI (through the case's atlas)"));
  add_ = new QPushButton(tr("Add a file \u2026"), this);
  add_->setToolTip(
      tr("NIfTI map or mask, tracts (.trk .tck .trx .vtk), surface (.ply .stl .obj .vtk .vtp); the "
         "case keeps a copy"));
  remove_ = new QPushButton(tr("Remove"), this);
  remove_->setToolTip(tr("remove the chosen overlay and the case's copy of its file"));
  row->addWidget(space_, 1);
  row->addWidget(add_);
  row->addWidget(remove_);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  connect(opacity_, &QSlider::valueChanged, this, [this] {
    if (!opacity_->isSliderDown()) changeChosen();
  });
  connect(opacity_, &QSlider::sliderReleased, this, &OverlaysPanel::changeChosen);
  connect(unit_, &QLineEdit::editingFinished, this, &OverlaysPanel::changeChosen);
  connect(add_, &QPushButton::clicked, this, &OverlaysPanel::choose);
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (auto* item = list_->currentItem()) presenter_.remove(item->data(Qt::UserRole).toString());
  });
}

void OverlaysPanel::choose() {
  emit choosing();
  const QString file =
      QFileDialog::getOpenFileName(window(), tr("A map, mask, tracts or surface"), {},
                                   tr("Overlays (*.nii *.nii.gz *.hdr *.img *.trk *.tck *.trx *.ply *.stl "
                                      "*.obj *.vtk *.vtp);;All files (*)"));
  if (file.isEmpty()) return;
  const std::optional<casefile::OverlaySpace> spaces[] = {std::nullopt, casefile::OverlaySpace::native,
                                                          casefile::OverlaySpace::mni};
  presenter_.add(file, spaces[space_->currentIndex()], {});
}

void OverlaysPanel::showEntries() {
  is_filling_ = true;
  const QString chosen =
      list_->currentItem() ? list_->currentItem()->data(Qt::UserRole).toString() : QString();
  list_->clear();
  for (const auto& entry : presenter_.entries()) {
    auto* item = new QListWidgetItem(QString::fromStdString(entry.name), list_);
    item->setData(Qt::UserRole, item->text());
    item->setToolTip(presenter_.describe(entry));
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(entry.is_shown ? Qt::Checked : Qt::Unchecked);
    if (item->text() == chosen) list_->setCurrentItem(item);
  }
  if (!list_->currentItem() && list_->count() > 0) list_->setCurrentRow(list_->count() - 1);
  is_filling_ = false;
  add_->setEnabled(!presenter_.isBusy());
  showChosen();
}

void OverlaysPanel::showChosen() {
  is_filling_ = true;
  const auto* entry =
      list_->currentItem() ? presenter_.find(list_->currentItem()->data(Qt::UserRole).toString()) : nullptr;
  const bool is_map = entry && entry->kind == casefile::OverlayKind::map;
  words_->setText(presenter_.isBusy() ? tr("reading \u2026")
                  : entry             ? presenter_.describe(*entry)
                                      : tr("no overlay"));
  opacity_->setEnabled(entry);
  remove_->setEnabled(entry);
  for (QWidget* field :
       {static_cast<QWidget*>(threshold_), static_cast<QWidget*>(full_), static_cast<QWidget*>(unit_)})
    field->setEnabled(is_map);
  if (entry) opacity_->setValue(int(std::lround(100 * entry->opacity)));
  if (is_map) {
    for (auto* field : {threshold_, full_}) field->setSingleStep(std::max(0.001, entry->full / 50));
    threshold_->setValue(entry->threshold);
    full_->setValue(entry->full);
    unit_->setText(QString::fromStdString(entry->unit));
  }
  is_filling_ = false;
}

void OverlaysPanel::changeChosen() {
  const auto* entry =
      list_->currentItem() ? presenter_.find(list_->currentItem()->data(Qt::UserRole).toString()) : nullptr;
  if (is_filling_ || !entry) return;
  auto changed = *entry;
  changed.opacity = opacity_->value() / 100.0;
  if (entry->kind == casefile::OverlayKind::map) {
    changed.threshold = threshold_->value();
    changed.full = full_->value();
    changed.unit = unit_->text().trimmed().toStdString();
  }
  presenter_.change(changed);
}

}  // namespace facenav::ui
