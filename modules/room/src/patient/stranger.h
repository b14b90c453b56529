#pragma once
// Another person, made from the patient: other proportions, other soft tissue, another complexion, the
// portrait's sides exchanged. Near enough to be taken for the patient by a careless tracker, and not the
// patient.

#include <memory>

#include "facenav/room/virtual_patient.h"

namespace facenav::room {

/// In the same Mri coordinates as `patient`, so that it can be put on the same seat. `seed`: which person.
std::shared_ptr<const VirtualPatient> strangerLike(const VirtualPatient& patient, std::uint64_t seed);

}  // namespace facenav::room
