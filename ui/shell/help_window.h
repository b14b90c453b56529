#pragma once
// HelpWindow: a window beside the main one that shows a page of the manual (resources/doc, compiled in), the
// list of shortcuts, or About. It does not hold up the window that it belongs to.

#include <QWidget>
#include <functional>

class QPushButton;
class QUrl;

namespace facenav::ui {

class ManualText;

class HelpWindow : public QWidget {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent);

  /// The help window that belongs to `window`; made at the first call.
  static HelpWindow& of(QWidget& window);
  /// Lets F1 open this place of the manual in `window`, or the place of the part that has the focus.
  static void addKey(QWidget& window, const QString& page, const QString& heading);
  /// Does the same; it asks for the heading when the key is pressed.
  static void addKey(QWidget& window, const QString& page, const std::function<QString()>& heading);
  /// Gives a part of a window its own place in the manual.
  static void setPlace(QWidget& part, const QString& page, const QString& heading);
  /// Shows the place of the part, or of the nearest one around it that has a place. Returns false if none in
  /// `window` has one.
  static bool showPlaceOf(const QWidget* part, QWidget& window);

  /// Shows a page of the manual, "plan.md", from the heading with this anchor on, "in-the-window". Shows the
  /// list of pages if there is no such page.
  void showPage(const QString& page, const QString& heading = {});
  void showHtml(const QString& title, const QString& html);
  /// The page shown; empty for other text.
  QString page() const { return page_; }
  /// Anchor of the heading that the page was opened at; empty if it has no such heading.
  QString heading() const { return heading_; }
  /// The text shown, without its form.
  QString text() const;

 private:
  void follow(const QUrl& link);
  void goBack();
  void goToHeading(const QString& heading);
  void present();

  ManualText* text_;
  QPushButton* back_;
  QString page_, heading_;
  QStringList earlier_;
};

}  // namespace facenav::ui
