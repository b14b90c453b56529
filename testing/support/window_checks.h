#pragma once
// Checks of a window as a person sees it: every text is whole, every part lies inside the window and beside
// its neighbours, and no button leaves the mouse. Faults come back in words, one each; no fault: no words.

#include <QAbstractButton>
#include <QPointer>
#include <QStringList>
#include <vector>

namespace facenav::testing {

/// Texts of labels, buttons, tabs, lists of choice, headings of tables and hints in fields that need more
/// room than they have. A shortened text is no fault if a person wrote it (ui/shell/users_words.h) and the
/// tool tip has the whole.
QStringList cutTexts(const QWidget& window);

/// Visible parts that lie outside the part around them, without a bar to scroll there, or over a neighbour.
QStringList misplacedParts(const QWidget& window);

/// Places of a window's buttons at one moment.
class ButtonPlaces {
 public:
  explicit ButtonPlaces(const QWidget& window);
  /// Buttons that are still in sight but lie more than 3 px elsewhere. `mouse`: where the mouse was pressed,
  /// in the window; a button under it must not be another one than before.
  QStringList moved(const QPoint& mouse) const;

 private:
  struct Place {
    QPointer<const QAbstractButton> button;
    QRect at;
  };
  static std::vector<Place> placesIn(const QWidget& window);
  const QWidget& window_;
  std::vector<Place> places_;
};

}  // namespace facenav::testing
