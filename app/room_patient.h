#pragma once
// Who sits in the virtual room for a case: its MRI through the room's own skin finder, so that the truth does
// not share the workstation's errors; where that finds no head, the case's scalp.

#include "context.h"
#include "facenav/casefile/case_store.h"
#include "facenav/room/virtual_patient.h"

namespace facenav::app {

/// Says so on stderr (unless quiet) where the scalp had to stand in.
room::VirtualPatient roomPatient(Context& context, const casefile::CaseStore& store,
                                 const room::PatientOptions& options);

}  // namespace facenav::app
