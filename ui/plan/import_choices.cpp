#include "plan/import_choices.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "shell/elided_label.h"
#include "shell/field_label.h"
#include "shell/narrow_label.h"
#include "shell/users_words.h"

namespace facenav::ui {
namespace {

constexpr double kFarthestZone_h = 14;

}  // namespace

ImportChoices::ImportChoices(ImportPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  heading_ = new QLabel(this);
  heading_->setObjectName("muted");
  makeNarrow(*heading_);
  grid->addWidget(heading_, 0, 0, 1, 4);
  space_ = new QComboBox(this);
  space_->addItems({tr("as the file says"), tr("RAS"), tr("LPS")});
  space_->setToolTip(tr("axes of the file's coordinates: x right or left, y anterior or posterior"));
  form_ = new QComboBox(this);
  form_->addItems({tr("as the file says"), tr("sform"), tr("qform")});
  form_->setToolTip(tr("the form of the T1's NIfTI that the coordinates mean; open only where they differ"));
  grid->addWidget(fieldLabel(tr("Coo&rdinates"), space_, this), 1, 0);
  grid->addWidget(space_, 1, 1);
  grid->addWidget(fieldLabel(tr("&Form"), form_, this), 1, 2);
  grid->addWidget(form_, 1, 3);
  makeT1(*grid, 2);
  handle_ = new QComboBox(this);
  handle_->addItems({tr("as the format says"), tr("as written"), tr("the other way")});
  handle_->setToolTip(
      tr("where the handles point; the other way turns the coils by 180 degrees about their axis"));
  frame_ = new QComboBox(this);
  frame_->addItems({tr("not said"), tr("x to the nasion"), tr("x to the right ear")});
  frame_->setToolTip(
      tr("of coordinates that lie between the ears; the file does not say which way x points"));
  replaces_ = new QCheckBox(tr("Re&place"), this);
  replaces_->setToolTip(tr("targets of the same name with another pose; locked ones stay"));
  grid->addWidget(fieldLabel(tr("&Handle"), handle_, this), 3, 0);
  grid->addWidget(handle_, 3, 1);
  grid->addWidget(fieldLabel(tr("Head fra&me"), frame_, this), 3, 2);
  grid->addWidget(frame_, 3, 3);
  grid->addWidget(replaces_, 4, 2, 1, 2);
  clock_ = new QDoubleSpinBox(this);
  clock_->setRange(-kFarthestZone_h, kFarthestZone_h);
  clock_->setDecimals(2);
  clock_->setSingleStep(1);
  clock_->setSuffix(tr(" h"));
  clock_->setToolTip(tr("hours that the clock of the file's pulses is ahead of UTC"));
  clock_words_ = fieldLabel(tr("C&lock ahead of UTC"), clock_, this);
  grid->addWidget(clock_words_, 4, 0);
  grid->addWidget(clock_, 4, 1);
  connectAnswers();
  connect(&presenter_, &ImportPresenter::changed, this, &ImportChoices::showAnswers);
  showAnswers();
}

void ImportChoices::connectAnswers() {
  connect(space_, QOverload<int>::of(&QComboBox::activated), this, [this](int i) {
    answer([i](auto& order) {
      order.answers.space.reset();
      if (i > 0) order.answers.space = i == 1 ? interop::Space::ras : interop::Space::lps;
    });
  });
  connect(form_, QOverload<int>::of(&QComboBox::activated), this, [this](int i) {
    answer([i](auto& order) {
      order.answers.form.reset();
      if (i > 0) order.answers.form = i == 1 ? interop::Form::sform : interop::Form::qform;
    });
  });
  connect(handle_, QOverload<int>::of(&QComboBox::activated), this, [this](int i) {
    answer([i](auto& order) { order.answers.keeps_handle = i == 1, order.answers.flips_handle = i == 2; });
  });
  connect(frame_, QOverload<int>::of(&QComboBox::activated), this, [this](int i) {
    answer([i](auto& order) {
      order.answers.head_frame.reset();
      if (i > 0)
        order.answers.head_frame = i == 1 ? interop::HeadFrame::x_nasion : interop::HeadFrame::x_right;
    });
  });
  connect(replaces_, &QCheckBox::toggled, this,
          [this](bool is_on) { answer([is_on](auto& order) { order.replaces = is_on; }); });
  connect(clock_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double hours) { answer([hours](auto& order) { order.utc_offset_h = hours; }); });
}

void ImportChoices::makeT1(QGridLayout& grid, int row) {
  t1_ = new ElidedLabel(this);
  markUsersWords(*t1_);
  choose_t1_ = new QPushButton(tr("&T1\u2026"), this);
  choose_t1_->setToolTip(tr("the NIfTI that the other program used, if it is not the case's own"));
  own_t1_ = new QPushButton(tr("The case's"), this);
  own_t1_->setToolTip(tr("judges the file by the case's own T1 again"));
  for (auto* button : {choose_t1_, own_t1_}) button->setObjectName("tool");
  grid.addWidget(choose_t1_, row, 0);
  grid.addWidget(t1_, row, 1, 1, 2);
  grid.addWidget(own_t1_, row, 3);
  connect(choose_t1_, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("The T1 that the other program used"), {},
                                                      tr("NIfTI (*.nii *.nii.gz);;All files (*)"));
    if (!file.isEmpty()) answer([&file](auto& order) { order.t1 = file.toStdString(); });
  });
  connect(own_t1_, &QPushButton::clicked, this, [this] { answer([](auto& order) { order.t1.clear(); }); });
}

void ImportChoices::showFile(int file) {
  file_ = file;
  showAnswers();
}

void ImportChoices::answer(const std::function<void(steps::OtherImport&)>& change) {
  if (is_showing_ || file_ < 0 || file_ >= int(presenter_.files().size())) return;
  auto order = presenter_.order(std::size_t(file_));
  change(order);
  presenter_.setOrder(std::size_t(file_), order);
}

void ImportChoices::showAnswers() {
  const bool has_file = file_ >= 0 && file_ < int(presenter_.files().size());
  setEnabled(has_file);
  if (!has_file) return;
  const auto& file = presenter_.files()[std::size_t(file_)];
  is_showing_ = true;
  heading_->setText(
      tr("What %1 leaves open").arg(QString::fromStdString(file.order.file.filename().string())));
  const auto& answers = file.order.answers;
  space_->setCurrentIndex(!answers.space ? 0 : answers.space == interop::Space::ras ? 1 : 2);
  form_->setCurrentIndex(!answers.form ? 0 : answers.form == interop::Form::sform ? 1 : 2);
  form_->setEnabled(presenter_.hasTwoForms(std::size_t(file_)));
  t1_->set(file.order.t1.empty() ? tr("the case's own")
                                 : QString::fromStdString(file.order.t1.filename().string()));
  own_t1_->setEnabled(!file.order.t1.empty());
  handle_->setCurrentIndex(answers.keeps_handle ? 1 : answers.flips_handle ? 2 : 0);
  frame_->setCurrentIndex(!answers.head_frame                                   ? 0
                          : *answers.head_frame == interop::HeadFrame::x_nasion ? 1
                                                                                : 2);
  replaces_->setChecked(file.order.replaces);
  clock_->setValue(file.order.utc_offset_h);
  const auto& items = file.preview.items;
  const bool has_pulses = std::any_of(
      items.begin(), items.end(), [](const auto& item) { return item.item.kind == interop::Kind::pulse; });
  clock_->setEnabled(has_pulses && !file.preview.file.is_clock_utc);
  clock_words_->setEnabled(clock_->isEnabled());
  is_showing_ = false;
}

}  // namespace facenav::ui
