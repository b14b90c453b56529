#include "facenav/review/review_editor.h"

#include "facenav/core/number_text.h"

namespace facenav::steps {
namespace {

std::string countWords(const char* what, std::size_t count, const char* of) {
  return formatted("%s %zu %s%s", what, count, of, count == 1 ? "" : "s");
}

}  // namespace

void ReviewEditor::open(const std::filesystem::path& session_folder) {
  folder_ = session_folder;
  done_.clear();
  undone_.clear();
}

void ReviewEditor::write(const Change& change) const {
  if (!change.pulses.empty()) casefile::editPulses(folder_, change.pulses);
  if (!change.meps.empty()) casefile::editMeps(folder_, change.meps);
}

void ReviewEditor::take(Step step) {
  write(step.forward);
  done_.push_back(std::move(step));
  undone_.clear();
}

void ReviewEditor::exclude(const std::vector<int>& numbers, const std::string& reason,
                           const std::string& by) {
  Step step;
  for (const int number : numbers) {
    step.forward.pulses.push_back({number, true, reason, by});
    step.backward.pulses.push_back({number, false, "undone", by});
  }
  step.words = countWords("exclude", numbers.size(), "pulse");
  take(std::move(step));
}

void ReviewEditor::include(const std::vector<int>& numbers, const std::string& by) {
  const auto session = casefile::readSessionPulses(folder_);
  Step step;
  for (const int number : numbers) {
    step.forward.pulses.push_back({number, false, "", by});
    for (const auto& reviewed : session.pulses)
      if (reviewed.pulse.number == number) step.backward.pulses.push_back({number, true, reviewed.note, by});
  }
  step.words = countWords("take in", numbers.size(), "pulse");
  take(std::move(step));
}

void ReviewEditor::setMeps(const std::vector<casefile::MepEdit>& edits) {
  const auto session = casefile::readSessionPulses(folder_);
  Step step;
  step.forward.meps = edits;
  for (const auto& edit : edits)
    for (const auto& reviewed : session.pulses)
      if (reviewed.pulse.number == edit.number)
        step.backward.meps.push_back(
            {edit.number, reviewed.pulse.mep_uv, reviewed.pulse.latency_ms, "undone", edit.by});
  step.words = countWords("enter", edits.size(), "MEP");
  take(std::move(step));
}

void ReviewEditor::undo() {
  if (done_.empty()) return;
  write(done_.back().backward);
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
}

void ReviewEditor::redo() {
  if (undone_.empty()) return;
  write(undone_.back().forward);
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
}

}  // namespace facenav::steps
