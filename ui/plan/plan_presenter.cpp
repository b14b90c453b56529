#include "plan/plan_presenter.h"

#include <algorithm>
#include <cmath>

#include "facenav/casefile/protocol.h"
#include "facenav/coil_library/coil_library.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/compare_targets.h"
#include "facenav/guidance/handle.h"
#include "facenav/plan/coil_slice_sheet.h"
#include "plan/typed_coordinates.h"
#include "shell/author.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

/// The refusal in the window's language; other errors keep their own words.
QString wordsOf(const steps::PlanRefused& refused, const QString& name) {
  switch (refused.refusal()) {
    case steps::PlanRefusal::outside_head:
      return PlanPresenter::tr("no target: the place lies %1 mm outside the head; choose one in the head")
          .arg(refused.outside_mm(), 0, 'f', 0);
    case steps::PlanRefusal::name_taken:
      return PlanPresenter::tr("there is a target '%1' already").arg(name);
    case steps::PlanRefusal::no_brain:
      return PlanPresenter::tr("no brain model: click on the slice where the target lies");
    case steps::PlanRefusal::locked:
      return PlanPresenter::tr("the target is locked; unlock it first");
  }
  return {};
}

QString signedDegrees(double degrees) {
  const long whole = std::lround(degrees);
  return (whole > 0 ? "+" : "") + QString::number(whole);
}

QString gapWords(const guidance::Target& target) {
  return QString::number(std::max(0.0, guidance::hairGap_mm(target)), 'f', 1);  // never "-0.0"
}

}  // namespace

PlanPresenter::PlanPresenter(CaseModel& model, QObject* parent)
    : QObject(parent), model_(model), editor_(planned()) {
  connect(&model_, &CaseModel::opened, this, [this] {
    editor_.begin();
    emit changed();
  });
}

steps::PlannedCase PlanPresenter::planned() {
  return {[this]() -> const guidance::TreatmentPlan& { return plan(); },
          [this] {
            const auto& c = model_.current();
            return steps::PlannedHead{c.scalp, c.head_mask, c.brain, c.coil.plate};
          },
          [this](const guidance::TreatmentPlan& next) { model_.setPlan(next); },
          [](int n) { return tr("Target %1").arg(n).toStdString(); }, recordedAuthor};
}

const guidance::TreatmentPlan& PlanPresenter::plan() const {
  static const guidance::TreatmentPlan kNone;
  return model_.isOpen() ? model_.current().plan : kNone;
}

const guidance::Target* PlanPresenter::active() const { return editor_.active(); }

void PlanPresenter::setActive(const QString& name) {
  if (name == activeName()) return;
  editor_.setActive(name.toStdString());
  emit changed();
}

std::optional<scene::SlicedCoil> PlanPresenter::slicedCoil() const {
  const auto* target = active();
  if (!target) return std::nullopt;
  return scene::SlicedCoil{target->mri_T_target.reframe<Mri, Coil>(),  // the planned coil
                           model_.current().coil.plate,
                           steps::alignedBound95_mm(model_.current().store, *target)};
}

template <class Edit>
QString PlanPresenter::refusalOf(Edit edit, const QString& name) {
  if (!model_.isOpen()) return {};
  try {
    edit();
    emit changed();
    return {};
  } catch (const steps::PlanRefused& refusal) {
    if (refusal.refusal() == steps::PlanRefusal::name_taken) emit changed();  // shows the old name again
    return wordsOf(refusal, name);
  } catch (const std::exception& error) {  // includes errors of the file system
    return shownWords(error);
  }
}

template <class Edit>
void PlanPresenter::attempt(Edit edit, const QString& name) {
  const QString why = refusalOf(edit, name);
  if (!why.isEmpty()) emit refused(why);
}

void PlanPresenter::addTarget(const Point<Mri>& cortex_point) {
  attempt([&] { editor_.addTarget(cortex_point); });
}

void PlanPresenter::addTargetAtScalp(const Point<Mri>& scalp_point) {
  attempt([&] { editor_.addTargetAtScalp(scalp_point); });
}

void PlanPresenter::addTargetNear(const Point<Mri>& point) {
  attempt([&] { editor_.addTargetNear(point); });
}

void PlanPresenter::addPreset(const QString& preset, const steps::HeadMeasures& measures) {
  attempt([&] {
    const auto& atlas = model_.current().atlas;
    const auto& named = steps::presetNamed(preset.toStdString());
    editor_.addTarget(steps::placeOf(named, atlas ? &*atlas : nullptr, measures), named.name);
  });
}

void PlanPresenter::removeActive() {
  if (active()) attempt([&] { editor_.remove(); });
}

