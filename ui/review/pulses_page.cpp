#include "review/pulses_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "facenav/core/settings_in_force.h"
#include "facenav/report/review_charts.h"
#include "facenav/review/pulse_pictures.h"
#include "review/chart_view.h"
#include "shell/appearance.h"
#include "shell/colour_legend.h"
#include "shell/narrow_label.h"
#include "shell/scene_view.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

QString placeWords(const Point<Mri>& p) {
  return QString("%1 %2 %3").arg(p.mm.x(), 0, 'f', 1).arg(p.mm.y(), 0, 'f', 1).arg(p.mm.z(), 0, 'f', 1);
}

QString mapWords(const guidance::MepMap& map) {
  const auto& options = settingsOf<guidance::MepMapOptions>();
  return QObject::tr(
             "MEP map (sigma %1 mm): peak %2 uV at %3, centre of gravity %4 (RAS mm), area at %5 uV or more "
             "%6 mm\u00b2, "
             "%7 of %8 pulses responded")
      .arg(options.mep_sigma_mm)
      .arg(map.peak_uv, 0, 'f', 0)
      .arg(placeWords(map.peak), placeWords(map.centre_of_gravity))
      .arg(options.mep_threshold_uv)
      .arg(map.area_mm2, 0, 'f', 0)
      .arg(map.responses)
      .arg(map.sites);
}

}  // namespace

PulsesPage::PulsesPage(ReviewPresenter& presenter, CaseModel& model, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      model_(model),
      field_map_(presenter, model),
      scene_(new SceneView(this)),
      layer_(std::make_unique<scene::PulseLayer>(scene_->scene())),
      map_words_(new QLabel(this)),
      histogram_(new ChartView(this)),
      drift_(new ChartView(this)) {
  map_words_->setObjectName("muted");
  makeNarrow(*map_words_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scene_, 3);
  column->addWidget(makeChoice());
  column->addWidget(map_words_);
  auto* charts = new QHBoxLayout;
  charts->addWidget(histogram_, 1);
  charts->addWidget(drift_, 1);
  column->addLayout(charts, 2);
  connect(scene_, &SceneView::picked, this, [this](double x, double y, double z, bool is_brain) {
    presenter_.markNear({x, y, z}, is_brain);
  });
  const auto outdated = [this] {
    is_outdated_ = true;
    if (isVisible()) showCase();
  };
  connect(&model_, &CaseModel::opened, this, outdated);
  connect(&model_, &CaseModel::brainChanged, this, outdated);
  connect(&presenter_, &ReviewPresenter::sessionChanged, this, &PulsesPage::showSession);
  connect(&presenter_, &ReviewPresenter::markedChanged, this, &PulsesPage::showPulses);
  connect(&presenter_, &ReviewPresenter::columnChanged, this, [this] {
    showPulses();
    showCharts();
  });
}

PulsesPage::~PulsesPage() = default;

QWidget* PulsesPage::makeChoice() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  column_ = new QComboBox(bar);
  column_->setAccessibleName(tr("number that is coloured"));
  for (const auto& words : report::pulseColumns()) column_->addItem(shownWords(std::string(words.name)));
  column_->setToolTip(tr("the number by which the pulses are coloured and plotted"));
  legend_ = new ColourLegend(bar);
  heat_ = new QCheckBox(tr("MEP map"), bar);
  heat_->setToolTip(tr("the MEPs, smoothed over the brain's surface, in place of the pulses"));
  by_field_ = new QCheckBox(tr("by field"), bar);
  by_field_->setToolTip(
      tr("which place of the cortex explains the MEPs, by the electric field of each pulse there: R2 of the "
         "MEPs on the field; coil as in Plan; what it means: the manual's page 'Field'"));
  skin_ = new QCheckBox(tr("skin"), bar);
  skin_->setToolTip(tr("shows the scalp over the brain"));
  skin_->setChecked(true);
  row->addWidget(column_);
  row->addWidget(legend_, 1);
  row->addWidget(heat_);
  row->addWidget(by_field_);
  row->addWidget(skin_);
  connect(column_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int i) { presenter_.setColumn(report::PulseColumn(i)); });
  connect(heat_, &QCheckBox::toggled, this, [this](bool is_shown) {
    if (is_shown) by_field_->setChecked(false);
    showPulses();
    showMapWords();
  });
  connect(by_field_, &QCheckBox::toggled, this, [this](bool is_shown) {
    if (is_shown) heat_->setChecked(false);
    field_map_.setOn(is_shown);
  });
  connect(&field_map_, &FieldMapPresenter::changed, this, [this] {
    showPulses();
    showMapWords();
  });
  connect(skin_, &QCheckBox::toggled, this, [this](bool is_shown) {
    scene::SceneLayers layers;
    layers.scalp = is_shown;
    scene_->scene().setLayers(layers);
    scene_->refresh();
  });
  return bar;
}

