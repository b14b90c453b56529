#include "prepare/series_page.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "facenav/volume/nifti.h"
#include "shell/elided_label.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

constexpr int kThumbnail_px = 96;

QIcon iconOf(const std::optional<dicom::Thumbnail>& thumbnail) {
  QPixmap pixmap(kThumbnail_px, kThumbnail_px);
  pixmap.fill(themeColour(Colour::picture));
  if (thumbnail) {
    const QImage image(thumbnail->grey.data(), thumbnail->width_px, thumbnail->height_px, thumbnail->width_px,
                       QImage::Format_Grayscale8);
    pixmap = QPixmap::fromImage(image.copy());
  }
  return QIcon(pixmap);
}

}  // namespace

SeriesPage::SeriesPage(PreparePresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* head = new QHBoxLayout;
  auto* folder = new QPushButton(tr("Read DICOM folder\u2026"), this);
  auto* file = new QPushButton(tr("Read NIfTI file\u2026"), this);
  folder->setToolTip(tr("list the series under a folder (Ctrl+I); or drop a folder anywhere"));
  file->setToolTip(tr("a T1 of the whole head; or drop the file anywhere"));
  auto* archive = new QPushButton(tr("From the archive\u2026"), this);
  archive->setToolTip(tr("find and fetch a series of the hospital's PACS (Ctrl+Shift+A)"));
  archive->setShortcut(Qt::CTRL + Qt::SHIFT + Qt::Key_A);
  input_ = new ElidedLabel(this);
  input_->set(tr("or drop it anywhere in the window"));
  input_->setObjectName("muted");
  head->addWidget(folder);
  head->addWidget(file);
  head->addWidget(archive);
  auto* patients = new QCheckBox(tr("show patients"), this);
  patients->setToolTip(tr("name, birth date and ID from the files (Ctrl+P)"));
  patients->setShortcut(Qt::CTRL + Qt::Key_P);
  head->addWidget(input_, 1);
  head->addWidget(patients);
  series_ = new QListWidget(this);
  series_->setWordWrap(true);
  series_->setIconSize({kThumbnail_px, kThumbnail_px});
  series_->setAccessibleName(tr("series"));
  prepare_ = new QPushButton(tr("Prepare the chosen series"), this);
  prepare_->setObjectName("primary");
  prepare_->setToolTip(tr("model skin and brain; goes into the worklist's queue (Ctrl+Return)"));
  prepare_->setShortcut(Qt::CTRL + Qt::Key_Return);
  prepare_->setEnabled(false);
  column->addLayout(head);
  column->addWidget(series_, 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(prepare_);
  foot->addStretch(1);
  column->addLayout(foot);
  connect(folder, &QPushButton::clicked, this, &SeriesPage::chooseFolder);
  connect(archive, &QPushButton::clicked, this, &SeriesPage::archiveWanted);
  connect(file, &QPushButton::clicked, this, &SeriesPage::chooseFile);
  connect(prepare_, &QPushButton::clicked, this, &SeriesPage::queueChosen);
  connect(series_, &QListWidget::itemActivated, this, &SeriesPage::queueChosen);
  connect(series_, &QListWidget::currentRowChanged, this, [this](int line) {
    prepare_->setEnabled(line >= 0 && presenter_.lines()[std::size_t(line)].is_usable);
  });
  connect(patients, &QCheckBox::toggled, &presenter_, &PreparePresenter::setPatientsShown);
  connect(&presenter_, &PreparePresenter::linesChanged, this, &SeriesPage::showLines);
  whenThemeChanges(this, [this] {
    const int row = series_->currentRow();
    if (series_->count() > 0) showLines();
    series_->setCurrentRow(row);
  });
}

void SeriesPage::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Read DICOM folder"));
  if (!folder.isEmpty()) presenter_.openInput(folder);
}

void SeriesPage::chooseFile() {
  QStringList patterns;
  for (const auto& ending : volume::niftiEndings()) patterns << "*" + QString::fromStdString(ending);
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Read NIfTI"), {}, tr("NIfTI (%1)").arg(patterns.join(' ')));
  if (!path.isEmpty()) presenter_.openInput(path);
}

void SeriesPage::showLines() {
  series_->clear();
  input_->set(presenter_.lines().empty() ? tr("nothing found")
                                         : tr("series found: %1").arg(presenter_.lines().size()));
  for (const auto& line : presenter_.lines()) {
    const QString mark = line.is_recommended ? tr("\u2605 recommended: ")
                         : line.is_usable    ? QString()
                                             : tr("\u2715 ");
    const QString whose = line.patient.isEmpty() ? QString() : "  \u00b7  " + line.patient;
    auto* item =
        new QListWidgetItem(iconOf(line.thumbnail), mark + line.title + whose + "\n" + line.detail, series_);
    if (!line.is_usable) item->setForeground(themeColour(Colour::muted));
  }
  series_->setCurrentRow(presenter_.recommendedLine());
}

void SeriesPage::queueChosen() {
  if (!prepare_->isEnabled()) return;
  presenter_.prepare(series_->currentRow());
  emit queued();
}

}  // namespace facenav::ui
