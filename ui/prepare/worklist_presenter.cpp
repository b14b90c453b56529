#include "prepare/worklist_presenter.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QTimeZone>
#include <algorithm>

#include "facenav/core/error.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr int kSettle_ms = 250;  // a case changes its folder many times while it is written
constexpr int kAgeing_ms = 30000;
const char* const kFolder = "worklist/folder";

QDateTime fromUtc(const std::string& utc) {
  QDateTime time = QDateTime::fromString(QString::fromStdString(utc), "yyyyMMdd'T'HHmmss'Z'");
  time.setTimeSpec(Qt::UTC);
  return time;
}

WorklistRow rowOf(const casefile::WorklistEntry& entry) {
  WorklistRow row;
  row.case_folder = QString::fromStdString(entry.folder.string());
  row.name = entry.case_id.empty() ? QString::fromStdString(entry.folder.filename().string())
                                   : QString::fromStdString(entry.case_id);
  if (!entry.problem.empty()) {
    row.state = WorklistPresenter::tr("unreadable");
    row.state_order = 7;
    row.mark = Mark::fault;
    row.detail = shownWords(entry.problem);
    return row;
  }
  row.label = QString::fromStdString(entry.label);
  if (!row.label.isEmpty()) row.name = row.label;
  row.can_be_labelled = true;
  row.created = fromUtc(entry.created_utc);
  row.findings = int(entry.findings.size());
  row.checked_by = QString::fromStdString(entry.checked_by);
  if (!entry.findings.empty()) row.detail = shownWords(entry.findings.front());
  switch (entry.state) {
    case casefile::CaseState::prepared:
      row.state = WorklistPresenter::tr("prepared");
      row.state_order = 4;
      row.mark = Mark::look;
      break;
    case casefile::CaseState::checked:
      row.state = WorklistPresenter::tr("checked");
      row.state_order = 5;
      break;
    case casefile::CaseState::planned:
      row.state = WorklistPresenter::tr("planned");
      row.state_order = 6;
      break;
    case casefile::CaseState::rejected:
      row.state = WorklistPresenter::tr("rejected");
      row.state_order = 8;
      row.mark = Mark::fault;
      row.detail = WorklistPresenter::tr("by %1").arg(QString::fromStdString(entry.rejection));
      break;
  }
  return row;
}

WorklistRow rowOf(const PrepareJob& job, const PrepareQueue& queue) {
  WorklistRow row;
  row.job_id = job.id;
  row.name = job.title;
  row.mark = Mark::look;
  switch (job.state) {
    case JobState::queued:
      row.state = WorklistPresenter::tr("queued");
      row.state_order = 3;
      row.mark = Mark::waiting;
      break;
    case JobState::preparing:
      row.state = WorklistPresenter::tr("preparing");
      row.state_order = 2;
      row.fraction = queue.doneShare();
      row.detail =
          QStringList{WorklistPresenter::tr("%1 %").arg(int(100 * row.fraction)), queue.timeWords(), job.step}
              .join("   ");
      break;
    case JobState::needs_choice:
      row.state = WorklistPresenter::tr("new");
      row.state_order = 1;
      row.detail = WorklistPresenter::tr("%1: choose one (double click)").arg(choiceWords(job));
      break;
    case JobState::failed:
      row.state = WorklistPresenter::tr("failed");
      row.state_order = 0;
      row.mark = Mark::fault;
      row.detail = job.failure;
      break;
    case JobState::cancelled:
      row.state = WorklistPresenter::tr("cancelled");
      row.state_order = 3;
      row.mark = Mark::waiting;
      break;
  }
  return row;
}

}  // namespace

QString ageInWords(const QDateTime& created, const QDateTime& now) {
  if (!created.isValid()) return {};
  const qint64 minutes = created.secsTo(now) / 60;
  if (minutes < 1) return WorklistPresenter::tr("now");
  if (minutes < 60) return WorklistPresenter::tr("%1 min").arg(minutes);
  if (minutes < 48 * 60) return WorklistPresenter::tr("%1 h").arg(minutes / 60);
  const qint64 days = minutes / (24 * 60);
  return days < 21 ? WorklistPresenter::tr("%1 days").arg(days)
                   : WorklistPresenter::tr("%1 weeks").arg(days / 7);
}

