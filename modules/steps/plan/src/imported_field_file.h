#pragma once
// Files of imported fields in a case: imported_fields.json, and the values of each as a mesh of gmsh 2.2.
// Private to plan.

#include "facenav/efield/field_msh.h"
#include "facenav/plan/imported_field.h"

namespace facenav::steps {

/// Writes the values under a new name and the list with this field in place of the target's old one, then
/// removes the old values. Sets field.file. Throws Error.
void keepImportedField(const casefile::CaseStore& store, ImportedField& field,
                       const efield::FieldSamples& samples);

/// True if both are one pose, within the digits of a file.
bool isSamePlace(const RigidTransform<Mri, frames::Target>& a, const RigidTransform<Mri, frames::Target>& b);

}  // namespace facenav::steps
