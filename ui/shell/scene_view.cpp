#include "shell/scene_view.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <QContextMenuEvent>
#include <QElapsedTimer>
#include <QMetaMethod>
#include <QMouseEvent>
#include <QPainter>
#include <utility>

#include "shell/appearance.h"
#include "shell/picture_focus.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

constexpr double kFluid_ms = 40.0;  // no simplified scene is needed up to this rendering time
constexpr int kRest_ms = 300;
const char* const kIsOutdated = "is_outdated";  // property of a hidden view whose image is to be drawn again

}  // namespace

SceneView::SceneView(QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), scene_(std::make_unique<scene::NavigationScene>()) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  setRenderWindow(window);
  whenTextScales(this, [this] {
    scene_->setTextScale(sized(100) / 100.0);
    if (isVisible()) refresh();
  });
  whenThemeChanges(this, [this] {
    scene_->setBackground(themeRgb(Colour::scene_low), themeRgb(Colour::scene_high));
    if (isVisible()) return refresh();
    setProperty(kIsOutdated, whole_ms_ > 0);  // its image has the other theme's background
  });
  scene_->attach(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor()->SetInteractorStyle(style);
  rest_.setSingleShot(true);
  rest_.setInterval(kRest_ms);
  connect(&rest_, &QTimer::timeout, this, [this] {
    is_quick_ = false;
    scene_->setQuick(false);
    refresh();
  });
  line_ = new QWidget(this);
  line_->setAttribute(Qt::WA_TransparentForMouseEvents);
  line_->installEventFilter(this);
  line_->hide();
  setMinimumSize(200, 160);
  setAccessibleName(tr("3-D view"));
  setToolTip(
      tr("left: rotate   middle: pan   right: zoom   click: choose a point   right click: "
         "menu"));
}

SceneView::~SceneView() = default;

void SceneView::show(const LoadedCase& loaded) {
  scene_->setScalp(loaded.scalp->mesh);
  if (loaded.brain)
    scene_->setBrain(*loaded.brain);
  else
    scene_->clearBrain();
  scene_->setVolume(*loaded.mri);
  refresh();
}

void SceneView::refresh() {
  if (!isVisible()) return;
  QElapsedTimer timer;
  timer.start();
  renderWindow()->Render();
  const double took_ms = double(timer.nsecsElapsed()) * 1e-6;
  if (is_quick_)
    rest_.start(kRest_ms + int(2 * took_ms));  // a slow scene pauses between drawings, but still moves
  else
    whole_ms_ = took_ms;
  emit drawn();
}

/// Switches to a simplified scene until the motion ends, if full rendering is slow here. Returns true if so.
bool SceneView::drawsQuickly(bool is_skin_shown) {
  if (!is_quick_ && whole_ms_ < kFluid_ms) return false;
  rest_.start();
  if (!is_quick_ || is_skin_shown_ != is_skin_shown) scene_->setQuick(true, is_skin_shown);
  is_skin_shown_ = is_skin_shown;
  return is_quick_ = true;
}

void SceneView::refreshQuickly(bool is_skin_shown) {
  drawsQuickly(is_skin_shown);
  refresh();
}

void SceneView::shareCamera(SceneView& other) {
  scene_->shareCamera(other.scene());
  connect(&other, &SceneView::turned, this, &SceneView::refreshMoving);
  connect(this, &SceneView::turned, &other, &SceneView::refreshMoving);
}

void SceneView::setDrawing(bool is_drawing) {
  if (draws_ == is_drawing) return;
  draws_ = is_drawing;
  outline_.clear();
  showLine();
  setCursor(is_drawing ? Qt::CrossCursor : Qt::ArrowCursor);
}

/// The layer over the image costs time with each drawing, so it is there only while it shows something.
void SceneView::showLine() {
  line_->setVisible(draws_ || has_seen_focus_);
  line_->update();
}

/// Shows a focus that came by keyboard; a click shows by itself where it was.
void SceneView::focusInEvent(QFocusEvent* event) {
  has_seen_focus_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  showLine();
  QVTKOpenGLNativeWidget::focusInEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
  has_seen_focus_ = false;
  showLine();
  QVTKOpenGLNativeWidget::focusOutEvent(event);
}

