#pragma once
// The case of a trial of `facenav evaluate gates`: a scan's skin and one target.

#include <filesystem>
#include <string>

#include "context.h"
#include "evaluate/gate_heads.h"
#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/treat/track_recording.h"

namespace facenav::app {

/// Name of the case's target (WorldScan::target).
inline constexpr const char* kGateTarget = "behind the bridge of the nose";

/// Makes the case in `folder`; an existing one is replaced.
casefile::CaseStore makeGateCase(const WorldScan& scan, const std::filesystem::path& folder);
/// The recording in a trial's folder.
std::filesystem::path gateRecordingIn(const std::filesystem::path& folder);
/// Request of `facenav track` with the default methods, without a case.
steps::TrackRequest gateRequest(const Context& context, const std::filesystem::path& recording);
/// The program's words without the trial's own folder.
std::string gateWords(const Error& refusal, const std::filesystem::path& folder);

}  // namespace facenav::app
