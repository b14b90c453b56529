#include "treat/camera_row.h"

#include <QHBoxLayout>

#include "shell/image_view.h"
#include "shell/shown_words.h"

namespace facenav::ui {

CameraRow::CameraRow(QWidget* parent)
    : QWidget(parent),
      left_(new ImageView(tr("left camera"), this)),
      right_(new ImageView(tr("right camera"), this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(left_);
  row->addWidget(right_);
  using stereo::PictureSide;
  for (const auto& [view, side] : {std::pair(left_, PictureSide::left), {right_, PictureSide::right}})
    connect(view, &ImageView::clicked, this, [this, side = side](const QPointF& px) {
      if (shown_ && shown_->failure.empty()) emit picked(side, px, shown_->state);
    });
}

void CameraRow::clear(const QString& why) {
  still_.reset();
  if (is_empty_ && why == why_empty_) return;
  is_empty_ = true;
  why_empty_ = why;
  shown_.reset();
  left_->set({}, why);
  right_->set({}, why);
}

QString CameraRow::lateWords(const pictures::DrawnOverlay& drawn) const {
  if (!pictures::isTooOld(drawn, *now_)) return {};
  return tr(
      "The picture comes too late and is not shown. This computer draws too slowly: close other programs.");
}

void CameraRow::showPlain(const cameras::StereoFrame& frame) {
  now_.reset();
  shown_.reset();
  still_.reset();
  is_empty_ = false;
  left_->set(toQImage(frame.left.data, frame.left.cols, frame.left.rows, int(frame.left.step)));
  right_->set(toQImage(frame.right.data, frame.right.cols, frame.right.rows, int(frame.right.step)));
}

void CameraRow::showStill(std::shared_ptr<const pictures::CameraOverlay> still) {
  if (still_ == still) return;
  now_.reset();
  shown_.reset();
  is_empty_ = false;
  still_ = std::move(still);
  left_->set(toQImage(still_->left));
  right_->set(toQImage(still_->right));
}

void CameraRow::follow(std::shared_ptr<const session::NavigationState> now) {
  now_ = std::move(now);
  if (!shown_)
    clear(is_empty_ ? why_empty_ : QString());
  else if (!pictures::mayBeShown(*shown_, *now_))
    clear(lateWords(*shown_));
}

void CameraRow::showDrawn(std::shared_ptr<const pictures::DrawnOverlay> drawn) {
  if (!now_) return;
  if (!pictures::mayBeShown(*drawn, *now_)) {
    if (is_empty_) clear(lateWords(*drawn));
    return;
  }
  shown_ = std::move(drawn);
  still_.reset();
  is_empty_ = false;
  const QString failure = shownWords(shown_->failure);
  left_->set(toQImage(shown_->overlay.left), failure);
  right_->set(toQImage(shown_->overlay.right), failure);
}

}  // namespace facenav::ui
