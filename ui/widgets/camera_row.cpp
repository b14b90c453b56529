#include "widgets/camera_row.h"

#include <QHBoxLayout>

#include "views/image_view.h"

namespace facenav::ui {

CameraRow::CameraRow(QWidget* parent)
    : QWidget(parent),
      left_(new ImageView(tr("left camera"), this)),
      right_(new ImageView(tr("right camera"), this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(left_);
  row->addWidget(right_);
}

void CameraRow::clear() {
  still_.reset();
  if (is_empty_) return;
  is_empty_ = true;
  shown_.reset();
  left_->set({});
  right_->set({});
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
  if (!shown_ || !pictures::mayBeShown(*shown_, *now_)) clear();
}

void CameraRow::showDrawn(std::shared_ptr<const pictures::DrawnOverlay> drawn) {
  if (!now_ || !pictures::mayBeShown(*drawn, *now_)) return;
  shown_ = std::move(drawn);
  still_.reset();
  is_empty_ = false;
  const QString failure = QString::fromStdString(shown_->failure);
  left_->set(toQImage(shown_->overlay.left), failure);
  right_->set(toQImage(shown_->overlay.right), failure);
}

}  // namespace facenav::ui
