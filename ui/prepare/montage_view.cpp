#include "prepare/montage_view.h"

#include <QLabel>
#include <QMouseEvent>
#include <QScrollBar>

#include "shell/appearance.h"
#include "shell/image_view.h"

namespace facenav::ui {
namespace {

constexpr int kRedraw_ms = 120;

}  // namespace

MontageView::MontageView(QWidget* parent) : QScrollArea(parent), sheet_(new QLabel(this)) {
  setObjectName("montage");
  setAccessibleName(tr("slices through the brain"));
  setWidget(sheet_);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(
      Qt::ScrollBarAlwaysOff);  // the sheet fits the width; the wheel scrolls a taller one
  sheet_->installEventFilter(this);
  sheet_->setToolTip(tr("skin orange, brain blue; double click: look at this place on the large slices"));
  soon_.setSingleShot(true);
  soon_.setInterval(kRedraw_ms);
  connect(&soon_, &QTimer::timeout, this, &MontageView::draw);
  whenTextScales(this, [this] {
    scene_.text_scale = sized(100) / 100.0;
    if (content_) soon_.start();
  });
}

void MontageView::show(const LoadedCase& loaded) {
  scene_ = {};
  scene_.mri = loaded.mri;
  scene_.text_scale = sized(100) / 100.0;
  scene::setUsualWindow(scene_);
  scene_.contours = {{loaded.head_mask, scene::palette::kOrange}};
  const auto& brain = loaded.shownBrain();
  if (brain) scene_.contours.push_back({brain, scene::palette::kBlue});
  content_ = brain ? brain : loaded.head_mask;
  draw();
}

void MontageView::draw() {
  if (!content_) return;
  montage_ =
      scene::contourMontage(scene_, *content_, scene::sheetFor(viewport()->width(), viewport()->height()));
  sheet_->setPixmap(QPixmap::fromImage(toQImage(montage_.picture)));
  sheet_->adjustSize();
}

void MontageView::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  soon_.start();
}

bool MontageView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != sheet_ || event->type() != QEvent::MouseButtonDblClick)
    return QScrollArea::eventFilter(watched, event);
  const QPoint at = static_cast<QMouseEvent*>(event)->pos();
  for (const auto& tile : montage_.tiles)
    if (QRect(tile.u, tile.v, montage_.tile_px, montage_.tile_px).contains(at))
      emit chosen(tile.centre.mm.x(), tile.centre.mm.y(), tile.centre.mm.z());
  return true;
}

}  // namespace facenav::ui
