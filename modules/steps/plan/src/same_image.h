#pragma once
// Is a NIfTI that a user names the case's T1? Private to plan.

#include "facenav/casefile/case_store.h"
#include "facenav/interop/t1.h"

namespace facenav::steps {

/// Throws Error unless the NIfTI that the user named holds the case's image, in whatever world and order.
void requireSameImage(const casefile::CaseStore& store, const interop::T1& theirs, const interop::T1& ours);

}  // namespace facenav::steps
