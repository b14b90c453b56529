#include "plan/export_presenter.h"

#include <QDir>
#include <QStandardPaths>

#include "facenav/casefile/kept_session.h"
#include "plan/other_words.h"

namespace facenav::ui {

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
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString folder = QDir(documents).exists() ? documents : QDir::homePath();
  return QDir(folder).filePath(QString::fromStdString(format.file_name));
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

}  // namespace facenav::ui
