#pragma once
// The person in the virtual room for a case: its MRI, modelled by the room's own skin finder, so that the
// truth does not share the workstation's errors. If that finds no head, the case's scalp is used.

#include "context.h"
#include "facenav/casefile/case_store.h"
#include "facenav/room/virtual_patient.h"

namespace facenav::app {

/// Makes the patient. Reports on stderr (unless quiet) if the scalp was used.
room::VirtualPatient roomPatient(Context& context, const casefile::CaseStore& store,
                                 const room::PatientOptions& options);

}  // namespace facenav::app
