#include "setup/setup_tools.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "setup/board_screen.h"
#include "setup/camera_fields.h"
#include "shell/narrow_label.h"

namespace facenav::ui {
namespace {

using Step = steps::SetupStep;

/// Makes a box whose width follows the layout, not the longest name.
QComboBox* narrowBox(QWidget* parent, const QString& tip) {
  auto* box = new QComboBox(parent);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  box->setToolTip(tip);
  return box;
}

}  // namespace

SetupTools::SetupTools(SetupPresenter& presenter, QWidget* parent)
    : QStackedWidget(parent), presenter_(presenter) {
  makeCameras();
  makeBoard();
  makeCheck();
  makeCoil();
  connect(&presenter_, &SetupPresenter::changed, this, [this] {
    fillDevices();
    fillCoils();
    refresh();
  });
  fillDevices();
  fillCoils();
  refresh();
}

QVBoxLayout* SetupTools::addPage() {
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  addWidget(page);
  return column;
}

QPushButton* SetupTools::addButton(QVBoxLayout& column, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setToolTip(tip);
  column.addWidget(button);
  return button;
}

QLabel* SetupTools::addWords(QVBoxLayout& column, const QString& text, const char* name) {
  auto* label = new QLabel(text, this);
  label->setObjectName(name);
  makeNarrow(*label);
  column.addWidget(label);
  return label;
}

void SetupTools::makeCameras() {
  auto* column = addPage();
  cameras_ = new CameraFields(presenter_, this);
  column->addWidget(cameras_);
  open_ = addButton(*column, tr("Open the cameras"), tr("they adjust to the light, then they are locked"));
  auto* swap = addButton(*column, tr("Swap left and right"), tr("if the pictures are on the wrong sides"));
  auto* again = addButton(*column, tr("Look again"), tr("which cameras are plugged in"));
  device_words_ = addWords(*column, {}, "plain");
  addWords(*column, tr("Or a pair that is kept"), "heading");
  kept_ = narrowBox(this, tr("it is checked again, and repaired if it was moved"));
  kept_->setAccessibleName(tr("kept pair"));
  column->addWidget(kept_);
  open_kept_ = addButton(*column, tr("Check this pair"), tr("opens its cameras at step 3"));
  column->addStretch(1);
  connect(open_, &QPushButton::clicked, &presenter_, &SetupPresenter::open);
  connect(swap, &QPushButton::clicked, &presenter_, &SetupPresenter::swapSides);
  connect(again, &QPushButton::clicked, &presenter_, &SetupPresenter::lookForCameras);
  connect(open_kept_, &QPushButton::clicked, this, [this] { presenter_.openKept(kept_->currentText()); });
}

void SetupTools::makeBoard() {
  auto* column = addPage();
  auto* form = new QFormLayout;
  columns_ = new QSpinBox(this);
  rows_ = new QSpinBox(this);
  square_ = new QDoubleSpinBox(this);
  for (auto* box : {columns_, rows_}) box->setRange(3, 30);
  columns_->setValue(presenter_.board().columns);
  rows_->setValue(presenter_.board().rows);
  square_->setRange(1, 200);
  square_->setDecimals(2);
  square_->setSuffix(tr(" mm"));
  square_->setValue(presenter_.board().square_mm);
  columns_->setToolTip(tr("inner corners along the board: one less than squares"));
  rows_->setToolTip(tr("inner corners down the board: one less than squares"));
  square_->setToolTip(tr("measure ten squares with a ruler, and divide by ten"));
  form->addRow(tr("corners across"), columns_);
  form->addRow(tr("corners down"), rows_);
  form->addRow(tr("one square"), square_);
  column->addLayout(form);
  auto* page = addButton(*column, tr("Print the board\u2026"), tr("a page (SVG, A4) to print at 100 %"));
  auto* screen = addButton(*column, tr("Show it on a screen"), tr("on the second screen or a tablet"));
  views_ = addWords(*column, {}, "plain");
  finish_ = addButton(*column, tr("Calculate now"), tr("from 8 views on; by itself when they are enough"));
  more_ = addButton(*column, tr("Take more views"), tr("beside those that are there"));
  repeat_ = addButton(*column, tr("Begin again"), tr("forgets the views"));
  result_ = addWords(*column, {}, "heading");
  column->addStretch(1);
  for (auto* box : {columns_, rows_})
    connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, &SetupTools::boardEdited);
  connect(square_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &SetupTools::boardEdited);
  connect(page, &QPushButton::clicked, this, &SetupTools::print);
  connect(screen, &QPushButton::clicked, this,
          [this] { (new BoardScreen(presenter_.board(), window()))->showOnScreen(); });
  connect(finish_, &QPushButton::clicked, &presenter_, &SetupPresenter::finishViews);
  connect(more_, &QPushButton::clicked, &presenter_, &SetupPresenter::takeMoreViews);
  connect(repeat_, &QPushButton::clicked, &presenter_, &SetupPresenter::repeatViews);
}

