#include "facenav/treat/mep_by_field.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace facenav::steps {
namespace {

constexpr double kLeastShare = 0.3;  // a weaker field stimulates nothing where the largest is at threshold

struct Used {
  std::vector<const casefile::Pulse*> pulses;
  int left_out = 0;
  bool have_intensity = false;
};

Used usedPulses(const casefile::SessionPulses& session) {
  std::vector<const casefile::Pulse*> with_mep;
  Used used;
  for (const auto& reviewed : session.pulses) {
    if (reviewed.is_excluded || !reviewed.pulse.mep_uv) continue;
    with_mep.push_back(&reviewed.pulse);
    used.have_intensity |= reviewed.pulse.intensity_pct.has_value();
  }
  for (const auto* pulse : with_mep) {
    const bool is_usable = pulse->mri_T_coil() && (!used.have_intensity || pulse->intensity_pct);
    is_usable ? used.pulses.push_back(pulse) : void(++used.left_out);
  }
  return used;
}

/// Field of each pulse at all places, places x pulses.
Eigen::MatrixXf fieldsOf(const PoseFields& fields, const Used& used) {
  Eigen::MatrixXf all(fields.places_mm().cols(), Eigen::Index(used.pulses.size()));
  for (std::size_t i = 0; i < used.pulses.size(); ++i) {
    const auto& pulse = *used.pulses[i];
    const double output = used.have_intensity ? *pulse.intensity_pct / 100 : 1;
    all.col(Eigen::Index(i)) = float(output) * fields.at(*pulse.mri_T_coil()).strength;
  }
  return all;
}

std::vector<Eigen::Index> reachedPlaces(const Eigen::MatrixXf& field) {
  std::vector<Eigen::Index> places;
  if (field.size() == 0) return places;
  const float least = float(kLeastShare) * field.maxCoeff();
  for (Eigen::Index i = 0; i < field.rows(); ++i)
    if (field.row(i).maxCoeff() >= least) places.push_back(i);
  return places;
}

/// Fills in the spot and the region in which resampled pulses have theirs.
void locate(const Eigen::Matrix3Xd& places_mm, MepByField& map) {
  const auto placeOf = [&](Eigen::Index regressed) -> Eigen::Vector3d {
    return places_mm.col(map.places[std::size_t(regressed)]);
  };
  map.spot = Point<Mri>(placeOf(map.regression.best));
  std::vector<double> off_mm;
  std::set<Eigen::Index> different;
  for (const Eigen::Index best : map.regression.best_of_resampled) {
    off_mm.push_back((placeOf(best) - map.spot.mm).norm());
    different.insert(best);
  }
  std::sort(off_mm.begin(), off_mm.end());
  map.region_mm = off_mm[std::size_t(std::ceil(0.95 * double(off_mm.size()))) - 1];
  map.region_places = int(different.size());
}

/// Line and sigmoid at the spot, of the response that the regression chose.
stimulation::ResponseCurve curveAt(const Eigen::VectorXd& field, const std::vector<double>& mep_uv,
                                   stimulation::FieldResponse response, double noise_uv) {
  Eigen::VectorXd responses = Eigen::Map<const Eigen::VectorXd>(mep_uv.data(), Eigen::Index(mep_uv.size()));
  if (response == stimulation::FieldResponse::log) responses = responses.array().max(noise_uv).log10();
  if (!(field.maxCoeff() > field.minCoeff())) return {};
  return stimulation::fitResponse(field, responses);
}

}  // namespace

MepByField mepByField(const PoseFields& fields, const casefile::SessionPulses& session,
                      const stimulation::FieldRegressionOptions& options) {
  const Used used = usedPulses(session);
  MepByField map;
  map.pulses = int(used.pulses.size());
  map.left_out = used.left_out;
  map.by_rate = used.have_intensity;
  map.tier = fields.tier();
  std::vector<double> mep_uv;
  for (const auto* pulse : used.pulses) mep_uv.push_back(*pulse->mep_uv);
  const Eigen::MatrixXf all = fieldsOf(fields, used);
  map.places = reachedPlaces(all);
  Eigen::MatrixXf reached =
      Eigen::MatrixXf::Zero(Eigen::Index(std::max<std::size_t>(1, map.places.size())), all.cols());
  for (std::size_t i = 0; i < map.places.size(); ++i) reached.row(Eigen::Index(i)) = all.row(map.places[i]);
  map.regression = stimulation::regressOnField(reached, mep_uv, options);
  locate(fields.places_mm(), map);
  map.curve = curveAt(reached.row(map.regression.best).transpose().cast<double>(), mep_uv,
                      map.regression.response, options.noise_uv);
  return map;
}

}  // namespace facenav::steps
