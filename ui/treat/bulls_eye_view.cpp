#include "treat/bulls_eye_view.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "shell/appearance.h"
#include "shell/theme.h"

namespace facenav::ui {

BullsEyeView::BullsEyeView(QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), bulls_eye_(std::make_unique<scene::BullsEye>()) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(4);
  setRenderWindow(window);
  window->AddRenderer(bulls_eye_->renderer());
  whenThemeChanges(this, [this] {
    bulls_eye_->setColours({themeRgb(Colour::panel), themeRgb(Colour::ground), themeRgb(Colour::line),
                            themeRgb(Colour::text), themeRgb(Colour::good), themeRgb(Colour::caution)});
    if (isVisible()) renderWindow()->Render();
  });
  whenTextScales(this, [this] { setMinimumSize(sized(180), sized(180)); });
  setFocusPolicy(Qt::NoFocus);  // nothing to do there
  setAccessibleName(tr("bull's eye"));
  setToolTip(
      tr("Centre: the target. Cross: the coil, seen along the coil into the head, handle below. "
         "Stroke: tilt, one ring is 5 mm or 5\u00b0. Tick on the rim: twist."));
}

BullsEyeView::~BullsEyeView() = default;

void BullsEyeView::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  bulls_eye_->fit(width(), height());
}

void BullsEyeView::set(const guidance::GuidanceState& guidance) {
  bulls_eye_->set(guidance);
  if (isVisible()) renderWindow()->Render();
}

}  // namespace facenav::ui
