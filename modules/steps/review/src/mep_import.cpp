#include "facenav/review/mep_import.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "facenav/core/csv_table.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "xdf/mep_xdf.h"
#include "xdf/xdf_file.h"

namespace facenav::steps {
namespace {

constexpr int kLeastFits = 3;
constexpr std::size_t kMostSought = 200;  // largest number of rows that vote for an offset
constexpr CsvRules kTypedByHand{true, true};

struct TimedPulse {
  double t_s;
  int number;
};

/// Returns the pulses by time, on the file's clock.
std::vector<TimedPulse> timed(const std::vector<casefile::ReviewedPulse>& pulses, bool is_utc) {
  std::vector<TimedPulse> times;
  for (const auto& reviewed : pulses) {
    const auto t_s = is_utc ? secondsOfUtc(reviewed.pulse.utc) : reviewed.pulse.t_s;
    if (t_s) times.push_back({*t_s, reviewed.pulse.number});
  }
  std::sort(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.t_s < b.t_s; });
  return times;
}

/// Pulses no further than `reach_s` from `t_s`.
std::vector<const TimedPulse*> near(const std::vector<TimedPulse>& pulses, double t_s, double reach_s) {
  std::vector<const TimedPulse*> found;
  auto at = std::lower_bound(pulses.begin(), pulses.end(), t_s - reach_s,
                             [](const TimedPulse& pulse, double t) { return pulse.t_s < t; });
  for (; at != pulses.end() && at->t_s <= t_s + reach_s; ++at) found.push_back(&*at);
  return found;
}

int fitsOf(const std::vector<MepRow>& rows, const std::vector<TimedPulse>& pulses, double offset_s,
           double reach_s) {
  return int(std::count_if(rows.begin(), rows.end(), [&](const MepRow& row) {
    return !near(pulses, row.t_s + offset_s, reach_s).empty();
  }));
}

struct FoundOffset {
  double offset_s = 0;
  int fits = 0, next_best_fits = 0;
};

struct Window {
  double centre_s;
  int votes;
};

/// Finds candidate offsets: every pair of row and pulse votes for one; one window of twice the reach per
/// vote, most votes first.
std::vector<Window> windowsOf(const std::vector<MepRow>& rows, const std::vector<TimedPulse>& pulses,
                              double reach_s) {
  std::vector<double> votes_s;
  const std::size_t step = std::max<std::size_t>(1, rows.size() / kMostSought);
  for (std::size_t i = 0; i < rows.size(); i += step)
    for (const auto& pulse : pulses) votes_s.push_back(pulse.t_s - rows[i].t_s);
  std::sort(votes_s.begin(), votes_s.end());
  std::vector<Window> windows;
  for (std::size_t low = 0, high = 0; low < votes_s.size(); ++low) {
    while (high < votes_s.size() && votes_s[high] <= votes_s[low] + reach_s) ++high;
    windows.push_back({votes_s[low + (high - low - 1) / 2], int(high - low)});  // the median of the votes
  }
  std::sort(windows.begin(), windows.end(),
            [](const Window& a, const Window& b) { return a.votes > b.votes; });
  return windows;
}

FoundOffset findOffset(const std::vector<MepRow>& rows, const std::vector<TimedPulse>& pulses,
                       double reach_s) {
  const auto windows = windowsOf(rows, pulses, reach_s);
  FoundOffset found;
  found.offset_s = windows.front().centre_s;
  found.fits = fitsOf(rows, pulses, found.offset_s, reach_s);
  for (const Window& window : windows)
    if (std::abs(window.centre_s - found.offset_s) > 2 * reach_s) {
      found.next_best_fits = fitsOf(rows, pulses, window.centre_s, reach_s);
      break;
    }
  return found;
}

void requireClear(const FoundOffset& found, const MepFile& file, const MepImportLimits& limits) {
  const int rows = int(file.rows.size());
  const char* remedy = "give the offset of the clocks in seconds (--offset; 0: they are the same clock)";
  if (found.fits < kLeastFits || 2 * found.fits < rows)
    throw Error(formatted("the times do not fit the session's pulses: at best %d of %d rows meet one",
                          found.fits, rows),
                file.name, remedy);
  if (found.next_best_fits > limits.mep_second_offset * found.fits)
    throw Error(formatted("two clock offsets fit nearly alike (%d and %d of %d rows meet a pulse)",
                          found.fits, found.next_best_fits, rows),
                file.name, remedy);
}

/// Returns the pulse of each row that has exactly one; lists the others.
std::map<int, std::vector<const MepRow*>> rowsByPulse(const MepFile& file,
                                                      const std::vector<TimedPulse>& pulses, double reach_s,
                                                      MepMatch& match) {
  std::map<int, std::vector<const MepRow*>> rows;
  for (const MepRow& row : file.rows) {
    const auto found = near(pulses, row.t_s + match.offset_s, reach_s);
    if (found.size() == 1) {
      rows[found.front()->number].push_back(&row);
      const double off_ms = 1e3 * std::abs(found.front()->t_s - row.t_s - match.offset_s);
      match.largest_off_ms = std::max(match.largest_off_ms, off_ms);
    } else {
      match.left_out.push_back(
          formatted("%s %d: %s", file.row_word, row.line,
                    found.empty() ? "no pulse at its time" : "several pulses are at its time"));
    }
  }
  return rows;
}

}  // namespace

