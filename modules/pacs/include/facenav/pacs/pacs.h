#pragma once
// The hospital's archive over the DICOM network (PS3.7, PS3.4 annexes A-C; DCMTK does the protocol): is it
// there, which series does it hold, fetch one, send results back. What comes in is files in a folder, trusted
// no more than a folder on a CD: dicom::listSeries reads them next. Calls block; each may be cancelled
// through its monitor.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"

namespace facenav::pacs {

/// TLS as PS3.15 B.9 (BCP 195) wants it; PEM files.
struct Tls {
  std::filesystem::path trusted_certificate;  // of the archive, or of who signed it
  std::filesystem::path certificate, key;     // our own; both empty where the archive does not ask for it
};

struct PacsNode {
  std::string host = "127.0.0.1";
  int port = 104;
  std::string title = "ANY-SCP";      // the archive's application entity title, 1 to 16 characters
  std::string own_title = "FACENAV";  // ours, as the archive knows it
  int own_port = 11112;               // where the archive sends to on C-MOVE
  int timeout_s = 30;
  std::optional<Tls> tls;
};

/// C-ECHO. Throws Error in plain words: nobody answers, the title is not known there, ..
void echo(const PacsNode& node);

/// Empty fields match anything; * and ? are wildcards; a date is YYYYMMDD or a range YYYYMMDD-YYYYMMDD.
struct PacsQuery {
  std::string patient_id, patient_name, study_date, study_uid, modality = "MR";
};

struct PacsSeries {
  std::string study_uid, series_uid, study_description, description, modality;
  std::string date;                      // YYYY-MM-DD or empty
  int images = 0;                        // 0 where the archive does not say
  std::string patient_id, patient_name;  // shown only to who asked for it
};

/// C-FIND, study root, studies first. Throws Error; a query without any field but the modality is refused.
std::vector<PacsSeries> findSeries(const PacsNode& node, const PacsQuery& query, TaskMonitor& monitor);

enum class Retrieval {
  automatic,  // C-GET, and C-MOVE where the archive offers none
  get,
  move  // the archive connects to `own_port`, where it must know `own_title`
};

struct Received {
  int images = 0;
  Retrieval how = Retrieval::get;
};

/// Fetches a series into `folder`, which must be empty or absent: whole or not at all, files 0600 under names
/// of our own. Throws Error: not there, refused, some images failed, too many, the connection broke.
Received retrieve(const PacsNode& node, const std::string& study_uid, const std::string& series_uid,
                  const std::filesystem::path& folder, Retrieval how, TaskMonitor& monitor);

/// C-STORE of the DICOM files under `input` (a file, or a folder with all below it). Throws Error naming the
/// first file that was not taken; those before it are stored then.
int store(const PacsNode& node, const std::filesystem::path& input, TaskMonitor& monitor);

}  // namespace facenav::pacs
