#include "shell/about_words.h"

#include <QCoreApplication>
#include <QObject>
#include <QSysInfo>

#include "facenav/core/licences.h"

namespace facenav::ui {
namespace {

QString cell(const std::string& text) {
  return "<td>" + QString::fromStdString(text).toHtmlEscaped() + "</td>";
}

/// "Built for x86_64 by GCC 12.2.0, with Qt 5.15.8".
QString buildInWords() {
#ifdef __clang__
  const QString compiler = "Clang " __clang_version__;
#else
  const QString compiler = "GCC " __VERSION__;
#endif
  return QObject::tr("Built for %1 by %2, with Qt %3")
      .arg(QSysInfo::buildCpuArchitecture(), compiler, QString(QT_VERSION_STR));
}

QString useInWords(PartUse use) {
  switch (use) {
    case PartUse::linked:
      return QObject::tr("linked");
    case PartUse::linked_in_lab:
      return QObject::tr("linked in facenav-lab");
    case PartUse::compiled_in:
      return QObject::tr("compiled in");
    case PartUse::data:
      return QObject::tr("data");
    case PartUse::run:
      return QObject::tr("run");
  }
  return {};
}

}  // namespace

QString aboutAsHtml() {
  QString html = "<h1>FaceNav</h1><p>" +
                 QObject::tr("Version %1").arg(QCoreApplication::applicationVersion().toHtmlEscaped()) +
                 "<br>" + buildInWords().toHtmlEscaped() + "</p><p>" +
                 QObject::tr(
                     "Licence: <a href='LICENSE.md'>Apache-2.0</a>. Not a medical device: for research "
                     "and development. <a href='safety.md'>Safety</a>, <a href='privacy.md'>privacy</a>.") +
                 "</p><h2>" + QObject::tr("Parts that others made") + "</h2><table cellpadding='3'>";
  for (const LicensedPart& part : licensedParts())
    html += "<tr>" + cell(part.name) + cell(upstreamVersion(part.version)) + cell(part.licence) +
            cell(useInWords(part.use).toStdString()) + "</tr>";
  return html + "</table><p>" +
         QObject::tr("'facenav licences --spdx' writes this list as a bill of materials.") + "</p>";
}

}  // namespace facenav::ui
