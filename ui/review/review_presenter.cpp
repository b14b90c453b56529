#include "review/review_presenter.h"

#include <utility>

#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/whole_file.h"
#include "facenav/home/returned_session.h"
#include "facenav/report/pulse_map.h"
#include "facenav/report/session_report.h"
#include "facenav/review/mep_import.h"
#include "facenav/review/pulse_pictures.h"
#include "shell/report_pdf.h"
#include "shell/shown_words.h"
#include "shell/typed_number.h"

namespace facenav::ui {
namespace {

constexpr double kClick_mm = 6.0;

}  // namespace

ReviewPresenter::ReviewPresenter(CaseModel& model, QObject* parent) : QObject(parent), model_(model) {
  connect(&model_, &CaseModel::opened, this, [this] {
    chosen_.clear();
    session_.reset();
    sessions_.clear();
    marked_ = 0;
    editor_.open({});
    emit sessionsChanged();
    emit sessionChanged();
  });
  connect(&model_, &CaseModel::brainChanged, this, [this] {
    if (session_) refresh();
  });
  for (const auto ended : {&TaskRunner::succeeded, &TaskRunner::cancelled})
    connect(&reader_, ended, this, &ReviewPresenter::goOn);
  connect(&reader_, &TaskRunner::failed, this, [this](const QString& words) {
    emit refused(words);
    goOn();
  });
}

std::filesystem::path ReviewPresenter::folderOf(const QString& name) const {
  return model_.current().store.folder() / "sessions" / name.toStdString();
}

void ReviewPresenter::refresh() {
  if (!model_.isOpen()) return;
  is_list_outdated_ = true;
  is_session_outdated_ = !chosen_.isEmpty();
  goOn();
}

/// Reads one thing at a time; then reads again what became outdated meanwhile.
void ReviewPresenter::goOn() {
  if (reader_.isRunning() || !model_.isOpen()) return;
  if (std::exchange(is_list_outdated_, false)) return readList();
  if (std::exchange(is_session_outdated_, false)) readSession();
}

void ReviewPresenter::readList() {
  const auto folder = model_.current().store.folder();
  reader_.start(tr("Reading the sessions"), [this, folder](TaskMonitor&) -> TaskRunner::Delivery {
    auto sessions = report::summariseSessions(folder);
    return [this, folder, sessions = std::move(sessions)] {
      if (folder != model_.current().store.folder()) return refresh();
      sessions_ = sessions;
      emit sessionsChanged();
      if (chosen_.isEmpty() && !sessions_.empty()) choose(QString::fromStdString(sessions_.back().name));
    };
  });
}

void ReviewPresenter::readSession() {
  const auto folder = folderOf(chosen_);
  const auto brain = model_.current().brain;
  const auto old = session_ && session_->kept.folder == folder ? session_ : nullptr;
  reader_.start(tr("Reading the session"), [=](TaskMonitor&) -> TaskRunner::Delivery {
    auto read = std::make_shared<ReviewedSession>();
    read->kept = casefile::readSession(folder);
    const auto& pulses = read->kept.pulses.pulses;
    read->brain = brain;
    if (brain) {
      // The coil's place at a pulse never changes; only new pulses are placed.
      const bool is_known = old && old->brain == brain && old->places.size() == pulses.size();
      read->places = is_known ? old->places : report::placesOn(brain->mesh, pulses);
      read->map = report::mepMapOf(brain->mesh, pulses, read->places);
    }
    return [this, read, folder] {
      if (!model_.isOpen() || folder != folderOf(chosen_)) return;
      session_ = read;
      emit sessionChanged();
    };
  });
}

void ReviewPresenter::choose(const QString& name) {
  if (name == chosen_ || !model_.isOpen()) return;
  chosen_ = name;
  session_.reset();
  marked_ = 0;
  if (!name.isEmpty()) editor_.open(folderOf(name));
  is_session_outdated_ = !name.isEmpty();
  emit sessionChanged();
  goOn();
}

void ReviewPresenter::setColumn(report::PulseColumn column) {
  column_ = column;
  emit columnChanged();
}

void ReviewPresenter::mark(int number) {
  if (number == marked_) return;
  marked_ = number;
  emit markedChanged();
}

void ReviewPresenter::markNear(const Point<Mri>& point, bool is_brain) {
  if (!session_) return;
  double nearest_mm = kClick_mm;
  int number = 0;
  const auto& pulses = session_->kept.pulses.pulses;
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    const auto mri_T_coil = pulses[i].pulse.mri_T_coil();
    if (!mri_T_coil) continue;
    std::optional<Eigen::Vector3d> at_mm;
    if (!is_brain) at_mm = mri_T_coil->translation_mm();
    if (is_brain && i < session_->places.size() && session_->places[i]) at_mm = session_->places[i]->mm;
    if (!at_mm || (*at_mm - point.mm).norm() >= nearest_mm) continue;
    nearest_mm = (*at_mm - point.mm).norm();
    number = pulses[i].pulse.number;
  }
  if (number > 0) mark(number);
}

