#pragma once
// The hospital's archive over the DICOM network (PS3.7, PS3.4 annexes A-C; DCMTK implements the protocol):
// test the connection, find series, retrieve a series, send results. Received images are files in a folder
// and are not trusted: dicom::listSeries checks them next, as it checks a CD. Calls block; each can be
// cancelled through its monitor.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"

namespace facenav::pacs {

/// TLS as required by PS3.15 B.9 (BCP 195); PEM files.
struct Tls {
  std::filesystem::path trusted_certificate;  // certificate of the archive, or of its certificate authority
  std::filesystem::path certificate, key;     // our own; both empty if the archive does not require it
};

struct PacsNode {
  std::string host = "127.0.0.1";
  int port = 104;
  std::string title = "ANY-SCP";      // the archive's application entity title, 1 to 16 characters
  std::string own_title = "FACENAV";  // our title, as configured in the archive
  int own_port = 11112;               // port to which the archive sends on C-MOVE
  int timeout_s = 30;
  std::optional<Tls> tls;
};

/// Tests the connection by C-ECHO. Throws Error in plain words: no answer, title unknown to the archive, ..
void echo(const PacsNode& node);

/// Search criteria. Empty fields match anything; * and ? are wildcards; a date is YYYYMMDD or a range
/// YYYYMMDD-YYYYMMDD.
struct PacsQuery {
  std::string patient_id, patient_name, study_date, study_uid, modality = "MR";
};

struct PacsSeries {
  std::string study_uid, series_uid, study_description, description, modality;
  std::string date;                      // YYYY-MM-DD or empty
  int images = 0;                        // 0 if the archive does not give it
  std::string patient_id, patient_name;  // shown only to a user who asked for it
};

/// C-FIND in the study root model, studies first. Throws Error, also for a query with no field or the
/// modality alone.
std::vector<PacsSeries> findSeries(const PacsNode& node, const PacsQuery& query, TaskMonitor& monitor);

enum class Retrieval {
  automatic,  // C-GET, or C-MOVE if the archive does not offer C-GET
  get,
  move  // the archive connects to `own_port`; it must know `own_title`
};

struct Received {
  int images = 0;
  Retrieval how = Retrieval::get;
};

/// Retrieves a series into `folder`, which must be empty or absent: completely or not at all, files with mode
/// 0600 under our own names. Throws Error: not found, refused, some images failed, too many images,
/// connection lost.
Received retrieve(const PacsNode& node, const std::string& study_uid, const std::string& series_uid,
                  const std::filesystem::path& folder, Retrieval how, TaskMonitor& monitor);

/// Sends the DICOM files under `input` by C-STORE (a file, or a folder with its subfolders). Throws Error
/// naming the first file that was not accepted; the files before it are then stored.
int store(const PacsNode& node, const std::filesystem::path& input, TaskMonitor& monitor);

}  // namespace facenav::pacs
