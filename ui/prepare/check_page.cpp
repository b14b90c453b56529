#include "prepare/check_page.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "prepare/edit_panel.h"
#include "shell/appearance.h"
#include "shell/help_window.h"
#include "shell/linked_views.h"
#include "shell/scroll_column.h"
#include "shell/theme.h"
#include "shell/wrapped_list.h"

namespace facenav::ui {

CheckPage::CheckPage(PreparePresenter& presenter, EditPresenter& edit, CaseModel& model, QWidget* parent)
    : QWidget(parent), presenter_(presenter), edit_(edit), model_(model), views_(new LinkedViews(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(views_, 1);
  row->addWidget(makeFindingsPanel());
  connect(&model_, &CaseModel::opened, this, [this] {
    is_outdated_ = true;
    if (isVisible()) showCase();
  });
  connect(&model_, &CaseModel::brainChanged, this, [this] {
    if (is_outdated_) return;
    views_->setBrain(model_.current());
    showFindings();
  });
  whenThemeChanges(this, [this] {
    if (!is_outdated_ && model_.isOpen()) showFindings();
  });
  views_->setTool(&edit_);
  auto& scene_view = views_->sceneView();
  connect(&edit_, &EditPresenter::changed, this, [this, &scene_view] {
    scene_view.setDrawing(edit_.canEdit() && edit_.tool() == EditTool::scalpel);
  });
  connect(&scene_view, &SceneView::outlineDrawn, this,
          [this, &scene_view](const std::vector<Eigen::Vector2d>& outline) {
            const auto seen = scene_view.projection();
            edit_.cut({seen.screen_from_mri, seen.eye}, outline);
          });
  connect(&edit_, &EditPresenter::brainFollowed, this,
          [this](const std::shared_ptr<const surface::BrainModel>& brain) {
            if (!is_outdated_) views_->setBrain(*brain);
          });
  // A stroke redraws only its own view; the others follow when it ends.
  connect(&edit_, &EditPresenter::maskChanged, this, [this](bool is_stroke) {
    if (!is_stroke && !is_outdated_ && isVisible()) views_->refreshSlices();
  });
}

QWidget* CheckPage::makeFindingsPanel() {
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  auto* heading = new QLabel(tr("Findings"), panel);
  heading->setObjectName("heading");
  findings_ = new WrappedList(panel);
  findings_->setAccessibleName(tr("findings"));
  findings_->setToolTip(tr("underlined findings go to their place (click, or Return)"));
  const auto goTo = [this](QListWidgetItem* item) {
    const auto lines = presenter_.findings();
    const auto row = std::size_t(findings_->row(item));
    if (row < lines.size() && lines[row].place) lookAt(*lines[row].place);
  };
  connect(findings_, &QListWidget::itemClicked, this, goTo);
  connect(findings_, &QListWidget::itemActivated, this, goTo);
  auto* masks = new QCheckBox(tr("mask contours"), panel);
  masks->setChecked(true);
  masks->setToolTip(tr("skin orange, brain blue (M)"));
  masks->setShortcut(Qt::Key_M);
  auto* go_on = new QPushButton(tr("Looks right: sign off"), panel);
  go_on->setObjectName("primary");
  go_on->setToolTip(tr("on to step 4 (Ctrl+Return)"));
  go_on->setShortcut(Qt::CTRL + Qt::Key_Return);
  connect(masks, &QCheckBox::toggled, views_, &LinkedViews::setMasksShown);
  connect(go_on, &QPushButton::clicked, this, &CheckPage::goOn);
  whenTextScales(this, [this] { findings_->setMinimumHeight(sized(110)); });
  findings_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // takes the remaining room
  auto* body = new QWidget(panel);
  auto* within = new QVBoxLayout(body);
  within->setContentsMargins(0, 0, 0, 0);
  within->addWidget(findings_, 1);
  within->addWidget(masks);
  auto* edit = new EditPanel(edit_, panel);
  HelpWindow::setPlace(*edit, "prepare.md", "correct-the-brain-facenav-brain");
  within->addWidget(edit);
  column->addWidget(heading);
  column->addWidget(new ScrollColumn(body, 310, panel), 1);
  connect(edit, &EditPanel::automaticShown, this, [this](bool is_shown) {
    shows_automatic_ = is_shown;
    showContours();
  });
  column->addWidget(go_on);
  return panel;
}

void CheckPage::lookAt(const Point<Mri>& at) {
  showCase();
  views_->setCrosshair(at);
}

void CheckPage::showCase() {
  if (!is_outdated_ || !model_.isOpen()) return;
  is_outdated_ = false;
  views_->show(model_.current());
  showContours();
  showFindings();
}

/// Shows the contours: skin orange, brain under correction blue, automatic brain white.
void CheckPage::showContours() {
  if (!model_.isOpen() || is_outdated_) return;
  std::vector<scene::SliceContour> contours{{model_.current().head_mask, scene::palette::kOrange}};
  if (shows_automatic_ && edit_.automatic()) contours.push_back({edit_.automatic(), scene::palette::kText});
  if (edit_.mask()) contours.push_back({edit_.mask(), scene::palette::kBlue});
  views_->setContours(contours);
}

void CheckPage::showFindings() {
  findings_->clear();
  for (const auto& line : presenter_.findings()) {
    auto* item = new QListWidgetItem((line.is_caution ? tr("!  ") : tr("\u2713  ")) + line.words, findings_);
    item->setForeground(themeColour(line.place        ? Colour::link
                                    : line.is_caution ? Colour::caution_words
                                                      : Colour::text));
    if (!line.place) {
      item->setFlags(Qt::ItemIsEnabled);  // no link: it cannot be selected or activated
      continue;
    }
    item->setToolTip(tr("go to this place"));
    QFont link = item->font();
    link.setUnderline(true);
    item->setFont(link);
  }
}

void CheckPage::showEvent(QShowEvent*) { showCase(); }

}  // namespace facenav::ui
