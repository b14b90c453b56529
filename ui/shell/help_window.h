#pragma once
// HelpWindow: a window beside the main one that shows a page of the manual (resources/doc, compiled in), the
// list of shortcuts, or About. It does not hold up the window that it belongs to.

#include <QWidget>

class QPushButton;
class QTextBrowser;
class QUrl;

namespace facenav::ui {

class HelpWindow : public QWidget {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent);

  /// The help window that belongs to `window`; made at the first call.
  static HelpWindow& of(QWidget& window);
  /// Lets F1 open this place of the manual in `window`.
  static void addKey(QWidget& window, const QString& page, const QString& heading);

  /// Shows a page of the manual, "plan.md", from the heading with this anchor on, "in-the-window". Shows the
  /// list of pages if there is no such page.
  void showPage(const QString& page, const QString& heading = {});
  void showHtml(const QString& title, const QString& html);
  /// The page shown; empty for other text.
  QString page() const { return page_; }
  /// The text shown, without its form.
  QString text() const;

 private:
  void follow(const QUrl& link);
  void goBack();
  void goToHeading(const QString& heading);
  void present();

  QTextBrowser* text_;
  QPushButton* back_;
  QString page_;
  QStringList earlier_;
};

}  // namespace facenav::ui
