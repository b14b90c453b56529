#include "shell/typed_number.h"

#include "facenav/core/number_text.h"

namespace facenav::ui {

std::optional<double> typedNumber(const QString& typed) {
  QString text = typed.trimmed();
  text.replace(QChar(0x2212), '-');  // the typographic minus sign
  return numberIn(text.replace(',', '.').toStdString());
}

}  // namespace facenav::ui
