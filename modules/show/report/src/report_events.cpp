#include "report_events.h"

#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/core/without_folders.h"
#include "facenav/report/local_time.h"
#include "facenav/report/session_notes.h"
#include "report_html.h"

namespace facenav::report {
namespace {

constexpr std::size_t kMostRows = 20;  // largest table on paper; pulses.csv and events.jsonl have all rows

const char* statusWord(casefile::PulseStatus status) {
  if (status == casefile::PulseStatus::on_target) return "on target";
  return status == casefile::PulseStatus::outside ? "outside" : "lost";
}

Cell eventCell(const casefile::SessionEvent& event) {
  const bool is_written = event.event == session_events::kOperator || event.event == session_events::kAdverse;
  const std::string detail = withoutFolders(event.detail);
  return is_written ? keptCell(detail) : Cell(detail);
}

}  // namespace

std::string exceptionsPart(const casefile::KeptSession& session) {
  std::vector<TableRow> rows;
  std::size_t all = 0;
  for (const auto& reviewed : session.pulses.pulses) {
    const casefile::Pulse& pulse = reviewed.pulse;
    const bool is_excluded = reviewed.is_excluded;
    if (!is_excluded && pulse.status == casefile::PulseStatus::on_target) continue;
    if (++all <= kMostRows)
      rows.push_back({formatted("%d", pulse.number), localClock(pulse.utc),
                      is_excluded ? "excluded" : statusWord(pulse.status),
                      is_excluded ? keptCell(reviewed.note) : Cell(pulse.reason)});
  }
  if (rows.empty()) return {};
  return headingHtml("Pulses not on target, or excluded") +
         tableHtml({"pulse", "time", "status", "reason"}, rows) +
         (all > kMostRows ? paragraphHtml(formatted("%zu more: see pulses.csv.", all - kMostRows)) : "");
}

std::string eventsPart(const casefile::KeptSession& session) {
  std::vector<TableRow> rows;
  for (const auto& event : session.events)
    if (rows.size() < kMostRows) rows.push_back({localClock(event.utc), event.event, eventCell(event)});
  if (rows.empty()) return {};
  const std::size_t more = session.events.size() - rows.size();
  return headingHtml("Events") + tableHtml({"time", "event", "detail"}, rows) +
         (more > 0 ? paragraphHtml(formatted("%zu more: see events.jsonl.", more)) : "");
}

std::string cautionsPart(const SessionSummary& summary) {
  std::string html;
  if (summary.clock_set_s)
    html += paragraphHtml(
        formatted("The computer's clock was set %s by %.0f s during the session. Times of day "
                  "jump there; the column t_s of pulses.csv does not.",
                  *summary.clock_set_s < 0 ? "back" : "forward", std::abs(*summary.clock_set_s)));
  for (const auto& problem : summary.problems) html += paragraphHtml(withoutFolders(problem));
  return html.empty() ? html : headingHtml("Cautions") + html;
}

}  // namespace facenav::report
