#pragma once
// LiveSlices: the two slices along the live coil's axis, one above the other. They follow every new state; if
// head or coil is lost or outdated they are removed, and words give the reason.

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
  /// Shows the MRI of a case with the usual window.
  void show(const LoadedCase& loaded);
  /// Follows a state. `words`: shown in place of the slices unless head and coil are both tracked in `state`.
  /// `bound95_mm`: bound of the error at the state's target; empty if not known.
  void follow(const session::NavigationState& state, const QString& words,
              std::optional<double> bound95_mm = {});
  const std::array<CoilSliceView*, 2>& views() const { return views_; }

 private:
  std::array<CoilSliceView*, 2> views_;
  std::shared_ptr<scene::SliceScene> scene_;
  guidance::CoilPlate plate_ = guidance::figureOfEight();
};

}  // namespace facenav::ui
