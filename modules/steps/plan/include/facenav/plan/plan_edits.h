#pragma once
// PLAN: finds the cortex point for a clicked or typed point, and edits a treatment plan by plain functions.
// The window (PlanEditor) and `facenav target` use the same ones. Points are in Mri, mm.

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/guidance/coil_plate.h"

namespace facenav::steps {

/// The surfaces that targets are placed on. `brain` is null if the case has the scalp alone.
struct PlannedHead {
  std::shared_ptr<const surface::ScalpSurface> scalp;
  std::shared_ptr<const volume::Mask> head_mask;
  std::shared_ptr<const surface::BrainModel> brain;
  guidance::CoilPlate plate = guidance::figureOfEight();  // plate that rests on the scalp: casefile::coilOf
};
/// Reads the surfaces. Throws Error as the store's readers do.
PlannedHead plannedHead(const casefile::CaseStore& store);

enum class PlanRefusal { outside_head, name_taken, no_brain, locked };
/// An edit that is refused; nothing has changed.
class PlanRefused : public Error {
 public:
  PlanRefused(PlanRefusal refusal, const std::string& what_happened, const std::string& remedy,
              double outside_mm = 0)
      : Error(what_happened, {}, remedy), refusal_(refusal), outside_mm_(outside_mm) {}
  PlanRefusal refusal() const { return refusal_; }
  double outside_mm() const { return outside_mm_; }  // for outside_head

 private:
  PlanRefusal refusal_;
  double outside_mm_;
};

/// Throws PlanRefused if `p` lies more than `limit_mm` outside the head.
void requireInHead(const PlannedHead& head, const Point<Mri>& p, double limit_mm);
/// Returns `p` itself if it lies inside the brain model or there is no model; else the nearest point of the
/// model. Throws PlanRefused if `p` lies more than surface::kFarthestOutside_mm outside the head.
Point<Mri> cortexNear(const PlannedHead& head, const Point<Mri>& p);
/// Returns the vertex of the brain model nearest to a point of the scalp. Throws PlanRefused if there is no
/// model.
Point<Mri> cortexUnder(const PlannedHead& head, const Point<Mri>& scalp_point);

/// Wanted pose of the coil at a new target.
struct CoilWish {
  double handle_rad = M_PI / 4;  // as in guidance::planTarget
  double gap_mm = 0;
};
/// Makes a target whose axis passes through a point of the cortex, its plate resting on the head.
guidance::Target targetOverCortex(const PlannedHead& head, const std::string& name,
                                  const Point<Mri>& cortex_point, const CoilWish& wish = {});
/// Makes a target whose centre lies over a point of the scalp, upright on the skin there. Its cortex point is
/// where the axis meets the brain, else the point of the axis nearest to it. Throws PlanRefused if there is
/// no brain model.
guidance::Target targetOnScalp(const PlannedHead& head, const std::string& name,
                               const Point<Mri>& scalp_point, const CoilWish& wish = {});
/// Makes a target for each point of the seed's grid except its own; named after it: "M1 r2 c3". Takes a few
/// seconds for large grids.
std::vector<guidance::Target> gridTargets(const PlannedHead& head, const guidance::Target& seed,
                                          const guidance::GridSpec& grid);
/// Returns the target on the other side of the head, with the same handle angle and gap. `mirrored` returns a
/// point of the cortex on the other side (atlas, x to -x).
guidance::Target mirroredTarget(const PlannedHead& head, const guidance::Target& target,
                                const std::function<Point<Mri>(const Point<Mri>&)>& mirrored);

/// Returns the target turned about its own z, > 0 clockwise when seen along it.
guidance::Target turned(const guidance::Target& target, double angle_rad);
/// Returns the plan with `target` in place of the one called `name`, or appended if there is none.
guidance::TreatmentPlan with(guidance::TreatmentPlan plan, const std::string& name,
                             const guidance::Target& target);
guidance::TreatmentPlan without(guidance::TreatmentPlan plan, const std::string& name);
const guidance::Target* find(const guidance::TreatmentPlan& plan, const std::string& name);
/// Returns the first of "Target 1", "Target 2", .. that no target has; `numbered` makes the name from the
/// number.
std::string freeName(const guidance::TreatmentPlan& plan, const std::function<std::string(int)>& numbered);

}  // namespace facenav::steps
