#include "demo/demo_pictures.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "facenav/core/whole_file.h"
#include "facenav/display/navigation_display.h"
#include "facenav/evaluation/cross_section.h"
#include "facenav/pictures/camera_overlay.h"
#include "facenav/scene/png.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

constexpr int kVideoStep = 3;  // every third frame: 20 per second of a 60 fps recording

display::StatusWords statusOf(const char* what, bool is_tracked) {
  return {std::string(what) + (is_tracked ? " tracked" : " LOST"),
          is_tracked ? display::StatusLevel::good : display::StatusLevel::lost};
}

display::NavigationDisplayContent contentOf(const PictureInput& input,
                                            const session::NavigationState& state) {
  auto overlay = pictures::drawOverlay(input.rig, state, input.target);
  char timing[96];
  std::snprintf(timing, sizeof timing, "frame %ld   %.2f s   %.1f ms", long(state.frame), state.captured.s,
                state.processing_ms);
  return {input.target.name,
          std::move(overlay.left),
          std::move(overlay.right),
          state.guidance,
          statusOf("FACE", state.head.isTracked()),
          statusOf("COIL", state.coil.isTracked()),
          timing};
}

void show(scene::NavigationScene& scene, const session::NavigationState& state) {
  scene.setHeadPose(state.camera_T_mri);
  scene.setCoilPose(state.camera_T_coil);
  scene.setOnTarget(state.guidance.state == guidance::State::on_target);
  scene.setBanner(session::lossInWords(state));
}

cv::Mat toBgr(const RgbImage& image) {
  cv::Mat bgr;
  cv::cvtColor(cv::Mat(image.height_px, image.width_px, CV_8UC3, const_cast<std::uint8_t*>(image.rgb.data())),
               bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

/// Silences stderr during its lifetime: OpenCV's writer prints a harmless note about the codec's tag.
class QuietErrors {
 public:
  QuietErrors() : kept_(::dup(STDERR_FILENO)) {
    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(null, STDERR_FILENO);
    ::close(null);
  }
  ~QuietErrors() {
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  int kept_;
};

/// A video that browsers can play if this OpenCV can write one, else Motion JPEG.
class Video {
 public:
  Video(const fs::path& folder, cv::Size size) {
    const QuietErrors quiet;
    const std::vector<std::pair<const char*, int>> kinds{
        {"navigation.webm", cv::VideoWriter::fourcc('V', 'P', '8', '0')},
        {"navigation.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G')}};
    for (const auto& [name, codec] : kinds)
      if (writer_.open((folder / name).string(), codec, 20.0, size)) {
        name_ = name;
        return;
      }
  }
  void add(const RgbImage& image) {
    if (writer_.isOpened()) writer_.write(toBgr(image));
  }
  const std::string& name() const { return name_; }  // file name; empty: none could be written

 private:
  cv::VideoWriter writer_;
  std::string name_;
};

void setUp(scene::NavigationScene& scene, const PictureInput& input) {
  scene.setScalp(input.store.scalp().mesh);
  if (const auto brain = input.store.brain()) scene.setBrain(*brain);
  scene.setVolume(input.store.mri());
  scene.setSliceCentre(input.target.cortex_point);
  scene.setTargets({input.target}, input.target.name);
  scene.setView(scene::ViewPreset::target);
}

evaluation::ReportFigure drawBrain(scene::NavigationScene& scene, const fs::path& folder) {
  scene::SceneLayers layers;
  layers.scalp = layers.coil = layers.coil_axis = layers.targets = false;
  scene.setLive(false);
  scene.setLayers(layers);
  scene.setView(scene::ViewPreset::left);
  scene::writePng(scene.render(900, 700), folder / "brain.png");
  scene.setLayers({});
  scene.setView(scene::ViewPreset::target);
  scene.setLive(true);
  return {"The textured brain: phi-theta surface with the MRI's own grey values (paper, figure 8).",
          "brain.png"};
}

}  // namespace

std::vector<evaluation::ReportFigure> drawNavigation(const PictureInput& input, const fs::path& folder,
                                                     TaskMonitor& monitor) {
  scene::NavigationScene scene;
  setUp(scene, input);
  std::vector<evaluation::ReportFigure> figures;
  const auto brain = drawBrain(scene, folder);
  display::NavigationDisplay display(scene);
  Video video(folder, {1280, 720});
  const std::size_t n = input.states.size();
  const std::array<std::size_t, 3> stills{0, n / 2 / kVideoStep * kVideoStep,
                                          (n - 1) / kVideoStep * kVideoStep};
  for (std::size_t i = 0; i < n; i += kVideoStep) {
    monitor.report("drawing", double(i) / double(n));
    show(scene, *input.states[i]);
    const RgbImage image = display.render(contentOf(input, *input.states[i]));
    video.add(image);
    for (std::size_t s = 0; s < stills.size(); ++s)
      if (stills[s] == i) {
        const std::string name = "navigation_" + std::to_string(s + 1) + ".png";
        scene::writePng(image, folder / name);
        figures.push_back(
            {"Navigation display at frame " + std::to_string(input.states[i]->frame) +
                 ": brain, target and coil axis; cameras with face features and marker (paper, figure 9).",
             name});
      }
  }
  if (!video.name().empty()) figures.push_back({"The treatment, frame by frame.", video.name()});
  figures.push_back(brain);
  return figures;
}

std::vector<evaluation::ReportFigure> drawAlignment(const casefile::CaseStore& store,
                                                    const steps::AlignmentOutcome& outcome,
                                                    const fs::path& folder) {
  const auto mri = store.mri();
  const auto cloud = outcome.result.camera_T_mri.inverse() * outcome.face.cloud;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& p_mri_mm : cloud.points_mm) middle += p_mri_mm / double(cloud.size());
  std::vector<evaluation::ReportFigure> figures;
  const std::vector<std::pair<const char*, volume::Anatomical>> planes{
      {"sagittal", volume::Anatomical::sagittal},
      {"axial", volume::Anatomical::axial},
      {"coronal", volume::Anatomical::coronal}};
  for (const auto& [name, orientation] : planes) {
    const std::string file = std::string("alignment_") + name + ".png";
    const cv::Mat picture = evaluation::drawCrossSection(mri, orientation, Point<Mri>(middle), cloud, {});
    WholeFile whole(folder / file);
    cv::imwrite(whole.temporaryPath().string(), picture);
    whole.commit();
    figures.push_back({std::string("Alignment, ") + name +
                           " cross-section: the face cloud in red on the MRI (paper, figure 11).",
                       file});
  }
  return figures;
}

}  // namespace facenav::app
