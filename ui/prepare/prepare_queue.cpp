#include "prepare/prepare_queue.h"

#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QSettings>
#include <QStandardPaths>
#include <QTime>
#include <QUuid>
#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/dicom/patient.h"
#include "facenav/volume/nifti.h"

namespace facenav::ui {
namespace fs = std::filesystem;
namespace {

constexpr int kTick_ms = 500, kUsualDuration_ms = 25000;
constexpr int kBackground = 10;  // niceness; the work's own threads inherit it
const char* const kStored = "queue/inputs";
const char* const kPatientLabel = "queue/patient_label";
const char* const kLastDuration = "queue/last_duration_ms";

struct ChoiceNeeded : Error {
  using Error::Error;
};

QString seriesTitle(const dicom::SeriesInfo& series) {
  const QString words = QString::fromStdString(series.description);
  return words.isEmpty() ? PrepareQueue::tr("(no description)") : words;
}

/// Makes a case completely or not at all: under a hidden name, then renamed to its random id.
fs::path makeCase(const Services& services, const fs::path& cases, PrepareOrder order, TaskMonitor& monitor) {
  fs::create_directories(cases);
  order.case_folder = cases / (".new-" + QUuid::createUuid().toString(QUuid::Id128).toStdString());
  services.prepareCase(order, monitor);
  const auto place = cases / casefile::CaseStore::open(order.case_folder).caseId();
  fs::rename(order.case_folder, place);
  return place;
}

}  // namespace

QString receivedFolder() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/received";
  QDir().mkpath(folder);
  QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  return folder;
}

bool isNifti(const QString& path) { return volume::isNiftiName(path.toStdString()); }

QString inputOf(const QString& dropped_path) {
  const QFileInfo info(dropped_path);
  if (!info.isFile()) return info.absoluteFilePath();
  const QString header = info.absolutePath() + "/" + info.completeBaseName() + ".hdr";
  // .hdr and .img are one volume
  if (info.suffix().toLower() == "img" && QFileInfo::exists(header)) return header;
  return isNifti(dropped_path) ? info.absoluteFilePath() : info.absolutePath();
}

QString choiceWords(const PrepareJob& job) {
  if (job.patients > 1) return PrepareQueue::tr("images of %1 patients").arg(job.patients);
  if (job.readings > 0) return PrepareQueue::tr("slices that can be read in several ways");
  return PrepareQueue::tr("no series is recommended");
}

const dicom::SeriesInfo* recommendedOf(const std::vector<dicom::SeriesInfo>& series) {
  const auto found =
      std::find_if(series.begin(), series.end(), [](const auto& s) { return s.is_recommended; });
  return found == series.end() ? nullptr : &*found;
}

PrepareQueue::PrepareQueue(const Services& services, QObject* parent)
    : QObject(parent), services_(services), fields_(services) {
  connect(&fields_, &FieldQueue::ended, this, &PrepareQueue::fieldEnded);
  connect(&tasks_, &TaskRunner::progressed, this, [this](const QString& step, double fraction) {
    if (auto* running = find(running_)) {
      running->step = step;
      running->fraction = fraction;
      emit progressed();
    }
  });
  tick_.setInterval(kTick_ms);
  connect(&tick_, &QTimer::timeout, this, [this] { tasks_.isRunning() ? emit progressed() : tick_.stop(); });
  connect(&tasks_, &TaskRunner::cancelled, this, [this] { end(JobState::cancelled, {}); });
  connect(&tasks_, &TaskRunner::failed, this, [this](const QString& words) { end(JobState::failed, words); });
}

PrepareQueue::~PrepareQueue() { disconnect(&tasks_, nullptr, this, nullptr); }

void PrepareQueue::setCasesFolder(const QString& folder) {
  cases_folder_ = folder;
  begin();
}

const PrepareJob* PrepareQueue::job(int id) const {
  for (const auto& job : jobs_)
    if (job.id == id) return &job;
  return nullptr;
}

PrepareJob* PrepareQueue::find(int id) { return const_cast<PrepareJob*>(job(id)); }

