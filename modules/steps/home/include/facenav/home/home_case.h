#pragma once
// RETURN near home: a case that leaves the hospital as one file without the MRI and without a name. It
// contains the face as measured at a visit, the expert's pose, that coil, and the protocol. Everything is
// relative to that visit. The file is a ZIP of the case's folder with a manifest (home.json) of the files'
// hashes.

#include <filesystem>
#include <optional>
#include <string>

#include "facenav/align/face_model.h"
#include "facenav/coil_tracking/coil_card.h"

namespace facenav::steps {

struct HomeOrder {
  std::string target;  // an expert's pose; empty: the case's only one
  std::string coil;    // a coil.json, or a name in the library; empty: the expert's coil
  std::filesystem::path coil_library;
  std::string released_by = "clinic";  // in the file's sign-off
};

struct HomeExport {
  guidance::Target target;
  std::string coil;
  std::optional<FaceModel> face;  // measured now; nothing: the case had no MRI
  std::uintmax_t bytes = 0;
};
/// Writes the file. Throws Error: the case is not signed off, the target is no expert's pose, another coil
/// than the expert's, or a case with an MRI that was never aligned, was aligned without a measurement of the
/// cameras' turn, or was aligned again since the expert's session.
HomeExport exportHome(const face::FaceDetector& detector, const casefile::CaseStore& store,
                      const HomeOrder& order, const std::filesystem::path& file, TaskMonitor& monitor);

/// True if the file was made by exportHome(). Throws Error if it cannot be read.
bool isHomeFile(const std::filesystem::path& file);
/// Unpacks the file into a case's folder. Throws Error: damaged, changed, or of a later version. An existing
/// folder is replaced only if it is the same case and not made later; it then keeps its sessions.
casefile::CaseStore importHome(const std::filesystem::path& file, const std::filesystem::path& case_folder);

/// The parts of a case that treatment at home needs.
struct HomeCase {
  casefile::CaseStore store;
  guidance::Target target;
  coil_tracking::CoilModel coil;
  coil_tracking::CoilCard card;
};
/// Opens the case. Throws Error, one sentence each: the face's model is missing or damaged, the case is not
/// signed off, it has no expert's pose (or several), no coil, or another coil than the expert's.
HomeCase openHomeCase(const std::filesystem::path& case_folder);

/// Writes the session as one file to send back: report without name and pictures, pulses.csv, events, a
/// summary. Throws Error.
void writeSendBack(const casefile::CaseStore& store, const std::filesystem::path& session_folder,
                   const std::filesystem::path& file);

}  // namespace facenav::steps
