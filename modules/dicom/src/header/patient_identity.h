#pragma once
// Which files are of one patient: those that agree in Patient ID, name (capitals and separators aside) and
// birth date. Taken for two where anything differs: asking once more costs a click, the wrong head a
// treatment.

#include <vector>

#include "slice_header.h"

namespace facenav::dicom {

bool isSamePatient(const Patient& a, const Patient& b);
/// Fills patient_number: 1, 2, .. in the order of the headers.
void numberPatients(std::vector<SliceHeader>& headers);

}  // namespace facenav::dicom
