#pragma once
// JoinedSlices: the finding that a series' slices carry a Series Instance UID each, as some anonymisers leave
// them, and were put together by what agrees. A Series Instance UID has to be one for the whole series
// (PS3.3 C.7.3.1), so such files break the standard; that they belong together is inferred, not stated.
// Code asks the struct, `findingId` names it in files, `inWords` says it to people.

#include <string>
#include <vector>

namespace facenav::dicom {

struct SeriesInfo;

/// What the slices' headers may say of the scan they belong to. Modality, scanner, contrast agent,
/// TR, TI, flip angle, orientation, matrix, pixel spacing and slice thickness agree in any case.
enum class SliceTrait { patient, series_number, series_time, description };

struct JoinedSlices {
  std::string series_uid;                         // stands for all: the first of theirs in alphabetical order
  std::string study_uid, frame_of_reference_uid;  // of the slice that carries `series_uid`
  int series_uids = 0, study_uids = 0;            // different ones among the slices
  int frame_of_reference_uids = 0;                // of these; where not one, no UID says that the positions
                                                  // share a frame of reference
  std::vector<SliceTrait> agreeing;               // stated by the slices, the same in all
  std::vector<SliceTrait> unstated;               // empty or left out in all
  int readings = 1;                               // ways to read the same slices, this one included; more
                                                  // than one: only a person can say which is meant
};

/// True where the same slices can be read in several ways.
bool isOneOfSeveralReadings(const SeriesInfo& series);
/// How many loadable entries of `series` are such readings.
int readingCount(const std::vector<SeriesInfo>& series);

/// "slices_joined", or "slices_joined_in_several_ways".
std::string findingId(const JoinedSlices& joined);
/// "252 slices with a series UID each were joined: series number, .. agree. That they ..".
std::string inWords(const JoinedSlices& joined);

/// "patient", "series number", "series time", "description".
std::string toString(SliceTrait trait);

}  // namespace facenav::dicom
