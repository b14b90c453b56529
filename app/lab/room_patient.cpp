#include "room_patient.h"

#include <cstdio>

namespace facenav::app {

room::VirtualPatient roomPatient(Context& context, const casefile::CaseStore& store,
                                 const room::PatientOptions& options) {
  try {
    return room::makePatient(store.mri(), options, context.monitor);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& fault) {
    if (!context.is_quiet)
      std::fprintf(
          stderr,
          "facenav: note: the room's own skin finder says \"%s\"; the case's scalp is the patient's skin\n",
          fault.what());
    return room::makePatient(store.scalp().mesh, options, context.monitor);
  }
}

}  // namespace facenav::app