WorklistPresenter::WorklistPresenter(PrepareQueue& queue, QObject* parent) : QObject(parent), queue_(queue) {
  soon_.setSingleShot(true);
  soon_.setInterval(kSettle_ms);
  age_.start(kAgeing_ms);
  connect(&soon_, &QTimer::timeout, this, &WorklistPresenter::refresh);
  connect(&age_, &QTimer::timeout, this, &WorklistPresenter::makeRows);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, [this] { soon_.start(); });
  connect(&queue_, &PrepareQueue::changed, this, &WorklistPresenter::makeRows);
  connect(&queue_, &PrepareQueue::progressed, this, &WorklistPresenter::makeRows);
  connect(&queue_, &PrepareQueue::prepared, this, &WorklistPresenter::refresh);
  const auto goOn = [this] {
    if (is_outdated_) refresh();
  };
  connect(&reader_, &TaskRunner::succeeded, this, goOn);
  connect(&reader_, &TaskRunner::failed, this, [this, goOn](const QString& words) {
    problem_ = words;
    entries_.clear();
    makeRows();
    goOn();
  });
}

WorklistPresenter::~WorklistPresenter() { disconnect(&reader_, nullptr, this, nullptr); }

QString WorklistPresenter::rememberedFolder() {
  return QSettings().value(kFolder, QDir::homePath() + "/FaceNav/cases").toString();
}

void WorklistPresenter::setFolder(const QString& folder) {
  folder_ = QFileInfo(folder).absoluteFilePath();
  if (!QFileInfo::exists(folder_) && QDir().mkpath(folder_))
    QFile::setPermissions(folder_, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  QSettings().setValue(kFolder, folder_);
  entries_.clear();
  if (!watcher_.directories().isEmpty()) watcher_.removePaths(watcher_.directories());
  queue_.setCasesFolder(folder_);
  refresh();
}

void WorklistPresenter::refresh() {
  if (folder_.isEmpty()) return;
  is_outdated_ = reader_.isRunning();
  if (is_outdated_) return;
  const std::filesystem::path path(folder_.toStdString());
  reader_.start(tr("Reading the worklist"),
                [this, path, known = entries_](TaskMonitor&) -> TaskRunner::Delivery {
                  auto entries = casefile::listCases(path, known);
                  return [this, path, entries = std::move(entries)] {
                    if (path != std::filesystem::path(folder_.toStdString()))
                      return void(is_outdated_ = true);
                    problem_.clear();
                    entries_ = entries;
                    watch();
                    makeRows();
                  };
                });
}

void WorklistPresenter::setLabel(const QString& case_folder, const QString& words) {
  try {
    const auto store = casefile::CaseStore::open(case_folder.toStdString());
    store.setLabel(words.toStdString());
    emit labelled(case_folder, QString::fromStdString(store.label()));
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
  refresh();
}

QString WorklistPresenter::moveToTrash(const QString& case_folder) {
  const QString name = QFileInfo(case_folder).fileName();
  const bool is_listed = std::any_of(entries_.begin(), entries_.end(), [&](const auto& entry) {
    return QString::fromStdString(entry.folder.string()) == case_folder;
  });
  if (!is_listed) return emit refused(tr("%1 is no case of this list").arg(name)), QString();
  if (!open_case_.isEmpty() && QFileInfo(case_folder) == QFileInfo(open_case_)) {
    emit refused(tr("case %1 is open. Open another case first, then delete this one.").arg(name));
    return {};
  }
  QString place;
  if (!QFile::moveToTrash(case_folder, &place)) {
    emit refused(
        tr("case %1 could not be moved to the trash. Delete its folder by hand: %2").arg(name, case_folder));
    return {};
  }
  emit said(tr("case %1 is in the trash: %2").arg(name, place));
  refresh();
  return place;
}

/// Watches the folder and each case in it: a sign-off or a target changes only the case's own folder.
void WorklistPresenter::watch() {
  QStringList wanted{folder_};
  for (const auto& entry : entries_) wanted << QString::fromStdString(entry.folder.string());
  const QStringList watched = watcher_.directories();
  for (const auto& path : watched)
    if (!wanted.contains(path)) watcher_.removePath(path);
  for (const auto& path : wanted)
    if (!watched.contains(path)) watcher_.addPath(path);
}

void WorklistPresenter::makeRows() {
  rows_.clear();
  const QDateTime now = QDateTime::currentDateTimeUtc();
  for (const auto& job : queue_.jobs()) rows_.push_back(rowOf(job, queue_));
  for (const auto& entry : entries_) {
    if (entry.folder.filename().string().front() == '.') continue;  // still being made
    rows_.push_back(rowOf(entry));
    rows_.back().age = ageInWords(rows_.back().created, now);
  }
  emit changed();
}

}  // namespace facenav::ui
