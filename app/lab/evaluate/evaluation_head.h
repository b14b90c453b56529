#pragma once
// The heads for `facenav evaluate`. Each MRI is modelled twice: by the workstation (scalp) and by the virtual
// room (its own skin), so that they do not share errors.

#include <memory>
#include <string>
#include <vector>

#include "context.h"
#include "facenav/guidance/target.h"
#include "facenav/room/virtual_patient.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::app {

struct EvaluationHead {
  std::string name;
  surface::ScalpSurface scalp;                          // the workstation's model
  std::shared_ptr<const room::VirtualPatient> patient;  // the person in the room
  guidance::Target target;
  bool is_scan_cut = false;  // the workstation's scan ends above the chin
  bool is_unseen = false;    // true unless it is the patient used in development
};

/// Makes a head. `spec`: "patient" (the virtual patient), "colin27", a NIfTI file (a labelled head is painted
/// twice, see painted_head.h) or a case folder; then, after colons, variants: "child" (0.85 of the size),
/// "big" (1.1), "wide" (1.08 wide, 0.95 high), "smooth" and "dark" (skin), "bald", "lip" and "nose" (the
/// workstation's scan ends there; the room's head is whole). Throws Error for anything else, and for "lip" or
/// "nose" if no face is found.
EvaluationHead makeEvaluationHead(Context& context, const std::string& spec);

/// Throws Error if `spec` names no head or an unknown variant; the head itself is not read.
void requireKnownHead(const std::string& spec);

/// Names of the variants, for help texts.
std::string headVariants();

}  // namespace facenav::app
