#include "evaluate/stranger_pairs.h"

#include "evaluate/gate_case.h"
#include "evaluate/mirrored_scan.h"
#include "evaluate/scratch_folder.h"
#include "facenav/core/csv_table.h"
#include "facenav/core/number_text.h"
#include "facenav/core/processor_time.h"
#include "facenav/evaluation/error_statistics.h"
#include "facenav/evaluation/rate_bound.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

StrangerTry alignStranger(Context& context, const casefile::CaseStore& store,
                          const capture::Recording& recording, bool is_patient_confirmed) {
  auto request = gateRequest(context, recording.folder);
  request.is_patient_confirmed = is_patient_confirmed;
  StrangerTry tried;
  const double start_ms = processorTime_ms();
  try {
    const auto outcome =
        steps::alignRecording(context.registrations, store, recording,
                              steps::alignOrderOf(request, coil_tracking::defaultCoil()), context.monitor)
            .outcome;
    tried.is_accepted = true;
    tried.from = measured_face::nameOf(outcome.from);
    tried.bound_mm = outcome.predicted_tre_p95_mm.at(kGateTarget);
  } catch (const Cancelled&) {
    throw;
  } catch (const registration::PersonUnclear& refusal) {
    tried.is_person_asked = true;
    tried.refusal = gateWords(refusal, recording.folder.parent_path());
  } catch (const Error& refusal) {
    tried.refusal = gateWords(refusal, recording.folder.parent_path());
  }
  tried.align_s = 1e-3 * (processorTime_ms() - start_ms);
  return tried;
}

WorldScan mirroredScan(WorldScan scan) {
  scan.scalp = mirrored(std::move(scan.scalp));
  scan.target.mm.x() *= -1.0;
  return scan;
}

StrangerRow pairStranger(Context& context, const WorldScan& scan, const capture::Recording& recording) {
  const ScratchFolder scratch;
  const auto store = makeGateCase(scan, scratch.path() / "case");
  StrangerRow row;
  row.scan = scan.name;
  row.unconfirmed = alignStranger(context, store, recording, false);
  if (row.unconfirmed.is_person_asked) row.confirmed = alignStranger(context, store, recording, true);
  return row;
}

std::string lineOf(const StrangerRow& row) {
  const StrangerTry& first = row.unconfirmed;
  const StrangerTry confirmed = row.confirmed.value_or(StrangerTry{});
  std::string line = std::to_string(row.seed);
  for (const std::string& value :
       {row.head, row.scan, std::string(row.is_mirrored ? "1" : "0"),
        std::string(first.is_accepted ? "1" : "0"), first.from, fixed(first.bound_mm, 2),
        std::string(first.is_person_asked ? "1" : "0"), std::string(confirmed.is_accepted ? "1" : "0"),
        confirmed.from, fixed(confirmed.bound_mm, 2), fixed(first.align_s, 1), fixed(confirmed.align_s, 1),
        csvField(first.refusal), csvField(confirmed.refusal)})
    line += "," + value;
  return line + "\n";
}

/// Row of the summary for some of the pairs.
std::string summaryOf(const std::string& name, const std::vector<const StrangerRow*>& rows) {
  const int count = int(rows.size());
  int accepted = 0, asked = 0;
  std::vector<double> confirmed_mm;
  for (const auto* row : rows) {
    accepted += row->unconfirmed.is_accepted, asked += row->unconfirmed.is_person_asked;
    if (row->confirmed && row->confirmed->is_accepted) confirmed_mm.push_back(row->confirmed->bound_mm);
  }
  const auto bounds = evaluation::summarise(confirmed_mm);
  const auto bounds_mm =
      bounds.count > 0 ? formatted("%.1f / %.1f", bounds.median, bounds.max) : std::string("-");
  return formatted("| %s | %d | %d | %.2f %% | %d | %d | %s |\n", name.c_str(), count, accepted,
                   100.0 * evaluation::rateBound95(accepted, count), asked, bounds.count, bounds_mm.c_str());
}

std::string acceptedPairs(const std::vector<StrangerRow>& rows) {
  std::string text;
  for (const auto& row : rows)
    if (row.unconfirmed.is_accepted)
      text += formatted("- accepted: world %llu, head %s, %s scan of %s, from %s, 95 %% within %.1f mm\n",
                        static_cast<unsigned long long>(row.seed), row.head.c_str(),
                        row.is_mirrored ? "mirrored" : "the", row.scan.c_str(), row.unconfirmed.from.c_str(),
                        row.unconfirmed.bound_mm);
  return text;
}

}  // namespace

std::vector<StrangerRow> pairStrangers(Context& context, GateHeads& heads, const room::World& world,
                                       std::size_t count, const fs::path& folder) {
  const auto recording = capture::openRecording(gateRecordingIn(folder));
  const auto own = heads.scanOf(world);
  std::vector<StrangerRow> rows;
  const auto add = [&](const WorldScan& scan, bool is_mirrored) {
    rows.push_back(pairStranger(context, scan, recording));
    rows.back().seed = world.seed, rows.back().head = own.name, rows.back().is_mirrored = is_mirrored;
  };
  for (const auto& scan : heads.strangersOf(world, count)) add(scan, false);
  add(mirroredScan(own), true);
  return rows;
}

std::string strangerTable(const std::vector<StrangerRow>& rows) {
  std::string text =
      "seed,head,scan,mirrored,accepted,from,bound_mm,person_asked,confirmed_accepted,confirmed_from,"
      "confirmed_bound_mm,align_s,confirmed_align_s,refusal,confirmed_refusal\n";
  for (const auto& row : rows) text += lineOf(row);
  return text;
}

std::string strangerSummary(const std::vector<StrangerRow>& rows) {
  std::string text = std::string(kStrangersHeading) +
                     "\n\n| seeds, scans | pairs | accepted | rate at most (95 %) | a person was asked | "
                     "accepted with a false confirmation | their bounds mm, median / largest "
                     "|\n|---|---|---|---|---|---|---|\n";
  for (const bool is_odd : {false, true})
    for (const bool is_mirrored : {false, true}) {
      std::vector<const StrangerRow*> some;
      for (const auto& row : rows)
        if ((row.seed % 2 == 1) == is_odd && row.is_mirrored == is_mirrored) some.push_back(&row);
      if (some.empty()) continue;
      text += summaryOf(std::string(is_odd ? "odd (scoring), " : "even (fitting), ") +
                            (is_mirrored ? "the person's own, mirrored" : "of others"),
                        some);
    }
  return text + "\n" + acceptedPairs(rows);
}

}  // namespace facenav::app
