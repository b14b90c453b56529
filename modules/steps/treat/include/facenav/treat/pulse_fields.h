#pragma once
// TREAT: the electric field of a session's pulses (casefile/pulse_field_file.h), from their own poses, with
// the gap and the lift that the coil really had. By the surest model of the case's head; that is a local
// sphere (tier 0) where the case has no other.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/pulse_field_file.h"
#include "facenav/core/task_monitor.h"
#include "facenav/plan/pose_fields.h"

namespace facenav::steps {

/// The coil whose field is taken where none was chosen.
constexpr const char* kUsualFieldCoil = "figure8-70";

/// Name of a coil's field as it is kept and shown: a built-in one, or a file's name without its folder.
std::string fieldCoilName(const std::string& coil);

/// Field of a pulse; nothing: its pose is not known. The rate of its current follows from its intensity where
/// the coil's file states the largest rate.
std::optional<casefile::PulseField> fieldOfPulse(const PoseFields& fields, const std::string& coil,
                                                 const casefile::Pulse& pulse);

/// Computes the fields of a stored session's pulses anew and keeps them; returns their number. Throws Error:
/// a case without a brain, no such coil; Cancelled.
int computePulseFields(const casefile::CaseStore& store, const std::filesystem::path& session_folder,
                       const std::string& coil, TaskMonitor& monitor);

/// Computes the fields of a running session's pulses on a thread of low priority, and keeps each in the
/// session's folder.
class PulseFieldKeeper {
 public:
  /// `coil`: as efield::fieldCoil takes it. The case is read when the first pulse comes.
  PulseFieldKeeper(const casefile::CaseStore& store, const std::filesystem::path& session_folder,
                   const std::string& coil);
  /// Computes what waits.
  ~PulseFieldKeeper();
  PulseFieldKeeper(const PulseFieldKeeper&) = delete;
  PulseFieldKeeper& operator=(const PulseFieldKeeper&) = delete;

  /// Adds a pulse; returns at once.
  void add(const casefile::Pulse& pulse);
  /// Fault because of which no field is computed; empty: none.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::steps
