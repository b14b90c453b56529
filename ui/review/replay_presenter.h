#pragma once
// ReplayPresenter: one session frame by frame: play, pause, step, scrub. Poses and guidance come from its
// files, and pictures from its recording if that still exists. A lost moment stays lost: no older pose is
// shown.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "facenav/pictures/pose_overlay.h"
#include "facenav/review/session_replay.h"
#include "review/review_presenter.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class ReplayPresenter : public QObject {
  Q_OBJECT

 public:
  ReplayPresenter(ReviewPresenter& review, CaseModel& model, QObject* parent = nullptr);
  ~ReplayPresenter() override;

  /// Reads the chosen session's track unless it is open already.
  void open();
  /// Reads poses.csv and guidance.csv of another folder (output of `facenav track` and `guide`), until
  /// another session is chosen.
  void openFolder(const QString& folder);
  bool isOpen() const { return replay_ != nullptr; }
  /// Why nothing can be replayed, or the current task; empty if a track is open.
  QString problem() const { return problem_; }
  const casefile::SessionTrack& track() const { return replay_->track; }
  int index() const { return index_; }
  const casefile::TrackMoment& moment() const { return track().moments[std::size_t(index_)]; }
  void goTo(int index);
  void step(int frames);
  void play();
  void pause();
  bool isPlaying() const { return timer_.isActive(); }

  /// The target guided to at the moment, as it was at the nearest pulse; else as it is in the plan.
  std::optional<guidance::Target> target() const;
  /// "00:01:23.450 of 00:05:00.000, frame 5000".
  QString timeWords() const;
  /// "face lost: no_face"; empty if both have poses.
  QString lossWords() const;
  /// State and values of guidance.csv, one a line; empty if it has none.
  QString figures() const;
  /// Mark of a pulse: index of its moment, and whether it was on target.
  struct PulseTick {
    int index = 0;
    bool is_on_target = false;
  };
  const std::vector<PulseTick>& pulses() const { return pulses_; }

  /// Frame of the recording at the moment; null if there is none: picturesWords() gives the reason.
  std::shared_ptr<const cameras::StereoFrame> picture() const { return picture_; }
  /// picture() with the poses of its files drawn over it: scalp, coil, target. Null if picture() is null.
  std::shared_ptr<const pictures::CameraOverlay> overlay() const { return overlay_; }
  QString picturesWords() const { return pictures_words_; }
  /// Chooses another recording folder. Refused, with the reason, if its pictures are not the session's.
  void choosePictures(const QString& folder);

 signals:
  /// Another track was opened, or the track was closed.
  void opened();
  /// The moment changed, or playing started or ended.
  void moved();
  void pictureChanged();
  void refused(const QString& words);

 private:
  QString errorWords() const;
  void close();
  void forget();
  void read(const QString& folder);
  void readPicture();
  pictures::StoredPoses poses() const;
  void advance();
  void placePulses();
  void goToMarked();

  ReviewPresenter& review_;
  CaseModel& model_;
  TaskRunner reader_, picture_reader_, recording_reader_;
  std::shared_ptr<const steps::SessionReplay> replay_;
  std::shared_ptr<capture::RecordingPictures> pictures_;  // used by one task at a time
  std::shared_ptr<const cameras::StereoFrame> picture_;
  std::shared_ptr<const pictures::CameraOverlay> overlay_;  // drawn over picture_
  std::vector<PulseTick> pulses_;
  QString problem_, pictures_words_, folder_, session_folder_, being_read_;
  QTimer timer_;
  QElapsedTimer played_;
  double started_t_s_ = 0;
  int index_ = 0;
};

}  // namespace facenav::ui