/// Draws the unfinished line over the rendered image, and the frame of the focus.
bool SceneView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != line_ || event->type() != QEvent::Paint)
    return QVTKOpenGLNativeWidget::eventFilter(watched, event);
  QPainter painter(line_);
  if (has_seen_focus_) {
    painter.setPen(QPen(themeColour(Colour::picture_text), kFocusFrame_px));
    painter.drawRect(line_->rect().adjusted(1, 1, -1, -1));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(themeColour(Colour::picture_text), 2));
  painter.drawPolyline(outline_);
  painter.setPen(QPen(themeColour(Colour::picture_text), 1, Qt::DashLine));
  if (outline_.size() > 2) painter.drawLine(outline_.back(), outline_.front());
  return true;
}

/// Keeps keys from VTK, whose letters would draw wires or close the program; the page handles them.
bool SceneView::event(QEvent* event) {
  const bool is_key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  if (event->type() == QEvent::ContextMenu) {
    if (static_cast<QContextMenuEvent*>(event)->reason() != QContextMenuEvent::Mouse)
      openViewMenu(*this, rect().center(), offersAt(rect().center()));
    return true;
  }
  if (event->type() == QEvent::Show && property(kIsOutdated).toBool()) {
    setProperty(kIsOutdated, false);
    QTimer::singleShot(0, this, &SceneView::refresh);
  }
  return is_key ? QWidget::event(event) : QVTKOpenGLNativeWidget::event(event);
}

std::optional<scene::ScenePick> SceneView::pickAt(const QPoint& position) const {
  const double ratio = devicePixelRatioF();
  return scene_->pick(int(position.x() * ratio), int((height() - 1 - position.y()) * ratio));
}

ViewOffers SceneView::offersAt(const QPoint& position) {
  ViewOffers offers;
  if (const auto pick = pickAt(position)) {
    offers.place = pick->point;
    if (isSignalConnected(QMetaMethod::fromSignal(&SceneView::placeWanted)))
      offers.goTo = [this, mm = pick->point.mm] { emit placeWanted(mm.x(), mm.y(), mm.z()); };
  }
  offers.reset = [this] {
    scene_->setView(scene::ViewPreset::target);
    refresh();
    emit turned();
  };
  return offers;
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  if (draws_ && event->buttons() == Qt::LeftButton && !outline_.isEmpty()) {
    outline_ << event->pos();
    return line_->update();
  }
  if (event->buttons() != Qt::NoButton) drawsQuickly(true);
  QVTKOpenGLNativeWidget::mouseMoveEvent(event);
  if (event->buttons() != Qt::NoButton) emit turned();
}

void SceneView::wheelEvent(QWheelEvent* event) {
  QVTKOpenGLNativeWidget::wheelEvent(event);
  emit turned();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = event->pos();
  if (draws_ && event->button() == Qt::LeftButton) {
    outline_ = QPolygon() << event->pos();
    return line_->update();
  }
  QVTKOpenGLNativeWidget::mousePressEvent(event);
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  if (draws_ && event->button() == Qt::LeftButton) {
    std::vector<Eigen::Vector2d> outline;
    for (const QPoint& p : std::exchange(outline_, {}))
      outline.emplace_back(2.0 * p.x() / width() - 1.0, 1.0 - 2.0 * p.y() / height());
    line_->update();
    if (outline.size() > 2) emit outlineDrawn(outline);
    return;
  }
  QVTKOpenGLNativeWidget::mouseReleaseEvent(event);
  const bool is_click = (event->pos() - pressed_at_).manhattanLength() <= kClickReach_px;
  if (is_click && event->button() == Qt::RightButton)
    return openViewMenu(*this, event->pos(), offersAt(event->pos()));
  if (!is_click || event->button() != Qt::LeftButton) return;
  if (const auto pick = pickAt(event->pos()))
    emit picked(pick->point.mm.x(), pick->point.mm.y(), pick->point.mm.z(), pick->is_brain);
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  line_->setGeometry(rect());
  scene_->attach(renderWindow());  // keeps the shape of the head icon
}

/// A view that was hidden has its size only now.
void SceneView::paintGL() {
  const int* size = renderWindow()->GetSize();
  const QSize now(size[0], size[1]);
  if (now != std::exchange(attached_px_, now)) scene_->attach(renderWindow());
  QVTKOpenGLNativeWidget::paintGL();
}

}  // namespace facenav::ui
