#pragma once
// RETURN: the pose at which an expert held the coil in a session, as a target for the next ones: the median
// pose of the pulses, with their spread. It is in the case's frame (Mri, mm), so it is as accurate as that
// session's alignment.

#include <filesystem>
#include <optional>
#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/core/setting.h"

namespace facenav::steps {

struct ExpertRules {
  static constexpr const char* kModule = "workflow";
  static constexpr const char* kSubject = "expert's pose";

  double most_spread_mm = 3, most_spread_deg = 5;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kSpread("most_spread_mm", 0.1, 20, "mm",
                    "pulses farther from their median, in the median, are not one pose"),
            self.most_spread_mm);
    visitor(kSpread("most_spread_deg", 0.1, 45, "deg",
                    "pulses turned further against it, in the median, are not one pose"),
            self.most_spread_deg);
  }

  static constexpr Evidence kSpread{
      Origin::chosen, "about the tolerance of guidance (2 to 3 mm, 5 deg): pulses on target lie within"};
};

struct ExpertRequest {
  std::string session;       // its name or the beginning of it; empty: the newest
  std::optional<int> pulse;  // this one alone; nothing: the median over the valid pulses
  std::string from_target;   // pulses at this target; empty: the target with the most pulses on target
  std::string name;          // of the new target; empty: "expert " and the old target's name
  std::string by;            // who sets it; may be empty
};

/// Computes the median over the pulses on target that are not excluded; without a target, over all pulses
/// with a pose. Stores nothing. Throws Error: no such session or pulse, no pulse with a pose, pulses of
/// several coils, or pulses spread too far to be one pose (ExpertRules).
guidance::Target expertPose(const casefile::CaseStore& store, const ExpertRequest& request);
/// Computes the pose and stores it in the case's plan, replacing one of the same name. Throws Error also
/// where that one is locked.
guidance::Target storeExpertPose(const casefile::CaseStore& store, const ExpertRequest& request);

/// Returns "pulse 12 lay outside the tolerance: 8.2 mm, 4 deg from 'M1'" where a pulse that the pose would be
/// taken from did; else nothing. Throws Error as expertPose does.
std::optional<std::string> outsideCaution(const casefile::CaseStore& store, const ExpertRequest& request);

/// Returns "the expert held the coil 'a' there, this is 'b'"; nothing if the coil is the same, or unknown.
std::optional<std::string> otherCoilCaution(const guidance::Target& target, const std::string& coil);

/// Returns "median of 183 pulses of session 20261123T140509Z, spread 0.8 mm 0.9 deg, coil figure-8 70 mm".
std::string inWords(const guidance::ExpertPose& expert);

}  // namespace facenav::steps
