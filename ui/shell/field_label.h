#pragma once
// A label that names a field: its shortcut leads there, and screen readers say its words.

#include <QLabel>

namespace facenav::ui {

/// Makes the label of `field`. `words` may hold a shortcut (&).
inline QLabel* fieldLabel(const QString& words, QWidget* field, QWidget* parent) {
  auto* label = new QLabel(words, parent);
  label->setBuddy(field);
  field->setAccessibleName(QString(words).remove('&'));
  return label;
}

}  // namespace facenav::ui
