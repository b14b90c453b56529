#include "review/replay_presenter.h"

#include <QTime>
#include <algorithm>
#include <cmath>
#include <utility>

#include "facenav/casefile/evidence.h"
#include "facenav/core/error.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr int kReplayRefresh_ms = 33;

QString clockWords(double t_s) {
  return QTime(0, 0).addMSecs(int(std::lround(1e3 * t_s))).toString("hh:mm:ss.zzz");
}

/// A frame's state as the session's file names it.
QString stateWords(const std::string& state) {
  if (state == "on_target") return ReplayPresenter::tr("on target");
  if (state == "adjust") return ReplayPresenter::tr("adjust");
  return state == "lost" ? ReplayPresenter::tr("lost") : QString::fromStdString(state);
}

}  // namespace

ReplayPresenter::ReplayPresenter(ReviewPresenter& review, CaseModel& model, QObject* parent)
    : QObject(parent), review_(review), model_(model) {
  timer_.setInterval(kReplayRefresh_ms);
  connect(&timer_, &QTimer::timeout, this, &ReplayPresenter::advance);
  connect(&review_, &ReviewPresenter::sessionChanged, this, [this] {
    const auto session = review_.session();
    const QString folder = session ? QString::fromStdString(session->kept.folder.string()) : QString();
    if (std::exchange(session_folder_, folder) != folder) close();
    if (isOpen()) placePulses();
  });
  connect(&review_, &ReviewPresenter::markedChanged, this, &ReplayPresenter::goToMarked);
  connect(&reader_, &TaskRunner::failed, this, [this](const QString& words) {
    if (folder_ != being_read_) return folder_.isEmpty() ? void() : read(folder_);
    problem_ = words;
    emit opened();
  });
  connect(&picture_reader_, &TaskRunner::failed, this, [this](const QString& words) {
    pictures_words_ = words;
    pictures_.reset();
    picture_.reset();
    overlay_.reset();
    emit pictureChanged();
  });
}

ReplayPresenter::~ReplayPresenter() = default;

void ReplayPresenter::close() {
  forget();
  emit opened();
}

void ReplayPresenter::forget() {
  timer_.stop();
  replay_.reset();
  pictures_.reset();
  picture_.reset();
  overlay_.reset();
  pulses_.clear();
  folder_.clear();
  problem_.clear();
  index_ = 0;
}

void ReplayPresenter::open() {
  if (folder_.isEmpty() && !session_folder_.isEmpty()) read(session_folder_);
}

void ReplayPresenter::openFolder(const QString& folder) {
  forget();
  read(folder);
}

void ReplayPresenter::read(const QString& folder) {
  folder_ = folder;
  problem_ = tr("reading the poses");
  if (reader_.isRunning()) return;  // it is read after the current one
  being_read_ = folder;
  reader_.start(problem_, [this, folder](TaskMonitor&) -> TaskRunner::Delivery {
    auto replay = std::make_shared<const steps::SessionReplay>(steps::openReplay(folder.toStdString()));
    return [this, folder, replay] {
      if (folder != folder_) return folder_.isEmpty() ? void() : read(folder_);
      replay_ = replay;
      pictures_ = replay->pictures;
      pictures_words_ = shownWords(replay->pictures_words);
      problem_.clear();
      index_ = 0;
      placePulses();
      emit opened();
      goTo(0);
      goToMarked();
    };
  });
  emit opened();
}

/// Goes to the frame whose pictures were saved with the pulse, else to the frame before the pulse.
void ReplayPresenter::goToMarked() {
  const auto session = folder_ == session_folder_ ? review_.session() : nullptr;
  if (!isOpen() || !session || review_.marked() == 0) return;
  for (const auto& reviewed : session->kept.pulses.pulses) {
    const auto& pulse = reviewed.pulse;
    if (pulse.number != review_.marked() || !pulse.t_s) continue;
    pause();
    const auto frame = casefile::evidenceFrame(session->kept.folder, pulse);
    const int before = int(track().at(*pulse.t_s));
    const bool is_next = frame && before + 1 < int(track().moments.size()) &&
                         track().moments[std::size_t(before) + 1].frame == *frame;
    return goTo(is_next ? before + 1 : before);
  }
}

void ReplayPresenter::placePulses() {
  pulses_.clear();
  const auto session = folder_ == session_folder_ ? review_.session() : nullptr;
  if (!session) return;
  for (const auto& reviewed : session->kept.pulses.pulses)
    if (reviewed.pulse.t_s && !reviewed.is_excluded)
      pulses_.push_back(
          {int(track().at(*reviewed.pulse.t_s)), reviewed.pulse.status == casefile::PulseStatus::on_target});
  emit moved();
}

void ReplayPresenter::goTo(int index) {
  if (!isOpen()) return;
  index_ = std::clamp(index, 0, int(track().moments.size()) - 1);
  emit moved();
  readPicture();
}

void ReplayPresenter::step(int frames) {
  pause();
  goTo(index_ + frames);
}

void ReplayPresenter::play() {
  if (!isOpen()) return;
  if (index_ + 1 >= int(track().moments.size())) goTo(0);
  started_t_s_ = moment().t_s;
  played_.start();
  timer_.start();
  emit moved();
}

void ReplayPresenter::pause() {
  timer_.stop();
  if (isOpen()) emit moved();
}

