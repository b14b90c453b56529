#pragma once
// Groups files by patient: those that agree in Patient ID, name (ignoring capitals and separators) and birth
// date. Any difference makes two patients: an unneeded question costs a click, the wrong head costs a
// treatment. One exception: some anonymisers give every file of a series another identity.

#include <vector>

#include "slice_header.h"

namespace facenav::dicom {

bool isSamePatient(const Patient& a, const Patient& b);
/// Fills patient_number: 1, 2, .. in the order of the headers. The images of a series UID get one number if
/// each of them names a patient of whom there is no other image (has_scattered_identity is then set).
void numberPatients(std::vector<SliceHeader>& headers);

}  // namespace facenav::dicom
