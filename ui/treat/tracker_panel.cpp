#include "treat/tracker_panel.h"

#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "plan/head_presenter.h"
#include "shell/narrow_label.h"

namespace facenav::ui {
namespace {

constexpr int kTrackerRefresh_ms = 300;
constexpr double kMostError_mm = 50;  // as treat/tracker_alignment.h takes it

}  // namespace

TrackerPanel::TrackerPanel(TreatPresenter& treat, QWidget* parent)
    : QFrame(parent), treat_(treat), tracker_(treat.tracker()) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* opener = new QPushButton(tr("Or another tracker, without cameras"), this);
  opener->setObjectName("tool");
  opener->setCheckable(true);
  opener->setToolTip(tr("poses of head and coil from OpenIGTLink"));
  auto* body = new QWidget(this);  // long, and not for most clinics
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(opener);
  outer->addWidget(body);
  body->hide();
  connect(opener, &QPushButton::toggled, body, &QWidget::setVisible);
  coil_ = addLine(*column, tr("coil"), QStringLiteral("igtl://127.0.0.1/Coil1ToTracker"),
                  tr("OpenIGTLink server of the tracker, and the name of the coil's pose there"));
  head_ = addLine(*column, tr("head"), QStringLiteral("SubjectToTracker"),
                  tr("name of the pose of the tool on the head, at the same server"));
  second_ = addLine(*column, tr("second coil"), QStringLiteral("Coil2ToTracker"),
                    tr("name of the second coil's pose there; may stay empty"));
  use_ = new QPushButton(tr("Use this tracker"), this);
  use_->setToolTip(tr("in place of cameras, from now on"));
  column->addWidget(use_);
  state_ = new QLabel(this);
  state_->setObjectName("plain");
  makeNarrow(*state_);
  column->addWidget(state_);
  addAlignment(*column);
  addTouching(*column);
  connect(use_, &QPushButton::clicked, this, [this] {
    take();
    tracker_.open();
  });
  connect(&treat_, &TreatPresenter::changed, this, &TrackerPanel::showState);
  opener->setChecked(!tracker_.tracker().words.empty());
  timer_.setInterval(kTrackerRefresh_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { isVisible() ? showState() : timer_.stop(); });
  showState();
}

QLineEdit* TrackerPanel::addLine(QVBoxLayout& column, const QString& name, const QString& example,
                                 const QString& tip) {
  auto* row = new QHBoxLayout;
  auto* line = new QLineEdit(this);
  line->setPlaceholderText(example);
  line->setToolTip(tip);
  line->setAccessibleName(tr("other tracker: %1").arg(name));
  row->addWidget(new QLabel(name, this));
  row->addWidget(line, 1);
  column.addLayout(row);
  connect(line, &QLineEdit::editingFinished, this, [this, line] {
    if (line->isModified()) take();
    line->setModified(false);
  });
  return line;
}

void TrackerPanel::addAlignment(QVBoxLayout& column) {
  alignment_ = addLine(column, tr("alignment"), tr("a file, or touch points below"),
                       tr("JSON file: how the tool on the head stands to the MRI, and its error"));
  auto* choose = new QPushButton(tr("Choose a file\u2026"), this);
  choose->setToolTip(tr("JSON file with mri_T_subject, or with points touched on the head"));
  column.addWidget(choose);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Alignment of the tracker"),
                                                      alignment_->text(), tr("Alignment (*.json)"));
    if (file.isEmpty()) return;
    alignment_->setText(file);
    take();
  });
}

void TrackerPanel::addTouching(QVBoxLayout& column) {
  pointer_ = addLine(column, tr("pointer"), QStringLiteral("PointerToTracker"),
                     tr("name of the pointer's pose there; its origin is the tip"));
  pointer_->disconnect(this);  // it is no part of the tracker that a session uses
  touches_ = new QVBoxLayout;
  column.addLayout(touches_);
  auto* row = new QHBoxLayout;
  error_ = new QDoubleSpinBox(this);
  error_->setRange(0, kMostError_mm);
  error_->setDecimals(1);
  error_->setSpecialValueText(tr("error of a point?"));
  error_->setSuffix(tr(" mm"));
  error_->setAccessibleName(tr("error of a touched point"));
  error_->setToolTip(tr("root mean square error of one touched point: tracker, pointer and hand together"));
  by_points_ = new QPushButton(tr("Align by points"), this);
  by_points_->setToolTip(tr("fits the touched points to the MRI and keeps them in the case"));
  row->addWidget(error_, 1);
  row->addWidget(by_points_, 1);
  column.addLayout(row);
  connect(error_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &TrackerPanel::showState);
  connect(by_points_, &QPushButton::clicked, this, [this] { tracker_.alignByPoints(error_->value()); });
}

/// Takes what is typed.
void TrackerPanel::take() {
  auto choice = tracker_.tracker();
  choice.words = coil_->text().trimmed().toStdString();
  choice.head = head_->text().trimmed().toStdString();
  choice.second_coil = second_->text().trimmed().toStdString();
  choice.alignment = alignment_->text().trimmed().toStdString();
  tracker_.choose(choice);
}

/// A button for each landmark of the case.
void TrackerPanel::fillLandmarks() {
  const QStringList names = tracker_.landmarks();
  QStringList shown;
  for (const auto* button : landmarks_) shown << button->property("landmark").toString();
  if (names == shown) return;
  qDeleteAll(landmarks_);
  landmarks_.clear();
  for (const QString& name : names) {
    auto* button = new QPushButton(this);
    button->setProperty("landmark", name);
    button->setToolTip(tr("hold the pointer's tip to this place, then press"));
    touches_->addWidget(button);
    landmarks_ << button;
    connect(button, &QPushButton::clicked, this, [this, name] { tracker_.touch(name, pointer_->text()); });
  }
}

void TrackerPanel::showState() {
  fillLandmarks();
  const auto& choice = tracker_.tracker();
  const std::pair<QLineEdit*, std::string> lines[] = {{coil_, choice.words},
                                                      {head_, choice.head},
                                                      {second_, choice.second_coil},
                                                      {alignment_, choice.alignment.string()}};
  for (const auto& [line, words] : lines) {
    if (!line->hasFocus()) line->setText(QString::fromStdString(words));
    line->setEnabled(!treat_.isRunning());
  }
  state_->setText(tracker_.words());
  use_->setEnabled(!treat_.isRunning());
  int touched = 0;
  for (auto* button : landmarks_) {
    const QString name = button->property("landmark").toString();
    const bool is_touched = tracker_.isTouched(name);
    touched += is_touched;
    const QString words = landmarkWords(surface::landmarkFrom(name.toStdString()));
    button->setText(tr("Touch: %1 %2").arg(words, QChar(is_touched ? 0x2713 : 0x25cb)));
    button->setEnabled(tracker_.isConnected() && !treat_.isRunning());
  }
  by_points_->setEnabled(touched >= 3 && error_->value() > 0 && !treat_.isRunning());
}

void TrackerPanel::showEvent(QShowEvent*) {
  showState();
  timer_.start();
}

}  // namespace facenav::ui
