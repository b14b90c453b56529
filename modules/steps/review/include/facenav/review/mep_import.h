#pragma once
// Assigns MEPs measured by another device to a session's pulses by time. The file is CSV with the columns utc
// (ISO 8601) or t_s (seconds on any clock), mep_uv, and optionally latency_ms. The two clocks may differ by
// an offset: it is given, or found as the one under which most rows meet a pulse. Where two offsets fit
// nearly alike (pulses at even intervals), the import is refused. An XDF recording (LabRecorder) with markers
// and EMG is such a file, too: each marker's MEP is measured from the EMG that follows it.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"
#include "facenav/core/setting.h"

namespace facenav::steps {

struct MepImportLimits {
  static constexpr const char* kModule = "workflow";
  static constexpr const char* kSubject = "MEPs by time";
  double mep_same_time_s = 0.2, mep_second_offset = 0.8, emg_from_ms = 15, emg_to_ms = 50;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kTime("mep_same_time_s", 0.001, 2, "s", "an MEP this close to a pulse belongs to it"),
            self.mep_same_time_s);
    visitor(
        kSecond("mep_second_offset", 0.1, 1, "1",
                "a clock offset counts as found only if the next best fits at most this share of its rows"),
        self.mep_second_offset);
  }
  static constexpr Evidence kTime{Origin::chosen,
                                  "below half the shortest interval at which MEPs are taken (1 s), above the "
                                  "jitter of a trigger noted by software; nothing compared"};
  static constexpr Evidence kSecond{
      Origin::chosen, "10 pulses at even intervals fit 9 of 10 one interval later and must be refused"};
  static constexpr Evidence kWindow{
      Origin::chosen,
      "MEPs of hand and forearm begin 18 to 25 ms after the pulse and last some 20; its artefact is over by "
      "15; a leg's muscle needs a later end; nothing compared"};
};

struct MepRow {
  double t_s = 0;  // on the file's clock; seconds since 1970 if the file has utc
  double mep_uv = 0;
  std::optional<double> latency_ms;
  int line = 0;  // in the file; of an XDF: the marker's number
};
struct MepFile {
  std::string name;  // without its folders
  std::vector<MepRow> rows;
  bool is_utc = false;
  bool is_own_clock = false;       // the times are FaceNav's own: no offset is sought
  const char* row_word = "line";   // what `line` counts
  std::vector<std::string> notes;  // what was taken, and what was left out
};
/// What to take from an XDF recording; what is empty is found, where only one fits.
struct XdfChoice {
  std::string emg;      // "STREAM" or "STREAM:CHANNEL", the channel by its label or number (from 1)
  std::string markers;  // "STREAM" or "STREAM:MARKER"
  std::string unit;     // uV, mV or V, where the stream does not say it
};
/// Reads "EMG:FDI; Pulses:T; mV", each part may be empty. Throws Error for more parts, or another unit.
XdfChoice xdfChoiceFrom(const std::string& words);
/// Reads the file, CSV or XDF; rows without an MEP are left out. Throws Error naming file and line: no such
/// column, no number, an invalid time; no EMG or no markers, or several that fit.
MepFile readMepFile(const std::filesystem::path& file, const XdfChoice& choice = {},
                    const MepImportLimits& limits = {});

struct MepMatch {
  std::vector<casefile::MepEdit> edits;  // one per matched pulse
  double offset_s = 0;                   // pulse's time = row's time + offset
  int fits = 0, next_best_fits = 0;      // rows that meet a pulse; under the next best offset (0 if given)
  bool is_offset_found = false;
  double largest_off_ms = 0;          // of the matched rows, after the offset
  std::vector<std::string> left_out;  // descriptions of rows that meet no pulse, or several
};

/// Matches rows and pulses. `offset_s`: nothing: it is searched. Throws Error: no row or no pulse with a
/// time, no offset fits at least 3 rows and half of all, or two fit nearly alike.
MepMatch matchMeps(const MepFile& file, const std::vector<casefile::ReviewedPulse>& pulses,
                   std::optional<double> offset_s, const MepImportLimits& limits);
/// Returns "12 MEPs from emg.csv; clock offset +3.214 s (found: 12 of 12 rows fit, 3 under the next best)".
std::string mepMatchWords(const MepMatch& match, const MepFile& file);

}  // namespace facenav::steps
