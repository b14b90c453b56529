#pragma once
// --patient-confirmed: a person's word that the case is that of the patient in view.

#include <CLI/CLI.hpp>

namespace facenav::app {

/// Adds the flag to a verb that aligns.
inline void addConfirmationOption(CLI::App& verb, bool& is_confirmed) {
  verb.add_flag("--patient-confirmed", is_confirmed,
                "name and date of birth were checked: the case is this patient's. Counts only where the face "
                "fits the MRI, but was measured too coarsely to tell people apart; the alignment says so");
}

}  // namespace facenav::app
