#pragma once
// What a derived object repeats of its source, and what every derived object states about itself.

#include <gdcmDataSet.h>

#include <string>
#include <vector>

#include "facenav/dicom/series.h"
#include "header/slice_header.h"

namespace facenav::dicom {

/// A new UID under 2.25: a random UUID (version 4) as a decimal number (PS3.5 B.2).
std::string newUid();

/// Throws Error unless the source's files name one patient, the same in all of them, and a study.
void requireOneIdentity(const std::vector<SliceHeader>& source);

/// Copies character set, patient and study as the source's bytes state them. `series` is the source's: its
/// study counts where every image has a study UID of its own.
void copyPatientAndStudy(const gdcm::DataSet& from, const SeriesInfo& series, gdcm::DataSet& to);
/// Copies how an MR image was measured; what the standard requires and the source lacks is put as unknown.
void copyMeasurement(const gdcm::DataSet& from, gdcm::DataSet& to);
/// Puts class, instance and series, the equipment (FaceNav) and the time of now.
void putOwnIdentity(gdcm::DataSet& to, const char* sop_class, const std::string& series_uid,
                    const char* modality, int series_number);

/// Puts a reference to the image that something was made from; `frame` counts from 0, of a file of several.
void putSourceImage(gdcm::DataSet& to, const SliceHeader& source, int frame);
/// Frame of reference of the source; empty if it states none.
std::string frameOfReferenceOf(const gdcm::DataSet& from, const SeriesInfo& series);

/// `text` (UTF-8) as the data set's character set can hold it: unchanged in UTF-8, else '?' for what is not
/// ASCII. At most `most` characters, without backslashes and control characters.
std::string textFor(const gdcm::DataSet& data, const std::string& text, std::size_t most);

}  // namespace facenav::dicom
