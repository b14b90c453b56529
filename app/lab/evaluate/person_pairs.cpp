#include "evaluate/person_pairs.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cstdio>
#include <map>
#include <opencv2/core.hpp>

#include "evaluate/camera_pictures.h"
#include "evaluate/picture_changes.h"
#include "facenav/core/error.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

constexpr double kFrame_s = 1.0 / 30.0, kGap_s = 1.5;
constexpr int kBefore = 5, kAfter = 12;
constexpr double kNoise_grey = 0.7;  // new noise in each frame: identical images would mean a frozen camera
constexpr double kBehind_mm = 80.0;
constexpr double kChiSquare95 = 7.815;  // for 3 degrees of freedom

using Frames = std::map<std::string, cameras::StereoFrame>;  // by moment

class Film {
 public:
  cameras::StereoFrame next(const cv::Mat& left, const cv::Mat& right) {
    cameras::StereoFrame frame;
    frame.left = noisy(left), frame.right = noisy(right);
    frame.number = number_++, frame.captured.s = now_s_;
    now_s_ += kFrame_s;
    return frame;
  }
  void pause() { now_s_ += kGap_s; }

 private:
  cv::Mat noisy(const cv::Mat& picture) {
    cv::Mat1f noise(picture.size());
    random_.fill(noise, cv::RNG::NORMAL, 0, kNoise_grey);
    cv::Mat1f sum;
    picture.convertTo(sum, CV_32F);
    sum += noise;
    cv::Mat grey;
    sum.convertTo(grey, CV_8U);
    return grey;
  }
  cv::RNG random_{1};
  double now_s_ = 10.0;
  std::int64_t number_ = 0;
};

void play(head_tracking::HeadTracker& tracker, const cameras::StereoRig& rig,
          const cameras::StereoFrame& reference, const cv::Mat& left, const cv::Mat& right,
          PairTrial& trial) {
  Film film;
  head_tracking::HeadReference start;
  start.frame = film.next(reference.left, reference.right);
  tracker.start(rig, start);
  for (int i = 0; i < kBefore; ++i) tracker.track(film.next(reference.left, reference.right));
  film.pause();
  for (trial.frames = 0; trial.frames < kAfter; ++trial.frames) {
    const auto pose = tracker.track(film.next(left, right));
    if (!pose) {
      trial.detail = head_tracking::toString(pose.loss_detail);
      continue;
    }
    if (!trial.found_after_s) trial.found_after_s = trial.frames * kFrame_s;
    ++trial.shown;
    trial.pose = *pose;
  }
}

Frames framesOf(const fs::path& folder, const std::string& rig) {
  const auto pictures = picturesIn(folder);
  Frames frames;
  for (const auto& moment : momentsOf(pictures, rig[0], rig[1])) {
    frames[moment].left = readGrey(pictures.at(rig.substr(0, 1) + "_" + moment));
    frames[moment].right = readGrey(pictures.at(rig.substr(1, 1) + "_" + moment));
  }
  return frames;
}

struct Motion {
  Eigen::Isometry3d motion;  // motion of the head, in the shared camera's axes
  Eigen::Matrix3d turn;      // rotation from the rig's left camera to the shared camera
  Eigen::Vector3d face_mm;   // current position of the tracked face, in the shared camera
  Matrix6d covariance;       // from the tracker, left camera's axes
};

Motion inShared(const head_tracking::HeadPose& pose, const cameras::StereoRig& rig, bool is_right_shared) {
  const Eigen::Isometry3d shared_T_left =
      is_right_shared ? rig.right_T_left.isometry() : Eigen::Isometry3d::Identity();
  return {shared_T_left * pose.camera_T_head.isometry() * shared_T_left.inverse(), shared_T_left.linear(),
          shared_T_left * pose.face_centre.mm, pose.covariance};
}

Eigen::Matrix3d covarianceAt(const Motion& motion, const Eigen::Vector3d& now_mm) {
  Eigen::Matrix<double, 3, 6> carry;
  carry << -skew(motion.turn.transpose() * (now_mm - motion.face_mm)), Eigen::Matrix3d::Identity();
  return motion.turn * carry * motion.covariance * carry.transpose() * motion.turn.transpose();
}

PairAgreement agreementOf(const Motion& a, const Motion& b) {
  const Eigen::Vector3d then_mm = b.motion.inverse() * b.face_mm + Eigen::Vector3d(0, 0, kBehind_mm);
  const Eigen::Vector3d by_a = a.motion * then_mm, by_b = b.motion * then_mm, off = by_a - by_b;
  PairAgreement agreement;
  agreement.turn_deg = rotationAngle(b.motion.linear()) * kDegPerRad;
  agreement.shift_mm = (by_b - then_mm).norm();
  agreement.off_deg = rotationAngle(a.motion.linear().transpose() * b.motion.linear()) * kDegPerRad;
  agreement.off_mm = off.norm();
  const Eigen::Matrix3d covariance = covarianceAt(a, by_a) + covarianceAt(b, by_b);
  agreement.is_inside = off.dot(solveSymmetric(covariance, off)) < kChiSquare95;
  return agreement;
}