void PlanPresenter::renameActive(const QString& name) {
  const QString wanted = name.trimmed();
  if (!active() || wanted.isEmpty() || wanted == activeName()) return;
  attempt([&] { editor_.rename(wanted.toStdString()); }, wanted);
}

void PlanPresenter::turnActive(double degrees) {
  if (active()) attempt([&] { editor_.turn(degrees * kRadPerDeg); });
}

// The class is named before tr(): lupdate would take the template's parameter for it.
template <class Change>
QString PlanPresenter::setTyped(const QString& typed, const QString& unit, Change change) {
  const auto* target = active();
  if (!target) return {};
  const QString words = typed.trimmed();
  if (words.isEmpty()) return PlanPresenter::tr("a number is expected");
  const auto number = readNumber(typed, unit);
  const QString why = number ? refusalOf([&] { editor_.replace(change(*target, *number)); })
                             : PlanPresenter::tr("that is no number");
  return why.isEmpty() ? why : PlanPresenter::tr("'%1' is not taken: %2").arg(words, why);
}

QString PlanPresenter::setHandle(const QString& typed) {
  return setTyped(typed, QString(QChar(0xb0)), [this](const guidance::Target& target, double degrees) {
    return guidance::withHandleAngle(target, *model_.current().scalp, degrees * kRadPerDeg);
  });
}

QString PlanPresenter::setGap(const QString& typed) {
  return setTyped(typed, tr("mm"), [](const guidance::Target& target, double gap_mm) {
    return guidance::withHairGap(target, gap_mm);
  });
}

void PlanPresenter::nudgeActive(double x_mm, double y_mm) {
  if (active()) attempt([&] { editor_.nudge(x_mm, y_mm); });
}

void PlanPresenter::takePose(const guidance::Target& pose, const std::string& what) {
  if (!active()) return;
  attempt([&] {
    auto target = *active();
    target.mri_T_target = pose.mri_T_target;
    target.scalp_point = pose.scalp_point;
    target.lift_mm = pose.lift_mm;
    editor_.replace(target, what);
  });
}

void PlanPresenter::duplicateActive() {
  if (active()) attempt([&] { editor_.duplicate(); });
}

void PlanPresenter::mirrorActive() {
  if (!active()) return;
  const auto& atlas = model_.current().atlas;
  if (!atlas) return void(emit refused(tr("the case has no atlas, which the other side is found with")));
  attempt([&] {
    editor_.mirror([&](const Point<Mri>& p) {
      Point<Mni> there = atlas->toMni(p);
      there.mm.x() = -there.mm.x();
      return atlas->toMri(there);
    });
  });
}

void PlanPresenter::lockActive(bool is_locked) {
  if (active()) attempt([&] { editor_.setLocked(is_locked); });
}

void PlanPresenter::setNote(const QString& note) {
  if (active()) attempt([&] { editor_.setNote(note.trimmed().toStdString()); });
}

void PlanPresenter::setDose(const std::optional<guidance::Dose>& dose) {
  if (!active()) return;
  attempt([&] {
    if (dose) guidance::requireSensible(*dose);
    editor_.setDose(dose);
  });
}

void PlanPresenter::setProtocol(const QString& file) {
  attempt([&] {
    casefile::setProtocol(model_.current().store.folder(), casefile::readProtocol(file.toStdString()));
  });
}

void PlanPresenter::removeProtocol() {
  attempt([&] { casefile::removeProtocol(model_.current().store.folder()); });
}

void PlanPresenter::setCoil(const QString& file) {
  attempt([&] { model_.setCoil(file.toStdString()); });
}

QStringList PlanPresenter::libraryCoils() const {
  QStringList names;
  for (const auto& coil : coil_library::coilsIn(coil_library::coilLibrary()))
    if (coil.problem.empty()) names << QString::fromStdString(coil.name);
  return names;
}

void PlanPresenter::setCoilNamed(const QString& name) {
  attempt(
      [&] { model_.setCoil(coil_library::findCoil(coil_library::coilLibrary(), name.toStdString()).file); });
}

std::optional<guidance::Dose> PlanPresenter::doseInForce() const {
  if (!model_.isOpen()) return std::nullopt;
  if (active() && active()->dose) return active()->dose;
  try {
    const auto protocol = casefile::protocolOf(model_.current().store.folder());
    return protocol ? std::optional(protocol->dose) : std::nullopt;
  } catch (const Error&) {  // protocolWords() gives the reason
    return std::nullopt;
  }
}

QString PlanPresenter::protocolWords() const {
  if (!model_.isOpen()) return tr("no case is open");
  try {
    const auto protocol = casefile::protocolOf(model_.current().store.folder());
    if (!protocol) return tr("none");
    return tr("'%1', version %2: %3 pulses")
        .arg(QString::fromStdString(protocol->name))
        .arg(protocol->version)
        .arg(protocol->dose.pulses);
  } catch (const Error& fault) {
    return shownWords(fault);
  }
}

