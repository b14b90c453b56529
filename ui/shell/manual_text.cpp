#include "shell/manual_text.h"

#include <QDir>
#include <QImage>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>

#include "facenav/core/data_folder.h"

namespace facenav::ui {
namespace {

constexpr int kMargins_px = 60;  // of the window and the page, with the scroll bar

QString fileOf(const QString& picture) { return QDir(manualPictures()).filePath(picture); }

/// The page with its pictures in place of the comments that ask for them, without other comments.
QString withPictures(QString markdown) {
  static const QRegularExpression kPicture("^<!-- picture: (\\S+) (.+?) -->$",
                                           QRegularExpression::MultilineOption);
  QString page;
  int written = 0;
  for (auto it = kPicture.globalMatch(markdown); it.hasNext();) {
    const auto asked = it.next();
    page += markdown.mid(written, asked.capturedStart() - written);
    written = asked.capturedEnd();
    const QString name = asked.captured(1) + ".png", words = asked.captured(2);
    if (QFile::exists(fileOf(name))) page += "![" + words + "](" + name + ")\n\n*" + words + "*";
  }
  static const QRegularExpression kComment("^<!-- .* -->$", QRegularExpression::MultilineOption);
  page += markdown.mid(written);
  return page.remove(kComment);
}

}  // namespace

QString manualPictures() {
  const auto shared = dataFolder().parent_path();
  return QString::fromStdString((shared / "doc" / "facenav" / "manual" / "html" / "_images").string());
}

QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar c : heading.toLower())
    if (c == ' ')
      anchor += '-';
    else if (c.isLetterOrNumber() || c == '-' || c == '_')
      anchor += c;
  return anchor;
}

bool hasHeading(const QTextDocument& page, const QString& anchor) {
  for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
    if (block.blockFormat().headingLevel() > 0 && anchorOf(block.text()) == anchor) return true;
  return false;
}

void ManualText::showPage(const QString& markdown) { setMarkdown(withPictures(markdown)); }

QVariant ManualText::loadResource(int type, const QUrl& name) {
  if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
  const QImage picture(fileOf(name.fileName()));
  const int widest_px = window()->width() - kMargins_px;
  return picture.width() > widest_px ? picture.scaledToWidth(widest_px, Qt::SmoothTransformation) : picture;
}

}  // namespace facenav::ui
