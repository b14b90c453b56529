#pragma once
// Notes that a person enters about a session, during or after it: pain before and after, adverse events,
// pauses. The names are those of the session's events; the report prints their details unchanged.

#include <optional>
#include <string>

namespace facenav::report {

namespace session_events {
constexpr const char* kPause = "pause";
constexpr const char* kResume = "resume";
constexpr const char* kPauseLength = "pause length";  // follows kResume, by the steady clock
constexpr const char* kAlignmentCaution = "alignment caution";
constexpr const char* kPainBefore = "pain before";
constexpr const char* kPainAfter = "pain after";
constexpr const char* kAdverse = "adverse event";
constexpr const char* kThreshold = "threshold";
constexpr const char* kSource = "pulse source";
constexpr const char* kOperator = "operator";
constexpr const char* kMuscle = "muscle";
constexpr const char* kStimulator = "stimulator";
constexpr const char* kTip = "tip check";  // a person's check of the alignment
}  // namespace session_events

/// Formats a pain score, 0 (none) to 10 (the worst imaginable), as the event's detail: "6", "3.5". Throws
/// Error outside.
std::string painWords(double pain);
/// Trims the words to one line. Throws Error, naming `what`, if nothing is left.
std::string noteWords(const std::string& words, const std::string& what);

}  // namespace facenav::report
