#include "plan/typed_coordinates.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "shell/typed_number.h"

namespace facenav::ui {
namespace {

QString tr(const char* words) { return QCoreApplication::translate("facenav::ui", words); }

TypedCoordinates refused(const QString& why) { return {std::nullopt, why}; }

/// Reads numbers with points as decimal marks.
TypedCoordinates readNumbers(const QStringList& parts) {
  Eigen::Vector3d mm;
  bool is_number = parts.size() == 3;
  for (int i = 0; i < 3 && is_number; ++i) {
    const auto number = typedNumber(parts[i]);
    is_number = number.has_value();
    mm[i] = number.value_or(0);
  }
  if (is_number) return {mm, {}};
  return refused(tr("three numbers in mm are expected, such as -38 -22 56"));
}

/// Returns true if each comma can only be a decimal mark.
bool haveDecimalCommas(const QStringList& parts) {
  static const QRegularExpression kNumber("^[+-]?\\d+(,\\d+)?$");
  for (const QString& part : parts)
    if (!kNumber.match(part).hasMatch()) return false;
  return parts.size() == 3;
}

}  // namespace

std::optional<double> readNumber(const QString& typed, const QString& unit) {
  static const QRegularExpression kNumber("^[+-]?(\\d+([.,]\\d*)?|[.,]\\d+)$");
  QString text = typed.trimmed();
  if (text.endsWith(unit)) text = text.left(text.size() - unit.size()).trimmed();
  text.replace(QChar(0x2212), '-');
  if (!kNumber.match(text).hasMatch()) return std::nullopt;
  return typedNumber(text);
}

TypedCoordinates readCoordinates(const QString& typed) {
  static const QRegularExpression kBetween("\\s*;\\s*|\\s*,\\s+|\\s+,\\s*|\\s+");
  QString text = typed.trimmed();
  text.replace(QChar(0x2212), '-');  // the typographic minus sign
  QStringList parts = text.split(kBetween, Qt::SkipEmptyParts);
  if (!parts.join(QString()).contains(',')) return readNumbers(parts);
  if (haveDecimalCommas(parts)) return readNumbers(parts.replaceInStrings(",", "."));
  const QStringList by_commas = text.split(',');
  if (parts.size() == 1 && by_commas.size() == 3) return readNumbers(by_commas);
  return refused(tr("a comma here could be a decimal mark or part two numbers: type 12.5; -3; 40"));
}

}  // namespace facenav::ui
