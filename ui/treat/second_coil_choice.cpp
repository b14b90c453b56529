#include "treat/second_coil_choice.h"

#include <QCoreApplication>

#include "facenav/coil_library/coil_library.h"
#include "facenav/core/error.h"

namespace facenav::ui {

QStringList SecondCoilChoice::names() {
  QStringList names;
  for (const auto& coil : coil_library::coilsIn(coil_library::coilLibrary()))
    if (coil.problem.empty()) names << QString::fromStdString(coil.name);
  return names;
}

void SecondCoilChoice::addTo(steps::TreatmentRequest& request) const {
  if (coil_.isEmpty()) return;
  steps::SecondCoilChoice second;
  second.coil = coil_library::findCoil(coil_library::coilLibrary(), coil_.toStdString()).model;
  coil_tracking::requireTellable(second.coil, request.coil);
  if (!target_.isEmpty())
    second.target =
        steps::chosenTarget(request.store.targets().find(target_.toStdString()), request.alignment.get());
  const std::string pulses = pulses_.toStdString();
  if (pulses != second.coil.name && pulses != request.coil.name)
    throw Error(
        QCoreApplication::translate("SecondCoilChoice",
                                    "two coils are followed: say which one gives the pulses (tool Session)")
            .toStdString());
  request.coil_of_source = {{"", pulses}};
  request.second = std::move(second);
}

}  // namespace facenav::ui
