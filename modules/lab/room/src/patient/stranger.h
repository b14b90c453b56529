#pragma once
// Another person, derived from the patient: other proportions, other soft tissue, another complexion, the
// portrait mirrored. Similar enough that a tracker without an identity check may take this person for the
// patient.

#include <memory>

#include "facenav/room/virtual_patient.h"

namespace facenav::room {

/// Makes the stranger in the Mri coordinates of `patient`, so that both can be seated alike. `seed` selects
/// the person.
std::shared_ptr<const VirtualPatient> strangerLike(const VirtualPatient& patient, std::uint64_t seed);

}  // namespace facenav::room
