#include "facenav/treat/session_return.h"

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/protocol.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"

namespace facenav::steps {
namespace {

constexpr double kHour_s = 3600, kMinute_s = 60;

std::string agoWords(double seconds) {
  if (seconds < kMinute_s) return formatted("%.0f s ago", seconds);
  if (seconds < kHour_s) return formatted("%.0f min ago", seconds / kMinute_s);
  return formatted("%.1f h ago", seconds / kHour_s);
}

}  // namespace

std::optional<int> plannedPulses(const std::filesystem::path& case_folder, const std::string& target) {
  for (const auto& each : casefile::CaseStore::open(case_folder).targets().targets)
    if (each.name == target && each.dose) return each.dose->pulses;
  if (const auto protocol = casefile::protocolOf(case_folder)) return protocol->dose.pulses;
  return std::nullopt;
}

std::optional<casefile::SessionSoFar> interruptedSession(const std::filesystem::path& case_folder) {
  try {
    const auto newest = casefile::newestSession(case_folder);
    if (!newest || newest->is_running) return std::nullopt;
    if (newest->idle_s > kHour_s * settingsOf<ReturnRules>().offered_h) return std::nullopt;
    if (!newest->has_ended) return newest;
    const auto planned = plannedPulses(case_folder, newest->target);
    return planned && newest->pulses() > 0 && newest->pulses() < *planned ? newest : std::nullopt;
  } catch (const Error& error) {
    logWarning(std::string("no earlier session is offered: ") + error.what());
    return std::nullopt;
  }
}

casefile::SessionSoFar sessionToGoOnWith(const std::filesystem::path& case_folder, const std::string& name) {
  auto session = casefile::sessionSoFar(casefile::findSession(case_folder, name));
  if (session.is_running)
    throw Error("another program writes this session", session.folder.string(), "end it there first");
  return session;
}

std::string inWords(const casefile::SessionSoFar& session, std::optional<int> planned) {
  return "session " + session.name + formatted(": %d", session.pulses()) +
         (planned ? formatted(" of %d pulses, ", *planned) : std::string(" pulses, ")) +
         (session.has_ended ? "ended " : "cut off ") + agoWords(session.idle_s);
}

}  // namespace facenav::steps
