#pragma once
// The patient of a series. Lists carry only a number per patient (SeriesInfo::patient), so that no name is
// shown or kept without request. The name is read from the file on request.

#include <string>
#include <vector>

#include "facenav/dicom/series.h"

namespace facenav::dicom {

/// A patient as in the files (PS3.3 C.7.1.1); any field may be empty.
struct Patient {
  std::string name;        // "Family^Given^Middle^Prefix^Suffix", the alphabetic group where it has one
  std::string id;          // Patient ID
  std::string birth_date;  // YYYY-MM-DD or empty
  std::string sex;         // "M", "F", "O" or empty
};

/// Reads the patient from the series' first file. Throws Error naming it if it cannot be read.
Patient patientOf(const SeriesInfo& series);
/// Name for display: "Family, Given Middle"; the ID if there is no name; empty if there is neither.
std::string nameInWords(const Patient& patient);
/// One line: "Family, Given, born 1970-01-31, F, ID 4711"; "no patient named" if the files name none.
std::string inWords(const Patient& patient);

/// Number of patients among the images of `series`. Images without a name count as one more patient, since
/// they may show anyone's head.
int patientCount(const std::vector<SeriesInfo>& series);

}  // namespace facenav::dicom