MepFile readMepFile(const std::filesystem::path& path, const XdfChoice& choice,
                    const MepImportLimits& limits) {
  if (XdfFile::isXdf(path)) return readXdfMeps(path, choice, limits);
  const CsvTable table(path, kTypedByHand);
  MepFile file;
  file.name = path.filename().string();
  file.is_utc = table.findColumn("utc").has_value();
  const std::size_t time = table.column(file.is_utc ? "utc" : "t_s"), mep = table.column("mep_uv");
  const auto latency = table.findColumn("latency_ms");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.text(i, mep).empty()) continue;
    MepRow row;
    const auto utc_s = file.is_utc ? secondsOfUtc(table.text(i, time)) : std::nullopt;
    if (file.is_utc && !utc_s)
      table.refuse(i, "'" + table.text(i, time) + "' is no time", "2026-11-23T14:05:09.123Z is expected");
    row.t_s = utc_s ? *utc_s : table.number(i, time);
    row.mep_uv = table.number(i, mep);
    if (row.mep_uv < 0 || row.mep_uv > casefile::kLargestMep_uv)
      table.refuse(i, "an MEP of " + table.text(i, mep) + " uV is not possible");
    if (latency && !table.text(i, *latency).empty()) row.latency_ms = table.number(i, *latency);
    row.line = int(i) + 2;
    file.rows.push_back(row);
  }
  return file;
}

MepMatch matchMeps(const MepFile& file, const std::vector<casefile::ReviewedPulse>& pulses,
                   std::optional<double> offset_s, const MepImportLimits& limits) {
  const auto times = timed(pulses, file.is_utc);
  if (file.rows.empty()) throw Error("there is no MEP in the file", file.name);
  if (times.empty())
    throw Error(
        std::string("no pulse of the session has a time on the clock ") + (file.is_utc ? "utc" : "t_s"),
        file.name, "the session's pulses were kept by an older version");
  MepMatch match;
  if (!offset_s && file.is_own_clock) offset_s = 0;
  if (offset_s) {
    match.offset_s = *offset_s;
    match.fits = fitsOf(file.rows, times, *offset_s, limits.mep_same_time_s);
  } else {
    const FoundOffset found = findOffset(file.rows, times, limits.mep_same_time_s);
    requireClear(found, file, limits);
    match.offset_s = found.offset_s;
    match.fits = found.fits;
    match.next_best_fits = found.next_best_fits;
    match.is_offset_found = true;
  }
  for (const auto& [number, rows] : rowsByPulse(file, times, limits.mep_same_time_s, match)) {
    if (rows.size() == 1) {
      match.edits.push_back({number, rows[0]->mep_uv, rows[0]->latency_ms, "from " + file.name, ""});
      continue;
    }
    for (const MepRow* row : rows)
      match.left_out.push_back(
          formatted("%s %d: another row is at the same pulse, %d", file.row_word, row->line, number));
  }
  return match;
}

std::string mepMatchWords(const MepMatch& match, const MepFile& file) {
  std::string words = formatted("%zu MEPs from %s; clock offset %+.3f s", match.edits.size(),
                                file.name.c_str(), match.offset_s);
  words += match.is_offset_found ? formatted(" (found: %d of %zu rows fit, %d under the next best)",
                                             match.fits, file.rows.size(), match.next_best_fits)
                                 : formatted(" (given: %d of %zu rows fit)", match.fits, file.rows.size());
  words += formatted(", largest difference %.0f ms", match.largest_off_ms);
  if (!match.left_out.empty()) words += formatted("; %zu left out", match.left_out.size());
  return words;
}

}  // namespace facenav::steps
