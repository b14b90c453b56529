#pragma once
// JoinedSlices: the finding that each slice of a series carries its own Series Instance UID, as some
// anonymisers write them, and that the slices were joined by other attributes. The standard requires one UID
// for the whole series (PS3.3 C.7.3.1), so such files break it. That they belong together is inferred, not
// recorded in the files. Code reads the struct, `findingId` names it in files, `inWords` describes it to
// users.

#include <string>
#include <vector>

namespace facenav::dicom {

struct SeriesInfo;

/// Attributes of the slices' headers that may agree. Modality, scanner, contrast agent, TR, TI, flip angle,
/// orientation, matrix, pixel spacing and slice thickness always agree.
enum class SliceTrait { patient, series_number, series_time, description };

struct JoinedSlices {
  std::string series_uid;  // UID for all: the first of their UIDs in alphabetical order
  std::string study_uid, frame_of_reference_uid;  // UIDs of the slice with `series_uid`
  int series_uids = 0, study_uids = 0;            // number of different UIDs among the slices
  // Number of different frames of reference. If not one, no UID shows that the positions share a frame.
  int frame_of_reference_uids = 0;
  std::vector<SliceTrait> agreeing;  // present and equal in all slices
  std::vector<SliceTrait> unstated;  // empty or absent in all slices
  int readings = 1;  // ways to read the same slices, this one included; with several, a person must choose
};

/// True if the same slices can be read in several ways.
bool isOneOfSeveralReadings(const SeriesInfo& series);
/// Number of loadable entries of `series` that are such readings.
int readingCount(const std::vector<SeriesInfo>& series);

/// Id for files: "slices_joined", or "slices_joined_in_several_ways".
std::string findingId(const JoinedSlices& joined);
/// Text for users: "252 slices with a series UID each were joined: series number, .. agree. That they ..".
std::string inWords(const JoinedSlices& joined);

/// Name of a trait: "patient", "series number", "series time", "description".
std::string toString(SliceTrait trait);

}  // namespace facenav::dicom
