#include "shell/author.h"

#include <QSettings>

namespace facenav::ui {
namespace {

const char* const kAuthor = "sign_off/by";  // asked for by the sign-off first

}  // namespace

QString author() { return QSettings().value(kAuthor).toString(); }

void rememberAuthor(const QString& name) {
  const QString given = name.trimmed();
  if (!given.isEmpty()) QSettings().setValue(kAuthor, given);
}

std::string recordedAuthor() {
  const QString known = author();
  return known.isEmpty() ? qgetenv("USER").toStdString() : known.toStdString();
}

}  // namespace facenav::ui
