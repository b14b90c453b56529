#include "widgets/figures_panel.h"

#include <QGridLayout>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "appearance.h"

namespace facenav::ui {

namespace {

constexpr int kLeastWidth_px = 410;

/// "FACE NOT SEEN: let .." on two lines: what is wrong, legible from two metres, and below it what to do.
QString twoLines(const ReadOut& read_out) {
  const QString mark = read_out.level == Level::lost ? QStringLiteral("\u2715&nbsp;") : QString();
  const int colon = read_out.instruction.indexOf(": ");
  const QString head = read_out.instruction.left(colon < 0 ? read_out.instruction.size() : colon);
  QString text = QStringLiteral("<div style='font-size:%1pt'>%2%3</div>")
                     .arg(30 * textScale())
                     .arg(mark, head.toHtmlEscaped());
  if (colon >= 0)
    text += QStringLiteral("<div style='font-size:%1pt'>%2</div>")
                .arg(19 * textScale())
                .arg(read_out.instruction.mid(colon + 2).toHtmlEscaped());
  return text;
}

}  // namespace

FiguresPanel::FiguresPanel(QWidget* parent)
    : QFrame(parent), banner_(new QLabel(this)), predicted_(new QLabel(this)) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  banner_->setObjectName("banner");
  banner_->setWordWrap(true);
  banner_->setAlignment(Qt::AlignCenter);
  banner_->setTextFormat(Qt::RichText);
  column->addWidget(banner_);
  grid_ = new QGridLayout;
  const QString names[4] = {tr("across, mm"), tr("depth, mm"), tr("tilt"), tr("twist")};
  const QString tips[4] = {tr("distance of the coil's centre from the target, across the target's axis"),
                           tr("along the target's axis: + too deep, - stands off"),
                           tr("angle between the coil's axis and the target's"),
                           tr("turn of the handle that is left, about the axis")};
  for (std::size_t i = 0; i < 4; ++i) {
    auto* value = values_[i] = new QLabel(QString(QChar(0x2013)), this);
    value->setToolTip(tips[i]);
    value->setAccessibleName(names[i]);
    auto* name = names_[i] = new QLabel(names[i], this);
    name->setObjectName("muted");
    name->setToolTip(tips[i]);
    // Full cell width from the start: a new figure is never cut before the next layout.
    value->setAlignment(Qt::AlignCenter);
  }
  place();
  column->addLayout(grid_, 1);
  setMinimumWidth(sized(kLeastWidth_px));  // for the longest figures side by side
  predicted_->setObjectName("muted");
  predicted_->setAlignment(Qt::AlignCenter);
  predicted_->setToolTip(tr("predicted error of the alignment at the target (one standard deviation)"));
  column->addWidget(predicted_);
}

void FiguresPanel::place() {
  const int columns = is_small_ ? 4 : 2;
  for (int i = 0; i < 4; ++i) {
    auto *value = values_[std::size_t(i)], *name = names_[std::size_t(i)];
    value->setObjectName(is_small_ ? "figure_small" : i == 0 ? "figure_main" : "figure");
    value->style()->unpolish(value);
    value->style()->polish(value);
    grid_->setColumnStretch(i, i < columns);
    grid_->addWidget(value, i / columns * 2, i % columns);
    grid_->addWidget(name, i / columns * 2 + 1, i % columns, Qt::AlignCenter);
  }
  banner_->setMinimumHeight(sized(is_small_ ? 60 : 90));
}

void FiguresPanel::setSmall(bool is_small) {
  if (is_small == is_small_) return;
  is_small_ = is_small;
  place();
}

void FiguresPanel::set(const ReadOut& read_out) {
  const char* level = read_out.level == Level::good      ? "good"
                      : read_out.level == Level::caution ? "caution"
                      : read_out.level == Level::lost    ? "lost"
                                                         : "idle";
  if (banner_->property("level").toString() != level) {
    banner_->setProperty("level", level);
    banner_->style()->unpolish(banner_);
    banner_->style()->polish(banner_);
  }
  banner_->setText(twoLines(read_out));
  for (QLabel* value : values_)
    value->setEnabled(read_out.level == Level::good || read_out.level == Level::caution);
  values_[0]->setText(read_out.across);
  values_[1]->setText(read_out.depth);
  values_[2]->setText(read_out.tilt);
  values_[3]->setText(read_out.twist);
  predicted_->setText(read_out.predicted);
}

std::array<QString, 4> FiguresPanel::figures() const {
  return {values_[0]->text(), values_[1]->text(), values_[2]->text(), values_[3]->text()};
}

}  // namespace facenav::ui
