#include "prepare/prepare_presenter.h"

#include <QFileInfo>

#include "facenav/dicom/patient.h"
#include "facenav/prepare/finding_place.h"
#include "facenav/volume/voxel_size.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

std::filesystem::path toPath(const QString& path) { return std::filesystem::path(path.toStdString()); }

}  // namespace

PreparePresenter::PreparePresenter(const Services& services, CaseModel& model, TaskRunner& tasks,
                                   PrepareQueue& queue, QObject* parent)
    : QObject(parent), services_(services), model_(model), tasks_(tasks), queue_(queue) {}

void PreparePresenter::openInput(const QString& path) {
  if (isNifti(path)) {
    input_ = path;
    series_.clear();
    has_several_patients_ = has_several_readings_ = false;
    lines_ = {{tr("NIfTI volume"),
               tr("as chosen; a file's own name may be a patient's and is not shown"),
               {},
               true,
               true,
               {}}};
    emit linesChanged();
    return;
  }
  tasks_.start(tr("Looking for series"), [this, path](TaskMonitor& monitor) -> TaskRunner::Delivery {
    std::vector<Listed> listed;
    for (auto& info : services_.listSeries(toPath(path), monitor))
      listed.push_back({std::move(info), {}, {}});
    for (std::size_t i = 0; i < listed.size(); ++i) {
      monitor.report("thumbnails", double(i) / double(listed.size()));
      const auto& info = listed[i].info;
      if (services_.makeThumbnail) listed[i].thumbnail = services_.makeThumbnail(info);
      if (services_.whoseSeries && info.patient)
        listed[i].patient = QString::fromStdString(services_.whoseSeries(info));
    }
    return [this, path, listed = std::move(listed)] {
      input_ = path;
      series_ = listed;
      makeLines();
    };
  });
}

void PreparePresenter::setPatientsShown(bool are_shown) {
  are_patients_shown_ = are_shown;
  if (!series_.empty()) makeLines();
}

void PreparePresenter::makeLines() {
  std::vector<dicom::SeriesInfo> infos;
  for (const auto& listed : series_) infos.push_back(listed.info);
  has_several_patients_ = dicom::patientCount(infos) > 1;
  has_several_readings_ = dicom::readingCount(infos) > 0;
  lines_.clear();
  for (const auto& listed : series_) {
    const auto& s = listed.info;
    SeriesLine line;
    line.thumbnail = listed.thumbnail;
    if (are_patients_shown_)
      line.patient = listed.patient;
    else if (s.patient && has_several_patients_)
      line.patient = tr("patient %1").arg(*s.patient);
    line.title = s.description.empty() ? tr("(no description)") : QString::fromStdString(s.description);
    line.detail = tr("%1  %2  %3 x %4 x %5  %6 mm  %7")
                      .arg(QString::fromStdString(s.modality), QString::fromStdString(s.plane))
                      .arg(s.columns)
                      .arg(s.rows)
                      .arg(s.slices)
                      .arg(s.spacing_mm.maxCoeff(), 0, 'f', 2)
                      .arg(QString::fromStdString(s.date));
    if (!s.part.empty()) line.title += "  " + QString::fromStdString(s.part);
    if (!s.fitness.empty()) line.detail += "\n" + shownWords(s.fitness);
    if (s.joined) line.detail += "\n" + shownWords(dicom::inWords(*s.joined));
    for (const auto& note : s.notes) line.detail += "\n" + shownWords(note);
    if (!s.is_loadable) line.detail = tr("not usable: %1").arg(shownWords(s.problem));
    line.is_usable = s.is_loadable;
    line.is_recommended = s.is_recommended;
    lines_.push_back(line);
  }
  emit linesChanged();
}

int PreparePresenter::recommendedLine() const {
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (lines_[i].is_recommended) return int(i);
  // Only a person can choose the patient or the reading.
  if (has_several_patients_ || has_several_readings_) return -1;
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (lines_[i].is_usable) return int(i);
  return -1;
}

void PreparePresenter::prepare(int line) {
  if (line < 0 || std::size_t(line) >= lines_.size() || !lines_[std::size_t(line)].is_usable) return;
  if (series_.empty()) return void(queue_.add(input_));
  const auto& chosen = series_[std::size_t(line)].info;
  queue_.add(input_, chosen.id.empty() ? chosen.series_uid : chosen.id);
}

void PreparePresenter::openCase(const QString& folder) {
  tasks_.start(tr("Opening the case"), [this, folder](TaskMonitor& monitor) -> TaskRunner::Delivery {
    auto loaded = loadCase(toPath(folder), monitor);
    return [this, loaded] { model_.open(loaded); };
  });
}

std::vector<FindingLine> PreparePresenter::findings() const {
  std::vector<FindingLine> lines;
  if (!model_.isOpen()) return lines;
  const auto& c = model_.current();
  const Eigen::Vector3d spacing_mm = c.mri->grid.spacing_mm();
  lines.push_back({tr("voxels %1 x %2 x %3 mm")
                       .arg(spacing_mm.x(), 0, 'f', 2)
                       .arg(spacing_mm.y(), 0, 'f', 2)
                       .arg(spacing_mm.z(), 0, 'f', 2),
                   volume::voxelSizeOf(spacing_mm.maxCoeff()) != volume::VoxelSize::fine});
  lines.push_back(
      {c.scalp->has_face ? tr("a face to align to") : tr("no face to align to"), !c.scalp->has_face});
  if (c.brain_mask) lines.push_back({tr("brain %1 ml").arg(std::lround(c.brain_mask->volume_ml())), false});
  for (const auto& finding : c.findings)
    lines.push_back(
        {shownWords(finding), true, steps::placeOfFinding(finding, *c.scalp, c.atlas ? &*c.atlas : nullptr)});
  return lines;
}

}  // namespace facenav::ui
