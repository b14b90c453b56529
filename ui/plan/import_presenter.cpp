#include "plan/import_presenter.h"

#include <QGuiApplication>
#include <utility>

#include "facenav/report/local_time.h"
#include "plan/other_words.h"
#include "shell/author.h"

namespace facenav::ui {
namespace {

using steps::ItemFate;

bool comesIn(const steps::PreviewedItem& item) {
  return item.fate == ItemFate::added || item.fate == ItemFate::replaced;
}

/// Takes a name out of the set, or puts it in.
void leaveOut(std::set<std::string>& names, const std::string& name, bool is_left_out) {
  if (is_left_out)
    names.insert(name);
  else
    names.erase(name);
}

QString counted(int number, const QString& one, const QString& many) {
  return number == 1 ? one : many.arg(number);
}

QString importedWords(const steps::ImportedItems& imported) {
  QStringList parts;
  if (imported.targets > 0)
    parts << ImportPresenter::tr("%1 came in (Ctrl+Z in Plan takes them back)")
                 .arg(counted(imported.targets, ImportPresenter::tr("1 target"),
                              ImportPresenter::tr("%1 targets")));
  for (const auto& folder : imported.sessions)
    parts << ImportPresenter::tr("session of %1")
                 .arg(QString::fromStdString(report::localTime(folder.filename().string())));
  if (imported.pulses > 0)
    parts.back() +=
        ImportPresenter::tr(" with %1")
            .arg(counted(imported.pulses, ImportPresenter::tr("1 pulse"), ImportPresenter::tr("%1 pulses")));
  return parts.join("; ");
}

}  // namespace

ImportPresenter::ImportPresenter(CaseModel& model, PlanPresenter& plan, QObject* parent)
    : QObject(parent), model_(model), plan_(plan) {
  connect(&model_, &CaseModel::planChanged, this, [this] {
    if (!is_writing_ && !orders_.empty()) read();  // another plan: other names are taken
  });
  for (const auto ended : {&TaskRunner::succeeded, &TaskRunner::cancelled})
    connect(&reader_, ended, this, &ImportPresenter::goOn);
  connect(&reader_, &TaskRunner::failed, this, [this](const QString& words) {
    emit refused(words);
    goOn();
  });
}

void ImportPresenter::open(const QStringList& files) {
  orders_.clear();
  for (const QString& file : files) {
    steps::OtherImport order;
    order.file = file.toStdString();
    order.skips_refused = true;  // the window shows them, and they cannot be ticked
    orders_.push_back(std::move(order));
  }
  files_.clear();
  read();
}

void ImportPresenter::read() {
  is_outdated_ = true;
  goOn();
}

void ImportPresenter::goOn() {
  if (reader_.isRunning() || !std::exchange(is_outdated_, false)) return;
  const auto work = [this, orders = orders_, head = head_,
                     store = model_.current().store](TaskMonitor&) -> TaskRunner::Delivery {
    const auto known = head ? head : std::make_shared<const interop::CaseHead>(steps::caseHead(store));
    auto files = steps::previewImports(store, *known, orders);
    return [this, known, files = std::move(files)] {
      head_ = known;
      files_ = files;
      if (!is_outdated_) emit changed();
    };
  };
  reader_.start(tr("Reading the files"), work);
}

void ImportPresenter::setOrder(std::size_t file, const steps::OtherImport& order) {
  orders_.at(file) = order;
  read();
}

void ImportPresenter::setTargetTaken(std::size_t file, const std::string& target, bool is_taken) {
  leaveOut(orders_.at(file).left_out_targets, target, !is_taken);
  read();
}

void ImportPresenter::setSessionTaken(std::size_t file, const std::string& session, bool is_taken) {
  leaveOut(orders_.at(file).left_out_sessions, session, !is_taken);
  read();
}

void ImportPresenter::takeAll(bool are_taken) {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    auto& order = orders_.at(i);
    order.left_out_targets.clear();
    order.left_out_sessions.clear();
    if (are_taken) continue;
    for (const auto& previewed : files_[i].preview.items) {
      const bool is_pulse = previewed.item.kind == interop::Kind::pulse;
      if (!comesIn(previewed) && previewed.fate != ItemFate::left_out) continue;
      is_pulse ? order.left_out_sessions.insert(previewed.item.session)
               : order.left_out_targets.insert(previewed.item.name);
    }
  }
  read();
}

int ImportPresenter::count(ItemFate fate) const {
  int number = 0;
  for (const auto& file : files_) number += file.preview.count(fate);
  return number;
}

int ImportPresenter::pulses() const {
  int number = 0;
  for (const auto& file : files_) number += file.preview.pulses();
  return number;
}

int ImportPresenter::targets() const { return count(ItemFate::added) + count(ItemFate::replaced) - pulses(); }

QString ImportPresenter::summary() const {
  if (isReading()) return tr("reading \u2026");
  QStringList in, others;
  if (targets() > 0) in << counted(targets(), tr("1 target"), tr("%1 targets"));
  if (pulses() > 0) in << counted(pulses(), tr("1 pulse"), tr("%1 pulses"));
  const bool is_one = targets() + pulses() == 1;
  others << (in.isEmpty() ? tr("nothing comes in")
                          : in.join(tr(" and ")) + (is_one ? tr(" comes in") : tr(" come in")));
  if (const int n = count(ItemFate::refused)) others << tr("%1 refused").arg(n);
  if (const int n = count(ItemFate::unchanged)) others << tr("%1 here already").arg(n);
  return others.join("; ");
}

bool ImportPresenter::hasTwoForms(std::size_t file) const {
  constexpr double kSame_mm = 1e-3;
  return head_ && (head_->t1.formsApart_mm() > kSame_mm || head_->used_of_two != interop::Form::any ||
                   !orders_.at(file).t1.empty());
}

void ImportPresenter::bringIn() {
  if (isReading() || targets() + pulses() == 0) return;
  QString first;
  for (auto& file : files_) {
    file.order.by = recordedAuthor();
    for (const auto& item : file.preview.items)
      if (first.isEmpty() && item.item.kind == interop::Kind::target && comesIn(item))
        first = QString::fromStdString(item.item.name);
  }
  is_writing_ = true;
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  QString failure;
  steps::ImportedItems imported;
  try {
    imported = steps::importOthers(model_.current().store, files_,
                                   [&](const guidance::TreatmentPlan& plan) { plan_.takePlan(plan, first); });
  } catch (const std::exception& error) {  // includes errors of the file system
    failure = inWindowWords(error.what());
  }
  QGuiApplication::restoreOverrideCursor();
  is_writing_ = false;
  if (!failure.isEmpty()) return void(emit refused(failure));
  orders_.clear();
  files_.clear();
  emit broughtIn(importedWords(imported), imported.targets > 0,
                 imported.sessions.empty()
                     ? QString()
                     : QString::fromStdString(imported.sessions.back().filename().string()));
}

}  // namespace facenav::ui
