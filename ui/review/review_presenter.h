#pragma once
// ReviewPresenter: the sessions of the open case, and one of them with its pulses, map and charts. Files are
// read on a worker thread; changes are written at once (review/review_editor.h) and everything is computed
// again.

#include <QObject>
#include <memory>
#include <optional>

#include "facenav/guidance/mep_map.h"
#include "facenav/report/pulse_columns.h"
#include "facenav/report/session_review.h"
#include "facenav/review/review_editor.h"
#include "facenav/review/session_compare.h"
#include "shell/case_model.h"
#include "shell/task_runner.h"

namespace facenav::ui {

/// A session as it is shown.
struct ReviewedSession {
  casefile::KeptSession kept;
  std::shared_ptr<const surface::BrainModel> brain;  // may be null
  std::vector<std::optional<Point<Mri>>> places;     // places of the pulses on the brain; empty without a
                                                     // brain
  std::optional<guidance::MepMap> map;               // map on the brain
};

class ReviewPresenter : public QObject {
  Q_OBJECT

 public:
  explicit ReviewPresenter(CaseModel& model, QObject* parent = nullptr);

  /// Reads the list of sessions and the chosen one again.
  void refresh();
  /// The sessions, oldest first.
  const std::vector<report::SessionSummary>& sessions() const { return sessions_; }
  /// Chooses a session by its name; its pulses follow with sessionChanged().
  void choose(const QString& name);
  QString chosen() const { return chosen_; }
  /// The chosen session; null until it is read, or if none is chosen.
  std::shared_ptr<const ReviewedSession> session() const { return session_; }
  std::filesystem::path folderOf(const QString& name) const;
  bool isReading() const { return reader_.isRunning(); }

  report::PulseColumn column() const { return column_; }
  void setColumn(report::PulseColumn column);
  /// Number of the pulse that is marked in all views; 0: none.
  int marked() const { return marked_; }
  void mark(int number);
  /// Marks the pulse whose place on the brain (or coil centre) is nearest to a click, within 6 mm.
  void markNear(const Point<Mri>& point, bool is_brain);

  // Changes of the session; refused() gives the reason if one fails.
  void exclude(const std::vector<int>& numbers, const QString& reason, const QString& by);
  void include(const std::vector<int>& numbers, const QString& by);
  /// Sets the MEP of a pulse from typed text; empty: not known.
  void typeMep(int number, const QString& typed);
  /// Imports MEPs from a CSV or XDF file. `offset_s`: offset of the clocks; estimated if empty. `xdf`: what
  /// to take from an XDF (steps::xdfChoiceFrom). said() reports the result.
  void importMeps(const QString& file, std::optional<double> offset_s, const QString& xdf = {});
  /// Adds a file that a session at home sent back as a session of the case, and chooses it. said() reports
  /// what was added.
  void addReturned(const QString& file);
  void undo();
  void redo();
  const steps::ReviewEditor& editor() const { return editor_; }

  /// Writes report.html, report.pdf and pulses.csv into the session's folder, on this thread (it draws).
  void makeReport(bool has_name);
  /// Compares the chosen session with another one. Returns nothing, after refused(), if that cannot be read.
  std::optional<steps::SessionComparison> compareWith(const QString& earlier);

 signals:
  void sessionsChanged();
  /// Another session was chosen, or its numbers changed.
  void sessionChanged();
  void columnChanged();
  void markedChanged();
  void refused(const QString& words);
  void said(const QString& words);

 private:
  void readList();
  void readSession();
  void goOn();
  template <class Change>
  void attempt(Change change);

  CaseModel& model_;
  TaskRunner reader_;
  steps::ReviewEditor editor_;
  std::vector<report::SessionSummary> sessions_;
  std::shared_ptr<const ReviewedSession> session_;
  QString chosen_;
  report::PulseColumn column_ = report::PulseColumn::distance;
  int marked_ = 0;
  bool is_list_outdated_ = false, is_session_outdated_ = false;
};

}  // namespace facenav::ui
