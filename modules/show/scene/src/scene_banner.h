#pragma once
// SceneBanner: a short text over the 3-D view, near its top. It always fits into the view: too long a line is
// broken at its spaces, and only then made smaller. Private to scene.

#include <vtkNew.h>
#include <vtkTextActor.h>

#include <array>
#include <string>

class vtkViewport;

namespace facenav::scene {

class SceneBanner {
 public:
  SceneBanner();
  vtkTextActor* actor() { return actor_; }
  /// Sets the text; empty: hidden.
  void setWords(const std::string& words);
  /// Sets the text size, as a factor of the usual one.
  void setTextScale(double scale);
  /// Fits the text to the present size of `viewport`, which must belong to a window. Call it before each
  /// rendering; it returns at once if nothing has changed.
  void fit(vtkViewport* viewport);

 private:
  bool fitsInto(vtkViewport* viewport, const std::string& lines, int font_size);

  vtkNew<vtkTextActor> actor_;
  std::string words_;
  double text_scale_ = 1.0;
  bool is_outdated_ = true;
  std::array<int, 2> fitted_to_px_{0, 0};
};

/// Breaks `words` at spaces into at most `count` lines of about equal length.
std::string inLines(const std::string& words, int count);

}  // namespace facenav::scene
