#include "plan/export_presenter.h"

#include <QDir>
#include <QStandardPaths>
#include <cmath>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/report/session_report.h"
#include "facenav/review/pulse_pictures.h"
#include "facenav/review/report_document.h"
#include "plan/other_words.h"
#include "prepare/archive_presenter.h"
#include "shell/report_pdf.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

QString inDocuments(const QString& name) {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString folder = QDir(documents).exists() ? documents : QDir::homePath();
  return QDir(folder).filePath(name);
}

/// The report of a session as the bytes of a PDF, with the case's id in place of a name.
std::string reportPdf(const casefile::CaseStore& store, const std::filesystem::path& session_folder,
                      const std::filesystem::path& beside) {
  const auto kept = casefile::readSession(session_folder);
  report::ReportOptions options;
  options.language = reportLanguage();
  options.pictures = steps::pulsePictures(store, kept);
  const WholeFile scratch(std::filesystem::path(beside).replace_extension(".pdf"));  // never committed
  writeReportPdf(report::makeSessionReport(store, kept, options), scratch.temporaryPath());
  return readWholeFile(scratch.temporaryPath());
}

/// Writes what is wanted. Returns one line about it. `pdf`: of a report.
QString writtenDicom(const casefile::CaseStore& store, const DicomWish& wish, const std::string& pdf,
                     TaskMonitor& monitor) {
  const auto& order = wish.order;
  const QString place = QString::fromStdString(order.output.string());
  switch (wish.kind) {
    case DicomKind::series:
      return ExportPresenter::tr("Written: %1 images with the patient's name in %2")
          .arg(steps::exportDicomMr(store, order, monitor).images)
          .arg(place);
    case DicomKind::segments:
      return ExportPresenter::tr("Written: segments of %1 targets with the patient's name in %2")
          .arg(steps::exportDicomSegments(store, order, monitor).targets.size())
          .arg(place);
    case DicomKind::report:
      if (std::filesystem::exists(order.output) && !order.replaces)
        throw Error("the file exists already", order.output.string(), "choose another name, or --replace");
      steps::writeReportDocument(store, casefile::findSession(store.folder(), wish.session.toStdString()),
                                 pdf, order.source, order.output, monitor);
      return ExportPresenter::tr("Written: the report with the patient's name in %1").arg(place);
  }
  return {};
}

}  // namespace

ExportPresenter::ExportPresenter(CaseModel& model, SendToArchive send, QObject* parent)
    : QObject(parent), model_(model), send_(std::move(send)) {
  connect(&runner_, &TaskRunner::progressed, this, [this](const QString& step, double fraction) {
    emit progressed(fraction > 0 ? tr("%1: %2 %").arg(step).arg(std::lround(100 * fraction)) : step);
  });
  connect(&runner_, &TaskRunner::failed, this,
          [this](const QString& words) { emit refused(inWindowWords(words.toStdString())); });
  connect(&runner_, &TaskRunner::cancelled, this, [this] { emit refused(tr("cancelled")); });
}

const std::vector<const interop::Format*>& ExportPresenter::formats() const {
  static const auto kWritten = [] {
    std::vector<const interop::Format*> written;
    for (const auto& format : interop::formats())
      if (format.write) written.push_back(&format);
    return written;
  }();
  return kWritten;
}

QStringList ExportPresenter::targets() const {
  QStringList names;
  for (const auto& target : model_.current().plan.targets) names << QString::fromStdString(target.name);
  return names;
}

QStringList ExportPresenter::sessions() const {
  QStringList names;
  for (const auto& folder : casefile::sessionFolders(model_.current().store.folder()))
    names.prepend(QString::fromStdString(folder.filename().string()));
  return names;
}

QString ExportPresenter::usualFile(const interop::Format& format) const {
  return inDocuments(QString::fromStdString(format.file_name));
}

QString ExportPresenter::usualFile(DicomKind kind) const {
  return inDocuments(kind == DicomKind::series     ? QStringLiteral("plan_dicom")
                     : kind == DicomKind::segments ? QStringLiteral("plan.dcm")
                                                   : QStringLiteral("report.dcm"));
}

QString ExportPresenter::archiveWords() const {
  const auto archive = keptArchive();
  if (!archive || !send_) return {};
  return tr("%1 at %2").arg(QString::fromStdString(archive->title), QString::fromStdString(archive->host));
}

QString ExportPresenter::write(const steps::OtherExport& order) {
  try {
    const auto exported = steps::exportOther(model_.current().store, order);
    QStringList held;
    if (exported.targets > 0)
      held << (exported.targets == 1 ? tr("1 target") : tr("%1 targets").arg(exported.targets));
    if (exported.pulses > 0)
      held << (exported.pulses == 1 ? tr("1 pulse") : tr("%1 pulses").arg(exported.pulses));
    QStringList lines{
        tr("Written: %1 in %2").arg(held.join(tr(" and ")), QString::fromStdString(exported.path.string()))};
    for (const auto& note : exported.notes) lines << inWindowWords(note);
    return lines.join("\n");
  } catch (const std::exception& error) {  // includes errors of the file system
    emit refused(inWindowWords(error.what()));
    return {};
  }
}

void ExportPresenter::writeDicom(const DicomWish& wish) {
  if (isWriting()) return;
  const auto store = model_.current().store;
  const auto archive = wish.is_sent ? keptArchive() : std::nullopt;
  std::string pdf;
  try {
    if (wish.kind == DicomKind::report)  // here, because it draws with the window's fonts
      pdf = reportPdf(store, casefile::findSession(store.folder(), wish.session.toStdString()),
                      wish.order.output);
  } catch (const std::exception& error) {  // includes errors of the file system
    return void(emit refused(inWindowWords(error.what())));
  }
  runner_.start(
      tr("Writing DICOM"),
      [this, wish, store, archive, pdf, send = send_](TaskMonitor& monitor) -> TaskRunner::Delivery {
        QString words = writtenDicom(store, wish, pdf, monitor);
        try {
          if (archive && send)
            words += "\n" + tr("Sent: %1 files").arg(send(*archive, wish.order.output, monitor));
        } catch (const Error& error) {
          throw Error(words.toStdString() + "; not sent: " + error.what());
        }
        return [this, words] { emit written(words); };
      });
}

}  // namespace facenav::ui
