#include "prepare/sign_off_presenter.h"

#include <algorithm>
#include <cmath>

#include "facenav/anatomy/brain_norms.h"
#include "facenav/casefile/navigation_check_file.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/prepare/sign_off_gate.h"
#include "shell/author.h"
#include "shell/shown_words.h"

namespace facenav::ui {
SignOffPresenter::SignOffPresenter(CaseModel& model, TaskRunner& tasks, QObject* parent)
    : QObject(parent), model_(model), tasks_(tasks), name_(author()) {
  const auto beginAnew = [this] {
    items_ = QStringList{tr("The outlines follow skin and brain on every slice of the montage")};
    for (const auto& finding : model_.current().findings) items_ << shownWords(finding);
    seen_.assign(std::size_t(items_.size()), false);
    note_.clear();
    readCheck();
    emit changed();
  };
  connect(&model_, &CaseModel::opened, this, beginAnew);
  connect(&model_, &CaseModel::brainChanged, this, beginAnew);  // the ticks belonged to other outlines
  connect(&model_, &CaseModel::draftChanged, this, beginAnew);
  connect(&model_, &CaseModel::signOffChanged, this, &SignOffPresenter::changed);
}

/// Reads the import check's verdict, and what it asks for.
void SignOffPresenter::readCheck() {
  asks_.clear();
  is_not_usable_ = false;
  try {
    const auto check = casefile::navigationCheckOf(model_.current().store);
    if (!check) return;
    is_not_usable_ = check->verdict() == surface::Verdict::not_usable;
    for (const auto& finding : check->findings) {
      const QString ask = shownWords(finding.ask);
      if (finding.verdict != surface::Verdict::fine && !ask.isEmpty() && !asks_.contains(ask)) asks_ << ask;
    }
  } catch (const Error& error) {  // a damaged check: nobody knows that the scan is usable
    is_not_usable_ = true;
    logWarning(error.what());
  }
}

void SignOffPresenter::setNote(const QString& note) {
  if (note == note_) return;
  note_ = note;
  emit changed();
}

void SignOffPresenter::setSeen(int item, bool is_seen) {
  if (item < 0 || std::size_t(item) >= seen_.size() || seen_[std::size_t(item)] == is_seen) return;
  seen_[std::size_t(item)] = is_seen;
  emit changed();
}

void SignOffPresenter::setName(const QString& name) {
  if (name == name_) return;
  name_ = name;
  emit changed();
}

std::vector<VolumeLine> SignOffPresenter::volumes() const {
  std::vector<VolumeLine> lines;
  if (!model_.isOpen()) return lines;
  const auto& c = model_.current();
  if (!c.shownBrain()) return {{tr("no brain model: the case holds the scalp alone"), false}};
  const double ml = c.shownBrain()->volume_ml();
  const anatomy::Norm& normal = anatomy::kNormalBrain;
  VolumeLine line;
  line.is_normal = normal.contains(ml);
  line.words = tr("brain %1 ml%2, %3 the normal range of adults, %4 to %5 ml")
                   .arg(std::lround(ml))
                   .arg(c.draft ? tr(" (correction, not saved)") : QString())
                   .arg(line.is_normal    ? tr("inside")
                        : ml < normal.low ? tr("below")
                                          : tr("above"))
                   .arg(normal.low, 0, 'f', 0)
                   .arg(normal.high, 0, 'f', 0);
  lines.push_back(line);
  return lines;
}

QString SignOffPresenter::whatIsMissing() const {
  if (!model_.isOpen()) return tr("no case is open");
  steps::SignOffClaim claim{name_.trimmed().toStdString(),
                            false,
                            seen_,
                            holds(),
                            model_.current().sign_off.has_draft,
                            is_not_usable_,
                            note_.trimmed().toStdString()};
  if (!seen_.empty()) {  // item 0 is the outlines
    claim.outlines_seen = seen_.front();
    claim.findings_seen.erase(claim.findings_seen.begin());
  }
  const auto missing = steps::missingForSignOff(claim);
  if (missing.empty()) return {};
  switch (missing.front().gap) {
    case steps::SignOffGap::signed_already:
      return tr("signed off already");
    case steps::SignOffGap::unsaved_correction:
      return tr("a correction of the brain is not saved: save or discard it first (step 3)");
    case steps::SignOffGap::unseen:
      return tr("%1 of %2 still to be ticked").arg(missing.front().open).arg(missing.front().all);
    case steps::SignOffGap::no_name:
      return tr("your name or initials are missing");
    case steps::SignOffGap::no_reason:
      return tr("the scan is not usable: give the reason why it is signed off all the same, or reject it");
  }
  return {};
}

bool SignOffPresenter::canSign() const { return !tasks_.isRunning() && whatIsMissing().isEmpty(); }

void SignOffPresenter::sign() {
  if (!canSign()) return;
  const casefile::SignOffRequest request{name_.trimmed().toStdString(), note_.trimmed().toStdString(), true,
                                         model_.current().shown_sha256};
  start(tr("Signing off"),
        [request](const casefile::CaseStore& store) { casefile::signOff(store, request); });
}

bool SignOffPresenter::canReject() const {
  return model_.isOpen() && !tasks_.isRunning() && !name_.trimmed().isEmpty() && !note_.trimmed().isEmpty() &&
         !model_.current().sign_off.rejection;
}

void SignOffPresenter::reject() {
  if (!canReject()) return;
  start(tr("Rejecting the scan"),
        [by = name_.trimmed().toStdString(), reason = note_.trimmed().toStdString()](
            const casefile::CaseStore& store) { casefile::rejectScan(store, by, reason); });
}

/// Writes into the case and shows its state then. Remembers the name.
void SignOffPresenter::start(const QString& title, std::function<void(const casefile::CaseStore&)> write) {
  rememberAuthor(name_);
  tasks_.start(
      title,
      [this, write = std::move(write), store = model_.current().store](TaskMonitor&) -> TaskRunner::Delivery {
        write(store);
        const auto status = casefile::signOffStatus(store);
        return [this, status, folder = store.folder()] {
          if (model_.isOpen() && model_.current().store.folder() == folder) model_.setSignOff(status);
        };
      });
}

bool SignOffPresenter::holds() const { return model_.isOpen() && model_.current().sign_off.holds(); }

bool SignOffPresenter::isVoid() const {
  return model_.isOpen() && model_.current().sign_off.last && !model_.current().sign_off.holds();
}

QString SignOffPresenter::statusWords() const {
  return model_.isOpen() ? signOffWords(model_.current().sign_off) : QString();
}

}  // namespace facenav::ui
