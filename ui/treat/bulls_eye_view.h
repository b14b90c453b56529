#pragma once
// BullsEyeView: scene::BullsEye in a widget.

#include <QVTKOpenGLNativeWidget.h>

#include <memory>

#include "facenav/scene/bulls_eye.h"

namespace facenav::ui {

class BullsEyeView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit BullsEyeView(QWidget* parent = nullptr);
  ~BullsEyeView() override;
  void set(const guidance::GuidanceState& guidance);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::unique_ptr<scene::BullsEye> bulls_eye_;
};

}  // namespace facenav::ui