int PrepareQueue::add(const QString& input, const std::optional<std::string>& series_uid) {
  for (auto& known : jobs_) {
    const bool is_pending = known.state == JobState::queued || known.state == JobState::preparing;
    if (known.input != input) continue;
    if (is_pending && known.series_uid == series_uid) return known.id;
    if (!is_pending) {  // chosen by hand now, or retried
      known.series_uid = series_uid;
      retry(known.id);
      return known.id;
    }
  }
  PrepareJob job;
  job.id = ++last_id_;
  job.input = input;
  job.series_uid = series_uid;
  // A folder's name may be a patient's, so it is never shown.
  job.title = (isNifti(input) ? tr("volume %1, %2") : tr("folder %1, %2"))
                  .arg(job.id)
                  .arg(QTime::currentTime().toString("hh:mm"));
  jobs_.push_back(job);
  store();
  emit changed();
  begin();
  return job.id;
}

void PrepareQueue::cancel(int id) {
  auto* job = find(id);
  if (!job) return;
  if (id == running_) return tasks_.cancel();
  if (job->state != JobState::queued) return;
  job->state = JobState::cancelled;
  store();
  emit changed();
}

void PrepareQueue::retry(int id) {
  auto* job = find(id);
  if (!job || job->state == JobState::queued || job->state == JobState::preparing) return;
  job->state = JobState::queued;
  job->failure.clear();
  store();
  emit changed();
  begin();
}

void PrepareQueue::remove(int id) {
  if (id == running_) return;
  if (const auto* job_ = job(id)) forgetReceived(job_->input);
  jobs_.erase(std::remove_if(jobs_.begin(), jobs_.end(), [&](const auto& job) { return job.id == id; }),
              jobs_.end());
  store();
  emit changed();
}

/// DICOM files name the patient, so they are removed as soon as possible.
void PrepareQueue::forgetReceived(const QString& input) {
  if (QFileInfo(input).absolutePath() == receivedFolder()) QDir(input).removeRecursively();
}

bool PrepareQueue::labelsByPatient() const { return QSettings().value(kPatientLabel, false).toBool(); }

void PrepareQueue::setLabelsByPatient(bool is_labelled) { QSettings().setValue(kPatientLabel, is_labelled); }

void PrepareQueue::setHeld(bool is_held) {
  is_held_ = is_held;
  begin();
}

void PrepareQueue::begin() {
  if (is_held_) fields_.setHeld(true);
  if (is_held_ || tasks_.isRunning() || cases_folder_.isEmpty()) return;
  const auto next =
      std::find_if(jobs_.begin(), jobs_.end(), [](const auto& j) { return j.state == JobState::queued; });
  fields_.setHeld(next != jobs_.end());
  if (next == jobs_.end()) return;
  next->state = JobState::preparing;
  next->step.clear();
  next->fraction = 0.0;
  running_ = next->id;
  elapsed_.start();
  tick_.start();
  const PrepareOrder order{fs::path(next->input.toStdString()), {}, next->series_uid, labelsByPatient()};
  const fs::path cases(cases_folder_.toStdString());
  const bool is_volume = isNifti(next->input);
  tasks_.start(tr("Preparing"),
               [this, order, cases, is_volume, id = running_](TaskMonitor& monitor) -> TaskRunner::Delivery {
                 // Lowers this thread's priority, so that a treatment is not slowed down.
                 ::setpriority(PRIO_PROCESS, 0, kBackground);
                 auto chosen = order;
                 if (!is_volume && !chosen.series_uid) {
                   const auto series = services_.listSeries(order.input, monitor);
                   const auto* recommended = recommendedOf(series);
                   if (!recommended)
                     return [this, id, patients = dicom::patientCount(series),
                             readings = dicom::readingCount(series)] {
                       if (auto* job = find(id)) job->patients = patients, job->readings = readings;
                       end(JobState::needs_choice, {});
                     };
                   chosen.series_uid = recommended->id.empty() ? recommended->series_uid : recommended->id;
                   QMetaObject::invokeMethod(
                       this,
                       [this, id, title = seriesTitle(*recommended)] {
                         if (auto* job = find(id)) job->title = title;
                         emit changed();
                       },
                       Qt::QueuedConnection);
                 }
                 const auto place = makeCase(services_, cases, chosen, monitor);
                 const auto case_id = QString::fromStdString(casefile::CaseStore::open(place).caseId());
                 return [this, id, case_id, folder = QString::fromStdString(place.string())] {
                   QSettings().setValue(kLastDuration, elapsed_.elapsed());
                   running_ = 0;
                   remove(id);
                   emit prepared(folder, case_id);
                   fields_.add(folder);
                   QMetaObject::invokeMethod(this, &PrepareQueue::begin, Qt::QueuedConnection);
                 };
               });
  emit changed();
}