template <class Change>
void ReviewPresenter::attempt(Change change) {
  if (!session_) return;
  try {
    change();
  } catch (const Error& error) {
    emit refused(shownWords(error));
    emit sessionChanged();  // an edited field shows the valid value again
    return;
  }
  refresh();
}

void ReviewPresenter::exclude(const std::vector<int>& numbers, const QString& reason, const QString& by) {
  attempt([&] { editor_.exclude(numbers, reason.trimmed().toStdString(), by.trimmed().toStdString()); });
}

void ReviewPresenter::include(const std::vector<int>& numbers, const QString& by) {
  attempt([&] { editor_.include(numbers, by.trimmed().toStdString()); });
}

void ReviewPresenter::typeMep(int number, const QString& typed) {
  attempt([&] {
    const QString text = typed.trimmed();
    const auto value_uv = typedNumber(text);
    if (!value_uv && !text.isEmpty())
      throw Error("'" + text.toStdString() + "' is no number", "MEP",
                  "type microvolts, as 350; empty: not known");
    casefile::MepEdit edit{number, {}, {}, "typed", ""};
    edit.mep_uv = value_uv;
    for (const auto& reviewed : session_->kept.pulses.pulses)
      if (reviewed.pulse.number == number) edit.latency_ms = reviewed.pulse.latency_ms;
    editor_.setMeps({edit});
  });
}

void ReviewPresenter::importMeps(const QString& path, std::optional<double> offset_s, const QString& xdf) {
  attempt([&] {
    const auto& limits = settingsOf<steps::MepImportLimits>();
    const auto file = steps::readMepFile(path.toStdString(), steps::xdfChoiceFrom(xdf.toStdString()), limits);
    const auto match = steps::matchMeps(file, session_->kept.pulses.pulses, offset_s, limits);
    if (match.edits.empty())
      throw Error("no MEP is at the time of a pulse", file.name, "is it this session's file?");
    editor_.setMeps(match.edits);
    QString words = shownWords(steps::mepMatchWords(match, file));
    if (!match.left_out.empty()) words += ": " + shownWords(match.left_out.front());
    for (const auto& note : file.notes) words += "; " + shownWords(note);
    emit said(words);
  });
}

void ReviewPresenter::addReturned(const QString& file) {
  if (!model_.isOpen()) return;
  try {
    const auto returned = steps::importReturned(model_.current().store, file.toStdString());
    emit said(shownWords(inWords(returned)));
    choose(QString::fromStdString(returned.folder.filename().string()));
    refresh();
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
}

void ReviewPresenter::undo() {
  attempt([&] { editor_.undo(); });
}

void ReviewPresenter::redo() {
  attempt([&] { editor_.redo(); });
}

void ReviewPresenter::makeReport(bool has_name) {
  if (!session_) return;
  try {
    const auto& store = model_.current().store;
    const auto kept = casefile::readSession(session_->kept.folder);
    report::ReportOptions options;
    options.has_name = has_name;
    options.language = reportLanguage();
    options.pictures = steps::pulsePictures(store, kept, session_->places);
    const auto report = report::makeSessionReport(store, kept, options);
    writeWholeFile(kept.folder / "pulses.csv", casefile::pulsesCsv(kept.pulses.pulses),
                   FileAccess::owner_only);
    writeWholeFile(kept.folder / "report.html", report::toHtml(report), FileAccess::owner_only);
    writeReportPdf(report, kept.folder / "report.pdf");
    emit said(tr("report.pdf, report.html and pulses.csv are in %1")
                  .arg(QString::fromStdString(kept.folder.string())));
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
}

std::optional<steps::SessionComparison> ReviewPresenter::compareWith(const QString& earlier) {
  if (!session_) return std::nullopt;
  try {
    const auto other = casefile::readSessionPulses(folderOf(earlier));
    return steps::compareSessions(other.pulses, session_->kept.pulses.pulses);
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return std::nullopt;
  }
}

}  // namespace facenav::ui
