#include "treat/treat_side.h"

#include <QEvent>
#include <QShortcut>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>

#include "shell/appearance.h"
#include "shell/scroll_column.h"
#include "treat/bulls_eye_view.h"
#include "treat/check_row.h"
#include "treat/figures_panel.h"
#include "treat/motor_panel.h"
#include "treat/pulse_row.h"
#include "treat/session_panel.h"
#include "treat/tip_panel.h"

namespace facenav::ui {
namespace {

/// Takes the width of the shown page, not that of the widest.
class ShownPage : public QStackedWidget {
 public:
  explicit ShownPage(QWidget* parent) : QStackedWidget(parent) {
    connect(this, &QStackedWidget::currentChanged, this, &QWidget::updateGeometry);
  }
  QSize minimumSizeHint() const override {
    const QWidget* page = currentWidget();
    return page ? page->minimumSizeHint().expandedTo(page->minimumSize()) : QSize();
  }
  /// Lets the surrounding column scroll only if this does not fit.
  QSize sizeHint() const override { return minimumSizeHint(); }
};

}  // namespace

TreatSide::TreatSide(TreatPresenter& treat, MotorPresenter& motor, CheckPresenter& check, TipPresenter& tip,
                     SessionSounds& sounds, SecondScreens& screens, ProjectorPresenter& projector,
                     QWidget* parent)
    : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  tools_ = new ShownPage(this);
  bulls_eye_ = new BullsEyeView(tools_);
  tools_->addWidget(bulls_eye_);
  motor_ = new MotorPanel(motor, treat, tools_);
  tools_->addWidget(new ScrollColumn(motor_, 0, tools_));
  tools_->addWidget(new ScrollColumn(new SessionPanel(treat, sounds, screens, projector, tools_), 0, tools_));
  tools_->addWidget(new ScrollColumn(new TipPanel(tip, treat, tools_), 0, tools_));
  figures_ = new FiguresPanel(this);
  bulls_eye_and_figures_ = new QBoxLayout(QBoxLayout::TopToBottom);
  bulls_eye_and_figures_->addWidget(tools_, 4);
  bulls_eye_and_figures_->addWidget(figures_, 5);
  bulls_eye_and_figures_->setContentsMargins(0, 0, 0, 0);
  tabs_ = makeTabs();
  column->addWidget(tabs_);
  connect(&treat.offers(), &OffersPresenter::changed, this,
          [this, &offers = treat.offers()] { markOffers(offers); });
  auto* scrolled = new QWidget(this);
  scrolled->setLayout(bulls_eye_and_figures_);
  column_ = new ScrollColumn(scrolled, kFigures_px, this);
  column_->viewport()->installEventFilter(this);
  connect(&TextScaleNotice::instance(), &TextScaleNotice::changed, this, [this] {
    QTimer::singleShot(0, this, [this] {
      if (isVisible()) arrange();
    });
  });
  column->addWidget(column_, 1);
  pulses_ = new PulseRow(treat, sounds, this);
  column->addWidget(pulses_);
  column->addWidget(new CheckRow(check, treat, this));
  auto* key = new QShortcut(Qt::Key_P, this);
  key->setWhatsThis(tr("a pulse was given now"));
  key->setAutoRepeat(false);  // a key that is held down is one pulse
  connect(key, &QShortcut::activated, pulses_, &PulseRow::take);
}

QTabBar* TreatSide::makeTabs() {
  auto* tabs = new QTabBar(this);
  tabs->setAccessibleName(tr("tools"));
  tabs->setExpanding(false);
  tabs->setDrawBase(false);
  const std::pair<QString, QString> tools[] = {
      {tr("Aim"), tr("where the coil is against the target")},
      {tr("Motor"), tr("motor hotspot and threshold: the muscle's answers")},
      {tr("Session"), tr("pause, pain, adverse events, source of the pulses, sound, second screen")},
      {tr("Check"), tr("the alignment by eye: the MRI's skin over the pictures, and the coil's tip or a "
                       "clicked spot on the face")}};
  for (const auto& [name, tip] : tools) tabs->setTabToolTip(tabs->addTab(name), tip);
  connect(tabs, &QTabBar::currentChanged, this, [this](int tool) {
    tools_->setCurrentIndex(tool);
    arrange();
  });
  return tabs;
}

/// Marks the tool in which an offered target waits.
void TreatSide::markOffers(const OffersPresenter& offers) {
  const QString mark = offers.all().empty() ? QString() : QString(" ") + QChar(0x25cf);
  tabs_->setTabText(int(Tool::session), tr("Session") + mark);
}

void TreatSide::showTool(Tool tool) { tabs_->setCurrentIndex(int(tool)); }

bool TreatSide::isShown(Tool tool) const { return tabs_->currentIndex() == int(tool); }

void TreatSide::refreshPulses() {
  pulses_->refresh();
  motor_->showQuestion();
}

void TreatSide::show(const guidance::GuidanceState& guidance, const ReadOut& read_out) {
  bulls_eye_->set(guidance);
  figures_->set(read_out);
}

void TreatSide::resizeEvent(QResizeEvent*) { arrange(); }

/// Rearranges, because the room changes with the rows below, too.
bool TreatSide::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) arrange();
  return QWidget::eventFilter(watched, event);
}

/// Moves the bull's eye beside the figures if both do not fit one above the other. The other panels are too
/// wide for that: where one does not fit, the figures become small and leave it their room.
void TreatSide::arrange() {
  const bool is_aim = tools_->currentWidget() == bulls_eye_;
  const int needed_px =
      bulls_eye_->minimumHeight() + bulls_eye_and_figures_->spacing() + figures_->neededHeight();
  const bool is_low = column_->viewport()->height() < needed_px;
  bulls_eye_and_figures_->setDirection(is_low && is_aim ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  bulls_eye_and_figures_->setStretchFactor(tools_, is_aim ? 4 : 1);
  bulls_eye_and_figures_->setStretchFactor(figures_, is_aim ? 5 : 0);
  const int page_px = tools_->currentWidget()->sizeHint().height();
  const bool is_cramped =
      page_px + bulls_eye_and_figures_->spacing() + figures_->neededHeight() > column_->viewport()->height();
  figures_->setSmall(!is_aim && (is_low || is_cramped), is_low);
}

}  // namespace facenav::ui