/// Advances in real time; frames that cannot be drawn in time are skipped.
void ReplayPresenter::advance() {
  const double t_s = started_t_s_ + 1e-3 * double(played_.elapsed());
  goTo(int(track().at(t_s)));
  if (index_ + 1 >= int(track().moments.size())) pause();
}

std::optional<guidance::Target> ReplayPresenter::target() const {
  const std::string name = isOpen() ? track().word(moment().target) : std::string();
  if (name.empty() || !model_.isOpen()) return std::nullopt;
  std::optional<guidance::Target> found;
  double nearest_s = 0;
  if (const auto session = review_.session())
    for (const auto& reviewed : session->kept.pulses.pulses) {
      const auto& pulse = reviewed.pulse;
      if (!pulse.target || pulse.target->name != name || !pulse.t_s) continue;
      const double off_s = std::abs(*pulse.t_s - moment().t_s);
      if (!found || off_s < nearest_s) found = pulse.target, nearest_s = off_s;
    }
  if (found) return found;
  for (const auto& target : model_.current().plan.targets)
    if (target.name == name) return target;
  return std::nullopt;
}

QString ReplayPresenter::timeWords() const {
  if (!isOpen()) return {};
  const double first_s = track().moments.front().t_s;
  return tr("%1 of %2, frame %3")
      .arg(clockWords(moment().t_s - first_s), clockWords(track().duration_s()))
      .arg(qlonglong(moment().frame));
}

QString ReplayPresenter::lossWords() const {
  return isOpen() ? shownWords(steps::lossAt(track(), moment())) : QString();
}

/// The bound of the alignment's error as the session's pulses hold it; empty in older sessions.
QString ReplayPresenter::errorWords() const {
  const auto session = review_.session();
  if (!session) return {};
  for (const auto& reviewed : session->kept.pulses.pulses)
    if (reviewed.pulse.error_bound_mm && reviewed.pulse.target &&
        reviewed.pulse.target->name == track().word(moment().target))
      return "\n" + tr("alignment: 95 % within %1 mm").arg(*reviewed.pulse.error_bound_mm, 0, 'f', 1);
  return {};
}

QString ReplayPresenter::figures() const {
  if (!isOpen() || moment().state == 0) return {};
  const QString head =
      QString::fromStdString(track().word(moment().target)) + ": " + stateWords(track().word(moment().state));
  if (!moment().has_guidance) return head;
  const auto& g = moment().guidance;
  const auto number = [](float value, int decimals) { return QString::number(double(value), 'f', decimals); };
  return head + "\n" +
         tr("error %1 mm, sideways %2 mm, depth %3 mm")
             .arg(number(g.distance_mm, 1), number(g.lateral_mm, 1), number(g.depth_mm, 1)) +
         "\n" +
         tr("tilt %1\u00b0, twist %2\u00b0, beam misses by %3 mm")
             .arg(number(g.tilt_deg, 1), number(g.twist_deg, 1), number(g.beam_miss_mm, 1)) +
         errorWords();
}

/// Poses of the moment from the session's files. Omits poses not placed in the MRI and poses of another coil.
pictures::StoredPoses ReplayPresenter::poses() const {
  pictures::StoredPoses poses;
  if (track().is_in_mri) poses.camera_T_mri = moment().camera_T_mri();
  if (track().is_coil) poses.camera_T_coil = moment().camera_T_coil();
  poses.target = target();
  poses.loss = steps::lossAt(track(), moment());
  return poses;
}

/// Reads one frame at a time; the newest request is read next.
void ReplayPresenter::readPicture() {
  if (!pictures_ || !model_.isOpen() || picture_reader_.isRunning()) return;
  const auto wanted = moment().frame;
  if (picture_ && picture_->number == wanted) return;
  picture_reader_.start(tr("Reading a picture"),
                        [this, kept = pictures_, wanted, poses = poses(), scalp = model_.current().scalp,
                         plate = model_.current().coil.plate](TaskMonitor&) -> TaskRunner::Delivery {
                          auto frame = kept->frame(wanted);
                          auto overlay = std::make_shared<pictures::CameraOverlay>();
                          if (frame)
                            *overlay = pictures::drawPoses(kept->rig(), *frame, poses, scalp->mesh, plate);
                          return [this, kept, frame, overlay, wanted] {
                            if (kept != pictures_) return;
                            picture_ = frame;
                            overlay_ = frame ? overlay : nullptr;
                            pictures_words_ = frame ? QString() : tr("no picture was kept of this frame");
                            emit pictureChanged();
                            if (frame && isOpen() && moment().frame != wanted)
                              QTimer::singleShot(0, this, &ReplayPresenter::readPicture);
                          };
                        });
}

void ReplayPresenter::choosePictures(const QString& folder) {
  if (!isOpen()) return;
  recording_reader_.start(tr("Reading the recording"),
                          [this, folder, replay = replay_](TaskMonitor&) -> TaskRunner::Delivery {
                            std::shared_ptr<capture::RecordingPictures> pictures;
                            QString words;
                            try {
                              pictures = steps::openPictures(folder.toStdString(), replay->track);
                            } catch (const Error& error) {
                              words = shownWords(error);
                            }
                            return [this, pictures, words, replay] {
                              if (replay != replay_) return;
                              if (!words.isEmpty()) return void(emit refused(words));
                              pictures_ = pictures;
                              picture_.reset();
                              overlay_.reset();
                              readPicture();
                            };
                          });
}

}  // namespace facenav::ui
