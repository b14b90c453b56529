#pragma once
// ManualText: shows a page of the manual with the pictures that the program made for it, where they are
// installed. A page asks for one in a comment: <!-- picture: NAME words that describe it -->.

#include <QTextBrowser>

namespace facenav::ui {

class ManualText : public QTextBrowser {
 public:
  explicit ManualText(QWidget* parent) : QTextBrowser(parent) {}
  /// Shows the page. Leaves out a picture that is not there.
  void showPage(const QString& markdown);

 protected:
  /// Gives a picture at most the window's width.
  QVariant loadResource(int type, const QUrl& name) override;
};

/// Folder of the manual's pictures, NAME.png; it may be missing.
QString manualPictures();
/// True if the page has a heading with this anchor, "in-the-window".
bool hasHeading(const QTextDocument& page, const QString& anchor);
/// A heading's anchor, as the manual's links name it.
QString anchorOf(const QString& heading);

}  // namespace facenav::ui