void PrepareQueue::end(JobState state, const QString& failure) {
  const int id = running_;
  running_ = 0;
  if (auto* job = find(id)) {
    job->state = state;
    job->failure = failure;
  }
  store();
  emit changed();
  if (state == JobState::needs_choice) emit choiceNeeded(id);
  QMetaObject::invokeMethod(this, &PrepareQueue::begin, Qt::QueuedConnection);
}

void PrepareQueue::store() const {
  QStringList inputs;
  for (const auto& job : jobs_)
    if (job.state == JobState::queued || job.state == JobState::preparing)
      inputs << job.input + "\n" + QString::fromStdString(job.series_uid.value_or(""));
  QSettings().setValue(kStored, inputs);
}

void PrepareQueue::restore() {
  only_window_ = std::make_unique<QLockFile>(receivedFolder() + "/../window.lock");
  only_window_->setStaleLockTime(0);  // only the end of the process that holds it frees the lock
  if (!only_window_->tryLock(0)) return;
  for (const QString& line : QSettings().value(kStored).toStringList()) {
    const QString input = line.section('\n', 0, 0);
    const std::string series = line.section('\n', 1, 1).toStdString();
    if (QFileInfo::exists(input)) add(input, series.empty() ? std::nullopt : std::optional(series));
  }
  for (const auto& left : QDir(receivedFolder()).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const auto is_known = [&](const auto& job) { return job.input == left.absoluteFilePath(); };
    if (std::none_of(jobs_.begin(), jobs_.end(), is_known)) forgetReceived(left.absoluteFilePath());
  }
}

double PrepareQueue::doneShare() const {
  constexpr double kMost = 0.99, kBend = 0.9;  // beyond the expected time the share creeps on
  if (!tasks_.isRunning()) return 0;
  const double last_ms = double(QSettings().value(kLastDuration, 0).toLongLong());
  const double share = double(elapsed_.elapsed()) / (last_ms > 0 ? last_ms : double(kUsualDuration_ms));
  if (share <= kBend) return share;
  return kMost - (kMost - kBend) * std::exp(-(share - kBend) / (kMost - kBend));
}

QString PrepareQueue::timeWords() const {
  if (!tasks_.isRunning()) return {};
  const qint64 elapsed_ms = elapsed_.elapsed();
  const qint64 last_ms = QSettings().value(kLastDuration, 0).toLongLong();
  const QString so_far = tr("%1 s").arg(elapsed_ms / 1000);
  if (last_ms <= 0) return so_far;
  if (elapsed_ms > last_ms) return tr("%1, longer than the last one").arg(so_far);
  return tr("%1, about %2 s left").arg(so_far).arg((last_ms - elapsed_ms + 999) / 1000);
}

QString PrepareQueue::summary() const {
  const auto count = [this](JobState state) {
    return std::count_if(jobs_.begin(), jobs_.end(), [&](const auto& job) { return job.state == state; });
  };
  const auto waiting = count(JobState::queued), failed = count(JobState::failed);
  QStringList words;
  if (tasks_.isRunning()) words << tr("preparing 1");
  if (waiting > 0)
    words << (is_held_ ? tr("%1 waiting for the treatment's end") : tr("%1 waiting")).arg(waiting);
  if (failed > 0) words << tr("%1 failed").arg(failed);
  return words.join(", ");
}

}  // namespace facenav::ui