void PulsesPage::showCase() {
  if (!is_outdated_ || !model_.isOpen()) return;
  is_outdated_ = false;
  placed_for_.clear();
  layer_->set({});
  layer_->clearHeat();
  scene_->show(model_.current());
  showSession();
}

void PulsesPage::showSession() {
  if (is_outdated_ || !isVisible()) return;
  const auto session = presenter_.session();
  std::vector<guidance::Target> targets;
  if (session)
    for (const auto& reviewed : session->kept.pulses.pulses) {
      const auto& target = reviewed.pulse.target;
      const bool is_new = target && std::none_of(targets.begin(), targets.end(),
                                                 [&](const auto& t) { return t.name == target->name; });
      if (is_new) targets.push_back(*target);
    }
  scene_->scene().setTargets(targets, targets.empty() ? "" : targets.front().name);
  if (session && placed_for_ != presenter_.chosen()) {
    placed_for_ = presenter_.chosen();
    scene_->scene().setView(scene::ViewPreset::target);
  }
  const bool has_map = session && session->map;
  heat_->setEnabled(has_map);
  if (!has_map) heat_->setChecked(false);
  by_field_->setEnabled(has_map);
  if (!has_map) by_field_->setChecked(false);
  showMapWords();
  showPulses();
  showCharts();
}

void PulsesPage::showPulses() {
  if (is_outdated_ || !isVisible()) return;
  const auto session = presenter_.session();
  column_->setCurrentIndex(int(presenter_.column()));
  layer_->clearHeat();
  const auto& words = report::wordsOf(presenter_.column());
  const QString name = shownWords(std::string(words.name));
  if (!session) {
    layer_->set({});
    legend_->set({}, {}, 0, std::nullopt);
  } else if ((heat_->isChecked() && session->map) || isExplained(session)) {
    showHeat(session);
  } else {
    const auto& pulses = session->kept.pulses.pulses;
    layer_->set(steps::marksOf(pulses, session->places, presenter_.column(),
                               presenter_.marked() ? std::optional(presenter_.marked()) : std::nullopt));
    const auto range = steps::rangeOf(pulses, presenter_.column());
    legend_->set(range ? name : tr("no pulse has: %1").arg(name), words.unit, words.decimals, range);
  }
  scene_->refresh();
}

/// True if there is a map by field of this session that tells more than chance.
bool PulsesPage::isExplained(const std::shared_ptr<const ReviewedSession>& session) const {
  const auto* by_field = field_map_.shown();
  return by_field && by_field->session == session && by_field->map.regression.is_explained;
}

void PulsesPage::showHeat(const std::shared_ptr<const ReviewedSession>& session) {
  layer_->set({});
  if (isExplained(session)) {
    const auto* by_field = field_map_.shown();
    const scene::ColourRange range{0, by_field->map.regression.r2};
    layer_->setHeat(session->brain->mesh, by_field->r2, range);
    return legend_->set(tr("R\u00b2 of the MEPs on the field"), {}, 2, range);
  }
  const scene::ColourRange range{0, session->map->peak_uv};
  layer_->setHeat(session->brain->mesh, session->map->mep_uv, range);
  legend_->set(tr("MEP"), "uV", 0, range);
}

void PulsesPage::showMapWords() {
  const auto session = presenter_.session();
  const bool has_map = session && session->map;
  map_words_->setText(field_map_.isOn() ? field_map_.words() : has_map ? mapWords(*session->map) : QString());
  map_words_->setVisible(!map_words_->text().isEmpty());
}

void PulsesPage::showCharts() {
  const auto session = presenter_.session();
  const auto column = presenter_.column();
  if (!session) {
    histogram_->set({});
    return drift_->set({});
  }
  histogram_->set([session, column](int width, int height) {
    return report::histogramOf(session->kept.pulses.pulses, column, width, height);
  });
  drift_->set([session, column](int width, int height) {
    return report::driftChart(session->kept.pulses.pulses, column, width, height);
  });
}

void PulsesPage::showEvent(QShowEvent*) {
  showCase();
  showSession();
}

}  // namespace facenav::ui