void compareRigs(const std::map<std::string, cameras::StereoRig>& rigs, PairsResult& result) {
  for (const auto& a : result.trials)
    for (const auto& b : result.trials) {
      if (a.kind != PairTrial::Kind::same_person || b.kind != a.kind || !a.pose || !b.pose) continue;
      if (a.person != b.person || a.from != b.from || a.to != b.to || a.rig[1] != b.rig[0]) continue;
      PairAgreement agreement =
          agreementOf(inShared(*a.pose, rigs.at(a.rig), true), inShared(*b.pose, rigs.at(b.rig), false));
      agreement.person = a.person, agreement.from = a.from, agreement.to = a.to,
      agreement.rigs = a.rig + ", " + b.rig;
      result.agreements.push_back(agreement);
    }
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

struct Task {
  PairTrial trial;
  cameras::StereoFrame reference;
  cv::Mat left, right;
};

// First row of the face's lower half in an image.
int lowerFace_y(const face::FaceDetector& detector, const cv::Mat& picture) {
  const auto face = detector.detect(picture);
  if (!face) return picture.rows;
  return face->points68.size() == 68 ? int(face->points68[33].y()) : face->face.y + face->face.height / 2;
}

void addChanged(
    const cameras::StereoFrame& frame,
    const std::function<void(PairTrial::Kind, const std::string&, const cameras::StereoFrame&)>& add) {
  static const auto detector = face::makeFaceDetector();
  for (const auto& changed :
       changedPairs(frame, lowerFace_y(*detector, frame.left), lowerFace_y(*detector, frame.right)))
    add(PairTrial::Kind::changed, changed.change, changed.frame);
}

void addTasks(const std::string& name, const cameras::StereoRig& rig, const fs::path& person,
              const std::vector<fs::path>& people, std::vector<Task>& tasks) {
  using Kind = PairTrial::Kind;
  const Frames own = framesOf(person, name);
  for (const auto& [from, reference] : own) {
    const auto add = [&, from = from, reference = reference](Kind kind, const std::string& to,
                                                             const cameras::StereoFrame& frame) {
      PairTrial trial;
      trial.kind = kind, trial.rig = name, trial.person = person.filename().string(), trial.from = from,
      trial.to = to;
      tasks.push_back({trial, reference, frame.left, frame.right});
    };
    addChanged(reference, add);
    for (const auto& [to, frame] : own) {
      add(Kind::mirrored, "mirrored " + to, mirroredPair(rig, frame));
      if (to == from) continue;
      add(Kind::same_person, to, frame);
      cameras::StereoFrame two_moments = reference;
      two_moments.right = frame.right;
      add(Kind::out_of_step, from + "/" + to, two_moments);
    }
    for (const auto& somebody : people)
      if (somebody != person)
        for (const auto& [to, frame] : framesOf(somebody, name))
          add(Kind::other_person, somebody.filename().string() + " " + to, frame);
  }
}

}  // namespace

PairsResult evaluatePairs(const std::vector<fs::path>& people, const fs::path& rig_folder,
                          const std::function<std::unique_ptr<head_tracking::HeadTracker>()>& make,
                          TaskMonitor& monitor) {
  const auto rigs = rigsIn(rig_folder);
  std::vector<Task> tasks;
  for (const auto& [name, rig] : rigs)
    for (const auto& person : people) addTasks(name, rig, person, people, tasks);
  if (tasks.empty())
    throw Error("no rig finds pictures of both its cameras", rig_folder.string(),
                "name pictures <camera>_<moment>.jpg and rigs <a><b>_stereo.yml");
  PairsResult result;
  for (auto& task : tasks) {
    monitor.report("evaluate pairs", double(result.trials.size()) / double(tasks.size()));
    play(*make(), rigs.at(task.trial.rig), task.reference, task.left, task.right, task.trial);
    result.trials.push_back(std::move(task.trial));
  }
  compareRigs(rigs, result);
  return result;
}

