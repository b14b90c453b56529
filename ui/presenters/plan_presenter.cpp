#include "presenters/plan_presenter.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/guidance/handle.h"
#include "facenav/surface/closest_point.h"
#include "facenav/surface/outside_head.h"
#include "presenters/typed_coordinates.h"

namespace facenav::ui {
namespace {

constexpr double kUsualHandle_rad = M_PI / 4;

Point<Mri> nearestVertex(const surface::TriangleMesh& mesh, const Point<Mri>& p) {
  Eigen::Vector3d best = p.mm;
  double least = 1e300;
  for (const auto& v : mesh.vertices_mm)
    if (const double d = (v - p.mm).squaredNorm(); d < least) least = d, best = v;
  return Point<Mri>(best);
}

QString signedDegrees(double degrees) {
  const long whole = std::lround(degrees);
  return (whole > 0 ? "+" : "") + QString::number(whole);
}

QString gapWords(const guidance::Target& target) {
  return QString::number(std::max(0.0, guidance::hairGap_mm(target)), 'f', 1);  // no "-0.0"
}

}  // namespace

PlanPresenter::PlanPresenter(CaseModel& model, QObject* parent) : QObject(parent), model_(model) {
  connect(&model_, &CaseModel::opened, this, [this] {
    undo_.clear();
    redo_.clear();
    active_ = plan().targets.empty() ? QString() : QString::fromStdString(plan().targets.front().name);
    emit changed();
  });
}

const guidance::TreatmentPlan& PlanPresenter::plan() const {
  static const guidance::TreatmentPlan kNone;
  return model_.isOpen() ? model_.current().plan : kNone;
}

const guidance::Target* PlanPresenter::active() const {
  for (const auto& target : plan().targets)
    if (target.name == active_.toStdString()) return &target;
  return nullptr;
}

void PlanPresenter::setActive(const QString& name) {
  if (name == active_) return;
  active_ = name;
  emit changed();
}

QString PlanPresenter::freeName() const {
  for (int n = 1;; ++n) {
    const QString name = tr("Target %1").arg(n);
    const auto has = [&](const guidance::Target& t) { return t.name == name.toStdString(); };
    if (std::none_of(plan().targets.begin(), plan().targets.end(), has)) return name;
  }
}

bool PlanPresenter::store(const guidance::TreatmentPlan& plan, const QString& active) {
  try {
    model_.setPlan(plan);
  } catch (const std::exception& error) {  // the file system's own errors too
    emit refused(QString::fromUtf8(error.what()));
    return false;
  }
  active_ = active;
  return true;
}

void PlanPresenter::apply(const guidance::TreatmentPlan& next, const QString& active) {
  const Step step{plan(), next, active_, active};
  if (!store(next, active)) return;
  undo_.push_back(step);
  redo_.clear();
  emit changed();
}

bool PlanPresenter::refusesOutside(const Point<Mri>& point, double limit_mm) {
  const auto& c = model_.current();
  const double outside_mm = surface::outsideHead_mm(*c.head_mask, *c.scalp, point);
  if (outside_mm <= limit_mm) return false;
  emit refused(tr("no target: the place lies %1 mm outside the head; choose one in the head")
                   .arg(outside_mm, 0, 'f', 0));
  return true;
}

void PlanPresenter::addTarget(const Point<Mri>& cortex_point) {
  if (!model_.isOpen() || refusesOutside(cortex_point, 0.0)) return;
  try {
    auto next = plan();
    const QString name = freeName();
    next.targets.push_back(
        guidance::planTarget(name.toStdString(), *model_.current().scalp, cortex_point, kUsualHandle_rad));
    apply(next, name);
  } catch (const Error& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
}

void PlanPresenter::addTargetAtScalp(const Point<Mri>& scalp_point) {
  if (!model_.isOpen()) return;
  if (!model_.current().brain) {
    emit refused(tr("no brain model: click on the slice where the target lies"));
    return;
  }
  addTarget(nearestVertex(model_.current().brain->mesh, scalp_point));
}

void PlanPresenter::addTargetNear(const Point<Mri>& point) {
  if (!model_.isOpen() || refusesOutside(point, surface::kFarthestOutside_mm)) return;
  if (!model_.current().brain) return addTarget(point);
  const auto nearest = surface::ClosestPoint(model_.current().brain->mesh).nearest(point);
  addTarget(nearest.is_outside ? nearest.point : point);
}

void PlanPresenter::removeActive() {
  if (!active()) return;
  auto next = plan();
  const auto is_active = [&](const guidance::Target& t) { return t.name == active_.toStdString(); };
  next.targets.erase(std::remove_if(next.targets.begin(), next.targets.end(), is_active), next.targets.end());
  apply(next, next.targets.empty() ? QString() : QString::fromStdString(next.targets.back().name));
}

void PlanPresenter::replaceActive(const guidance::Target& target) {
  auto next = plan();
  for (auto& t : next.targets)
    if (t.name == active_.toStdString()) t = target;
  apply(next, QString::fromStdString(target.name));
}

void PlanPresenter::renameActive(const QString& name) {
  const auto* target = active();
  const QString wanted = name.trimmed();
  if (!target || wanted.isEmpty() || wanted == active_) return;
  for (const auto& other : plan().targets)
    if (other.name == wanted.toStdString()) {
      emit refused(tr("there is a target '%1' already").arg(wanted));
      emit changed();
      return;
    }
  auto renamed = *target;
  renamed.name = wanted.toStdString();
  replaceActive(renamed);
}

void PlanPresenter::turnActive(double degrees) {
  const auto* target = active();
  if (!target) return;
  auto turned = *target;
  const RigidTransform<Target, Target> about_z(
      Eigen::Quaterniond(Eigen::AngleAxisd(degrees * M_PI / 180.0, Eigen::Vector3d::UnitZ())),
      Eigen::Vector3d::Zero());
  turned.mri_T_target = target->mri_T_target * about_z;
  replaceActive(turned);
}

template <class Change>
void PlanPresenter::setTyped(const QString& typed, const QString& unit, Change change) {
  const auto* target = active();
  if (!target) return;
  const auto number = readNumber(typed, unit);
  if (!number) return void(emit refused(tr("'%1' is no number").arg(typed.trimmed())));
  try {
    replaceActive(change(*target, *number));
  } catch (const Error& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
}

void PlanPresenter::setHandle(const QString& typed) {
  setTyped(typed, QString(QChar(0xb0)), [this](const guidance::Target& target, double degrees) {
    return guidance::withHandleAngle(target, *model_.current().scalp, degrees * M_PI / 180.0);
  });
}

void PlanPresenter::setGap(const QString& typed) {
  setTyped(typed, tr("mm"), [](const guidance::Target& target, double gap_mm) {
    return guidance::withHairGap(target, gap_mm);
  });
}

void PlanPresenter::nudgeActive(double x_mm, double y_mm) {
  const auto* target = active();
  if (!target) return;
  try {
    replaceActive(guidance::movedAlongScalp(*target, *model_.current().scalp, x_mm, y_mm));
  } catch (const Error& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
}

void PlanPresenter::undo() {
  if (undo_.empty() || !store(undo_.back().before, undo_.back().active_before)) return;
  redo_.push_back(undo_.back());
  undo_.pop_back();
  emit changed();
}

void PlanPresenter::redo() {
  if (redo_.empty() || !store(redo_.back().after, redo_.back().active_after)) return;
  undo_.push_back(redo_.back());
  redo_.pop_back();
  emit changed();
}

double PlanPresenter::handleAngle_deg(const guidance::Target& target) const {
  return guidance::handleAngle(target, *model_.current().scalp).angle_rad * 180.0 / M_PI;
}

QString PlanPresenter::handleFigure() const {
  if (!active()) return {};
  const double tenths = std::round(10.0 * handleAngle_deg(*active()));
  return (tenths > 0 ? "+" : "") + QString::number(tenths / 10.0 + 0.0);  // no "-0"
}

QString PlanPresenter::gapFigure() const { return active() ? gapWords(*active()) : QString(); }

QString PlanPresenter::handleWords(const guidance::Target& target) const {
  const auto handle = guidance::handleAngle(target, *model_.current().scalp);
  const bool is_anterior = handle.reference == guidance::HandleReference::anterior;
  return tr("handle %1\u00b0 from %2 (+ to the midline)")
      .arg(signedDegrees(handle.angle_rad * 180.0 / M_PI))
      .arg(is_anterior ? tr("anterior") : tr("superior"));
}

QString PlanPresenter::describe(const guidance::Target& target) const {
  const Eigen::Vector3d& c = target.cortex_point.mm;
  const auto side = [](double mm, const QString& positive, const QString& negative) {
    return (mm >= 0 ? positive : negative) + QString::number(std::abs(std::lround(mm)));
  };
  return tr("%1 %2 %3\n%4 mm below the skin, gap %5 mm\n%6")
      .arg(side(c.x(), tr("R"), tr("L")), side(c.y(), tr("A"), tr("P")), side(c.z(), tr("S"), tr("I")))
      .arg((target.scalp_point.mm - c).norm(), 0, 'f', 0)
      .arg(gapWords(target))
      .arg(handleWords(target));
}

}  // namespace facenav::ui
