#include "treat/figures_panel.h"

#include <QGridLayout>
#include <QStyle>
#include <QTextDocument>
#include <QVBoxLayout>
#include <QVariant>

#include "shell/appearance.h"

namespace facenav::ui {

namespace {

constexpr int kLeastWidth_px = 410;
constexpr int kBanner_px = 104, kLowBanner_px = 76;  // two lines; longer words get smaller letters

/// Letter sizes of the banner's two lines, pt, largest first.
struct LetterSizes {
  double title_pt, advice_pt;
};
constexpr LetterSizes kLetters[] = {{30, 19}, {26, 17}, {22, 16}, {19, 15}, {16, 14}, {14, 12}};

/// Splits "FACE NOT SEEN: let .." into two lines: the problem, legible from two metres, and below it what to
/// do.
QString twoLines(const ReadOut& read_out, const LetterSizes& letters) {
  const QString mark = read_out.level == Level::lost ? QStringLiteral("\u2715&nbsp;") : QString();
  const int colon = read_out.instruction.indexOf(": ");
  const QString title = read_out.instruction.left(colon < 0 ? read_out.instruction.size() : colon);
  QString text = QStringLiteral("<div style='font-size:%1pt'>%2%3</div>")
                     .arg(letters.title_pt * textScale())
                     .arg(mark, title.toHtmlEscaped());
  if (colon >= 0)
    text += QStringLiteral("<div style='font-size:%1pt'>%2</div>")
                .arg(letters.advice_pt * textScale())
                .arg(read_out.instruction.mid(colon + 2).toHtmlEscaped());
  return text;
}

/// Returns the words in the largest letters with which they fit.
QString fitted(const ReadOut& read_out, const QFont& font, const QSize& room) {
  QString text;
  for (const auto& letters : kLetters) {
    text = twoLines(read_out, letters);
    QTextDocument document;
    document.setDocumentMargin(0);
    document.setDefaultFont(font);
    document.setHtml(text);
    document.setTextWidth(room.width());
    if (document.size().height() <= room.height() && document.idealWidth() <= room.width()) break;
  }
  return text;
}

}  // namespace

FiguresPanel::FiguresPanel(QWidget* parent)
    : QFrame(parent), banner_(new QLabel(this)), predicted_(new QLabel(this)), gap_(new QLabel(this)) {
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
  below_ = new QBoxLayout(QBoxLayout::TopToBottom);
  column->addLayout(grid_, 1);
  whenTextScales(this, [this] {
    setMinimumWidth(sized(kLeastWidth_px));  // for the longest figures side by side
    is_small_ = is_low_ = false;             // until the room is measured again
    fitted_.clear();
    place();
  });
  predicted_->setObjectName("muted");
  predicted_->setAlignment(Qt::AlignCenter);
  predicted_->setToolTip(
      tr("error of the alignment at the target: 95 of 100 such alignments keep within it"));
  gap_->setObjectName("gap_words");
  gap_->setAlignment(Qt::AlignCenter);
  below_->setSpacing(0);
  below_->addWidget(gap_);
  below_->addWidget(predicted_);
  column->addLayout(below_);
}

void FiguresPanel::place() {
  const int columns = is_small_ ? 4 : 2;
  for (int i = 0; i < 4; ++i) {
    auto *value = values_[std::size_t(i)], *name = names_[std::size_t(i)];
    value->setObjectName(is_small_ ? "figure_small" : i == 0 && !is_low_ ? "figure_main" : "figure");
    value->style()->unpolish(value);
    value->style()->polish(value);
    grid_->setColumnStretch(i, i < columns);
    grid_->addWidget(value, i / columns * 2, i % columns);
    grid_->addWidget(name, i / columns * 2 + 1, i % columns, Qt::AlignCenter);
  }
  grid_->setVerticalSpacing(is_low_ ? 0 : -1);
  below_->setDirection(is_small_ ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  banner_->setFixedHeight(sized(is_low_ ? kLowBanner_px : kBanner_px));
}

int FiguresPanel::neededHeight() {
  if (!is_small_) needed_px_ = minimumSizeHint().height() + sized(is_low_ ? kBanner_px - kLowBanner_px : 0);
  return needed_px_;
}

/// Fits the words to the banner, which keeps its height so that the figures never move.
void FiguresPanel::fitBanner() {
  constexpr int kAround_px = 2 * 6 + 2 * 5;  // padding and the widest border, as in the style sheet
  const QSize room = banner_->size() - QSize(kAround_px, kAround_px);
  const QString key = QString("%1 %2 %3").arg(room.width()).arg(room.height()).arg(read_out_.instruction) +
                      QString::number(int(read_out_.level));
  if (key == fitted_) return;
  fitted_ = key;
  banner_->setText(fitted(read_out_, banner_->font(), room));
}

void FiguresPanel::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fitBanner();
}

void FiguresPanel::setSmall(bool is_small, bool is_low) {
  if (is_small == is_small_ && is_low == is_low_) return;
  is_small_ = is_small;
  is_low_ = is_low;
  place();
  fitBanner();
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
  read_out_ = read_out;
  fitBanner();
  for (QLabel* value : values_)
    value->setEnabled(read_out.level == Level::good || read_out.level == Level::caution);
  values_[0]->setText(read_out.across);
  values_[1]->setText(read_out.depth);
  values_[2]->setText(read_out.tilt);
  values_[3]->setText(read_out.twist);
  predicted_->setText(read_out.predicted);
  gap_->setText(read_out.gap);
  gap_->setToolTip(read_out.gap_tip);
  showSecond(read_out.second);
  setDoubtful(read_out.gap_disagrees);
}

void FiguresPanel::showSecond(const QString& words) {
  if (!second_ && words.isEmpty()) return;
  if (!second_) {
    second_ = new QLabel(this);
    second_->setObjectName("second_coil_words");
    second_->setAlignment(Qt::AlignCenter);
    second_->setWordWrap(true);
    second_->setToolTip(tr("the second coil against its own target; it is the faint coil in the scene"));
    layout()->addWidget(second_);
  }
  second_->setText(words);
  second_->setVisible(!words.isEmpty());
}

void FiguresPanel::setDoubtful(bool is_doubtful) {
  if (gap_->property("is_bad").toBool() == is_doubtful) return;
  gap_->setProperty("is_bad", is_doubtful);
  gap_->style()->unpolish(gap_);
  gap_->style()->polish(gap_);
}

std::array<QString, 4> FiguresPanel::figures() const {
  return {values_[0]->text(), values_[1]->text(), values_[2]->text(), values_[3]->text()};
}

}  // namespace facenav::ui