namespace {

struct Count {
  int tried = 0, shown = 0, within = 0, named = 0;
};

Count countOf(const PairsResult& result, PairTrial::Kind kind) {
  Count count;
  for (const auto& trial : result.trials) {
    if (trial.kind != kind) continue;
    ++count.tried;
    count.shown += trial.shown > 0;
    count.within += trial.found_after_s && *trial.found_after_s <= 0.2 + 1e-9;
    count.named += trial.detail == "out_of_step" || trial.detail == "cameras_disagree" ||
                   trial.detail == "one_camera" || trial.detail == "swapped";
  }
  return count;
}

template <class... Values>
void add(std::string& text, const char* format, Values... values) {
  char line[256];
  std::snprintf(line, sizeof line, format, values...);
  text += line;
}

bool isToBeFound(PairTrial::Kind kind) {
  return kind == PairTrial::Kind::same_person || kind == PairTrial::Kind::changed;
}

void addFailures(const PairsResult& result, std::string& text) {
  for (const auto& trial : result.trials) {
    if (isToBeFound(trial.kind) == (trial.shown == 0))
      add(text, "- %s: %s, %s -> %s: %s (%d of %d frames shown)\n",
          isToBeFound(trial.kind)                      ? "not found"
          : trial.kind == PairTrial::Kind::out_of_step ? "out of step, shown"
                                                       : "another person shown",
          (trial.person + " " + trial.rig).c_str(), trial.from.c_str(), trial.to.c_str(),
          trial.detail.c_str(), trial.shown, trial.frames);
  }
}

// Adds, for each moment, how often it was found and how far two pairs of cameras differ.
void addMoments(const PairsResult& result, std::string& text) {
  struct Moment {
    int tried = 0, found = 0;
    std::vector<double> off_deg, off_mm;
  };
  std::map<std::string, Moment> moments;
  for (const auto& trial : result.trials) {
    if (trial.kind != PairTrial::Kind::same_person) continue;
    Moment& moment = moments[trial.person + " " + trial.to];
    ++moment.tried, moment.found += trial.shown > 0;
  }
  for (const auto& a : result.agreements) {
    Moment& moment = moments[a.person + " " + a.to];
    moment.off_deg.push_back(a.off_deg), moment.off_mm.push_back(a.off_mm);
  }
  text += "| back at moment | found | pairs apart, median | largest |\n|---|---|---|---|\n";
  for (const auto& [name, m] : moments)
    add(text, "| %s | %d of %d | %.2f deg, %.2f mm | %.2f deg, %.2f mm |\n", name.c_str(), m.found, m.tried,
        quantile(m.off_deg, 0.5), quantile(m.off_mm, 0.5), quantile(m.off_deg, 1.0), quantile(m.off_mm, 1.0));
  text += "\n";
}

}  // namespace

std::string pairsTable(const PairsResult& result) {
  const Count same = countOf(result, PairTrial::Kind::same_person),
              changed = countOf(result, PairTrial::Kind::changed),
              mirrored = countOf(result, PairTrial::Kind::mirrored),
              other = countOf(result, PairTrial::Kind::other_person),
              step = countOf(result, PairTrial::Kind::out_of_step);
  std::vector<double> off_deg, off_mm;
  int inside = 0;
  for (const auto& a : result.agreements) {
    off_deg.push_back(a.off_deg), off_mm.push_back(a.off_mm);
    inside += a.is_inside;
  }
  std::string text = "| quantity | goal | reached |\n|---|---|---|\n";
  add(text, "| same person at another moment, after a loss: found | >= 95 %% | %d of %d |\n", same.shown,
      same.tried);
  add(text, "| within 0.2 s | | %d of %d |\n", same.within, same.tried);
  add(text,
      "| pair against pair, 80 mm behind the face: median | 0.3 deg, 0.5 mm | %.3f deg, %.3f mm (%zu) |\n",
      quantile(off_deg, 0.5), quantile(off_mm, 0.5), off_mm.size());
  add(text, "| largest | 1 deg, 2 mm | %.3f deg, %.3f mm |\n", quantile(off_deg, 1.0), quantile(off_mm, 1.0));
  add(text, "| inside the 95 %% bound that both state | 95 %% | %d of %zu |\n", inside, off_mm.size());
  add(text, "| same moment shifted, darker, coarser, half covered: found | all | %d of %d |\n", changed.shown,
      changed.tried);
  add(text, "| another person shown | 0 | %d of %d |\n", other.shown, other.tried);
  add(text, "| the person mirrored, shown | 0 | %d of %d |\n", mirrored.shown, mirrored.tried);
  add(text, "| sides of two moments: shown | 0 | %d of %d (named in %d) |\n\n", step.shown, step.tried,
      step.named);
  addMoments(result, text);
  addFailures(result, text);
  for (const auto& a : result.agreements)
    if (!a.is_inside)
      add(text, "- outside the bound: %s, %s -> %s: %.2f deg, %.2f mm\n", (a.person + " " + a.rigs).c_str(),
          a.from.c_str(), a.to.c_str(), a.off_deg, a.off_mm);
  return text;
}

}  // namespace facenav::app
