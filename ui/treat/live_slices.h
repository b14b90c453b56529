#pragma once
// LiveSlices: the two slices along the live coil's axis, one above the other. They follow every new state;
// when head or coil is lost or old they go, and words say why.

#include <QWidget>
#include <array>
#include <memory>

#include "facenav/session/navigation_state.h"
#include "plan/coil_slice_view.h"
#include "shell/case_model.h"

namespace facenav::ui {

class LiveSlices : public QWidget {
  Q_OBJECT

 public:
  explicit LiveSlices(QWidget* parent = nullptr);
  /// MRI of a case, with the usual window.
  void show(const LoadedCase& loaded);
  /// `words`: shown in place of the slices unless head and coil are both tracked in `state`. `bound95_mm`: of
  /// the error at the state's target; nothing: not known.
  void follow(const session::NavigationState& state, const QString& words,
              std::optional<double> bound95_mm = {});
  const std::array<CoilSliceView*, 2>& views() const { return views_; }

 private:
  std::array<CoilSliceView*, 2> views_;
  std::shared_ptr<scene::SliceScene> scene_;
  guidance::CoilPlate plate_ = guidance::figureOfEight();
};

}  // namespace facenav::ui