QString PlanPresenter::durationWords() const {
  const auto dose = doseInForce();
  const auto duration_s = dose ? dose->duration_s() : std::nullopt;
  if (!duration_s) return {};
  return tr("%1 min %2 s").arg(int(*duration_s) / 60).arg(int(*duration_s) % 60);
}

QString PlanPresenter::coilWords() const {
  if (!model_.isOpen()) return {};
  const auto& coil = model_.current().coil;
  if (coil.is_default) return tr("a usual figure-of-eight (the case names none)");
  return coil.name.empty() ? tr("without a name") : QString::fromStdString(coil.name);
}

void PlanPresenter::setGrid(const std::optional<guidance::GridSpec>& grid) {
  if (active()) attempt([&] { editor_.setGrid(grid); });
}

void PlanPresenter::takePlan(const guidance::TreatmentPlan& next, const QString& active) {
  editor_.take(next, active.toStdString());
  emit changed();
}

void PlanPresenter::moveActive(int places) {
  if (active()) attempt([&] { editor_.move(places); });
}

void PlanPresenter::undo() {
  if (canUndo()) attempt([&] { editor_.undo(); });
}

void PlanPresenter::redo() {
  if (canRedo()) attempt([&] { editor_.redo(); });
}

double PlanPresenter::handleAngle_deg(const guidance::Target& target) const {
  return guidance::handleAngle(target, *model_.current().scalp).angle_rad * kDegPerRad;
}

QString PlanPresenter::handleFigure() const {
  if (!active()) return {};
  const double tenths = std::round(10.0 * handleAngle_deg(*active()));
  return (tenths > 0 ? "+" : "") + QString::number(tenths / 10.0 + 0.0);  // never "-0"
}

QString PlanPresenter::gapFigure() const { return active() ? gapWords(*active()) : QString(); }

QString PlanPresenter::handleWords(const guidance::Target& target) const {
  const auto handle = guidance::handleAngle(target, *model_.current().scalp);
  const bool is_anterior = handle.reference == guidance::HandleReference::anterior;
  return tr("handle %1\u00b0 from %2 (+ to the midline)")
      .arg(signedDegrees(handle.angle_rad * kDegPerRad))
      .arg(is_anterior ? tr("anterior") : tr("superior"));
}

QString PlanPresenter::contactWords(const guidance::Target& target) const {
  try {
    const auto contact = guidance::contactOf(target, *model_.current().scalp, model_.current().coil.plate);
    if (contact.through_mm >= 0.5)
      return tr("the coil passes %1 mm through the skin").arg(contact.through_mm, 0, 'f', 1);
    if (contact.isTangent()) return tr("rests flat on the head");
    return tr("stands %1 mm over the skin, tilted %2\u00b0")
        .arg(contact.lift_mm, 0, 'f', 1)
        .arg(std::lround(contact.tilt_rad * kDegPerRad));
  } catch (const Error& error) {
    return shownWords(error);
  }
}

QString PlanPresenter::compareWords(const QString& other) const {
  const auto* from = steps::find(plan(), other.toStdString());
  if (!from || !active()) return {};
  const auto d = guidance::compareTargets(*from, *active());
  return tr("from '%1': %2 mm, cortex %3 mm, tilt %4\u00b0, twist %5\u00b0")
      .arg(other)
      .arg(d.centres_mm, 0, 'f', 1)
      .arg(d.cortex_mm, 0, 'f', 1)
      .arg(std::lround(d.tilt_rad * kDegPerRad))
      .arg(std::lround(d.twist_rad * kDegPerRad));
}

QString PlanPresenter::depthWords(const guidance::Target& target) const {
  return tr("cortex %1 mm below the scalp").arg(guidance::cortexDepth_mm(target), 0, 'f', 0);
}

QString PlanPresenter::describe(const guidance::Target& target) const {
  const Eigen::Vector3d& c = target.cortex_point.mm;
  const auto side = [](double mm, const QString& positive, const QString& negative) {
    return (mm >= 0 ? positive : negative) + QString::number(std::abs(std::lround(mm)));
  };
  const QString place =
      tr("%1 %2 %3")
          .arg(side(c.x(), tr("R"), tr("L")), side(c.y(), tr("A"), tr("P")), side(c.z(), tr("S"), tr("I")));
  const QString gap = tr("gap %1 mm").arg(gapWords(target));
  return QStringList{place, depthWords(target) + ", " + gap, handleWords(target), contactWords(target)}.join(
      '\n');
}

}  // namespace facenav::ui
