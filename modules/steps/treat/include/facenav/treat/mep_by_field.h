#pragma once
// TREAT: which spot of the cortex explains the muscle's MEPs, by the local field of each pulse's pose
// (stimulation/field_regression.h), where hotspot.h goes by the coil's axis. Places in Mri.

#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"
#include "facenav/plan/pose_fields.h"
#include "facenav/stimulation/field_regression.h"
#include "facenav/stimulation/response_curve.h"

namespace facenav::steps {

struct MepByField {
  int pulses = 0;       ///< with MEP and pose, and with an intensity if others have one
  int left_out = 0;     ///< with an MEP, but without one of these
  bool by_rate = true;  ///< the field was multiplied by the intensity; else no intensity is known
  stimulation::FieldRegression regression;
  std::vector<Eigen::Index>
      places;             ///< PoseFields::places_mm() that were regressed, in the regression's order
  Point<Mri> spot;        ///< the place that explains most
  double region_mm = 0;   ///< 95 % of the resampled pulses' spots lie within this of `spot`
  int region_places = 0;  ///< number of different spots that resampled pulses have
  FieldTier tier = FieldTier::local_sphere;
  /// It relates the regression's response (uV, or the logarithm to base 10) to the field at the spot.
  stimulation::ResponseCurve curve;
};

/// Maps the pulses that are not excluded. Only places are regressed that had at least 30 % of the session's
/// largest field in some pulse. Throws Error as regressOnField does.
MepByField mepByField(const PoseFields& fields, const casefile::SessionPulses& session,
                      const stimulation::FieldRegressionOptions& options = {});

/// What was found, one finding a line, for command line and window; `coil`: as efield::fieldCoil takes it.
std::vector<std::string> inWords(const MepByField& map, const std::string& coil);
/// "a sigmoid describes the MEPs better than a line: ..", or why there is none.
std::string curveWords(const MepByField& map);

/// R2 of the regression at the vertices of a surface: that of the nearest place; no number where no place was
/// regressed.
std::vector<float> r2On(const surface::TriangleMesh& surface, const PoseFields& fields,
                        const MepByField& map);

}  // namespace facenav::steps