void SetupTools::makeCheck() {
  auto* column = addPage();
  addWords(*column, tr("Name of this pair"), "heading");
  name_ = new QLineEdit(presenter_.name(), this);
  name_->setAccessibleName(tr("name of this pair"));
  name_->setMaxLength(64);
  column->addWidget(name_);
  name_trouble_ = addWords(*column, {}, "fault");
  keep_ = addButton(*column, tr("Keep it"), tr("cameras, settings, calibration and this check"));
  keep_->setObjectName("primary");
  auto* again = addButton(*column, tr("Check again"), tr("with the board in another place"));
  repair_ = addButton(*column, tr("Repair: calibrate again"), tr("two minutes, with the board"));
  kept_words_ = addWords(*column, {}, "plain");  // below the buttons, which stay in their places
  column->addStretch(1);
  connect(name_, &QLineEdit::textChanged, &presenter_, &SetupPresenter::setName);
  connect(keep_, &QPushButton::clicked, this, &SetupTools::keep);
  connect(repair_, &QPushButton::clicked, &presenter_, &SetupPresenter::repeatViews);
  connect(again, &QPushButton::clicked, this, [this] {
    presenter_.go(Step::place);
    presenter_.go(Step::check);
  });
}

void SetupTools::makeCoil() {
  auto* column = addPage();
  addWords(*column, tr("Coil of the library"), "heading");
  coil_ = narrowBox(this, tr("facenav coil add puts a coil into the library"));
  coil_->setAccessibleName(tr("coil of the library"));
  column->addWidget(coil_);
  pivot_ = addButton(*column, tr("Calibrate by pivoting"), tr("three points of the coil on a fixed tip"));
  auto* jig = addButton(*column, tr("Calibrate with a jig\u2026"), tr("the jig's marker as coil.json"));
  keep_coil_ = addButton(*column, tr("Keep the coil"), tr("its calibration, in the library"));
  coil_words_ = addWords(*column, {}, "plain");
  addWords(*column, tr("Ordinary webcams"), "heading");
  wave_ =
      addButton(*column, tr("Measure the shutter"),
                tr("wave the coil quickly before the cameras for some seconds; else the first session with a "
                   "quick coil measures it"));
  column->addStretch(1);
  connect(coil_, &QComboBox::textActivated, &presenter_, &SetupPresenter::chooseCoil);
  connect(pivot_, &QPushButton::clicked, &presenter_, &SetupPresenter::startPivots);
  connect(jig, &QPushButton::clicked, this, &SetupTools::chooseJig);
  connect(wave_, &QPushButton::clicked, &presenter_, &SetupPresenter::startWave);
  connect(keep_coil_, &QPushButton::clicked, this, [this] {
    if (presenter_.keepCoil()) coil_words_->setText(tr("kept: %1").arg(presenter_.coilName()));
  });
}

void SetupTools::fillDevices() {
  cameras_->refresh();
  const QSignalBlocker block(kept_);
  const QString was = kept_->currentText();
  kept_->clear();
  kept_->addItems(presenter_.rigNames());
  kept_->setEnabled(kept_->count() > 0);
  open_kept_->setEnabled(kept_->count() > 0);
  if (kept_->findText(was) >= 0) kept_->setCurrentText(was);
}

void SetupTools::fillCoils() {
  const QSignalBlocker block(coil_);
  coil_->clear();
  coil_->addItem(tr("60 mm, 4x4_50, id 7"));
  coil_->addItems(presenter_.coilNames());
  coil_->setCurrentIndex(std::max(0, coil_->findText(presenter_.coilName())));
}

void SetupTools::boardEdited() { presenter_.setBoard(columns_->value(), rows_->value(), square_->value()); }

void SetupTools::refresh() {
  setCurrentIndex(int(presenter_.step()));
  const auto view = presenter_.view();
  open_->setEnabled(presenter_.canOpen());
  open_->setText(presenter_.isOpen() ? tr("Open them again") : tr("Open the cameras"));
  device_words_->setText(presenter_.isOpen() ? presenter_.deviceWords()
                                             : QString());  // otherwise the sentence shows it
  device_words_->setVisible(!device_words_->text().isEmpty());
  const bool is_calibrated = presenter_.canGo(Step::check);
  if (view->step == Step::calibrate) {
    views_->setText(tr("%1 views taken").arg(view->views));
    finish_->setEnabled(view->views >= 8 && !view->is_done);
    more_->setEnabled(view->is_done && view->views > 0);
  }
  result_->setText(presenter_.resultWords());
  repeat_->setEnabled(presenter_.isOpen());
  keep_->setEnabled(view->step == Step::check && view->is_done && !presenter_.isKept());
  kept_words_->setText(
      presenter_.isKept() ? tr("kept as %1; go on to the coil, or close").arg(presenter_.name()) : QString());
  name_trouble_->setText(presenter_.trouble(SetupField::name));
  name_trouble_->setVisible(!name_trouble_->text().isEmpty());
  repair_->setVisible(view->needs_repair);
  pivot_->setEnabled(is_calibrated);
  wave_->setEnabled(is_calibrated);
  keep_coil_->setEnabled(view->step == Step::coil && view->is_done && !presenter_.coilName().isEmpty());
}

void SetupTools::keep() {
  const bool is_taken = presenter_.isNameTaken();
  if (is_taken &&
      QMessageBox::question(this, tr("Keep the pair"),
                            tr("There is a pair called %1. Replace it?").arg(presenter_.name())) !=
          QMessageBox::Yes)
    return;
  presenter_.keep(is_taken);
}

void SetupTools::print() {
  const QString file =
      QFileDialog::getSaveFileName(this, tr("The board as a page"), "board.svg", tr("Page (*.svg)"));
  if (!file.isEmpty()) presenter_.printBoard(file);
}

void SetupTools::chooseJig() {
  const QString file = QFileDialog::getOpenFileName(this, tr("The jig"), {}, tr("coil.json (*.json)"));
  if (!file.isEmpty()) presenter_.startJig(file);
}

}  // namespace facenav::ui
