#pragma once
// RETURN: finds a session of the case that can be continued after a crash, a power cut or a closed window. It
// has every pulse in its file; the case's own alignment is used again, and guidance is withheld until a check
// of the registration passes (monitoring/registration_check.h).

#include <filesystem>
#include <optional>
#include <string>

#include "facenav/casefile/session_so_far.h"
#include "facenav/core/setting.h"

namespace facenav::steps {

struct ReturnRules {
  static constexpr const char* kModule = "workflow";
  static constexpr const char* kSubject = "going on with an interrupted session";

  double offered_h = 12;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kOffered("offered_h", 0, 168, "h", "an older session is not offered"), self.offered_h);
  }

  static constexpr Evidence kOffered{Origin::chosen,
                                     "a treatment goes on on the same day, or is another session"};
};

/// Returns the newest session if it was cut off, or ended before the pulses of its plan were given. Nothing
/// if it still runs or is older than ReturnRules allows. If files cannot be read: nothing, and a warning.
std::optional<casefile::SessionSoFar> interruptedSession(const std::filesystem::path& case_folder);
/// Returns the session with that name (empty: the newest), however old. Throws Error: none, or another
/// program writes it.
casefile::SessionSoFar sessionToGoOnWith(const std::filesystem::path& case_folder, const std::string& name);
/// Planned pulses of a session, by the target's own dose, else the case's protocol; nothing: not given.
std::optional<int> plannedPulses(const std::filesystem::path& case_folder, const std::string& target);
/// Returns "session 20261123T140509Z: 83 of 200 pulses, cut off 2 min ago".
std::string inWords(const casefile::SessionSoFar& session, std::optional<int> planned);

}  // namespace facenav::steps
