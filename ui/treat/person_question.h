#pragma once
// PersonQuestion: asks who sits in the chair, where the face was measured too coarsely to tell people apart.

#include <QString>
#include <QWidget>
#include <functional>

namespace facenav::ui {

/// Asks, without holding up the window, whether the person is the patient of the case. `name`: the case's;
/// `why`: the refusal of the alignment. Calls `confirmed` only if a person says yes; closing it means no.
void askForPerson(QWidget& parent, const QString& name, const QString& why, std::function<void()> confirmed);

}  // namespace facenav::ui
