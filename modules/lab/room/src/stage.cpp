#include "stage.h"

#include <cmath>
#include <map>

#include "facenav/stereo/dot_pattern.h"
#include "optics/wall.h"
#include "patient/face_mask.h"
#include "patient/face_shape.h"
#include "patient/glasses.h"
#include "patient/head_look.h"
#include "patient/loose_hair.h"
#include "patient/skin_mesh.h"
#include "patient/stranger.h"
#include "props/hand_mesh.h"
#include "props/marker_plate.h"

namespace facenav::room {
namespace {

/// Skin vertices within 65 mm of the face's middle that face forward, every few millimetres.
std::vector<int> spreadOverFace(const VirtualPatient& patient) {
  constexpr double kReach_mm = 65.0;
  constexpr std::size_t kTaken = 400;
  std::vector<int> near;
  for (std::size_t i = 0; i < patient.skin.vertices_mm.size(); ++i)
    if ((patient.skin.vertices_mm[i] - patient.face_middle.mm).norm() < kReach_mm &&
        patient.skin.normals[i].y() > 0.3)
      near.push_back(int(i));
  std::vector<int> spread;
  for (std::size_t i = 0; i < kTaken && !near.empty(); ++i) spread.push_back(near[i * near.size() / kTaken]);
  return spread;
}

cv::Mat patternOf(stereo::DotPattern kind) { return stereo::makeDotPattern(kind, 1); }

}  // namespace

bool Cast::operator==(const Cast& other) const {
  const auto isSame = [](const auto& a, const auto& b) {
    return a.has_value() == b.has_value() && (!a || a->matrix() == b->matrix());
  };
  return room_T_mri.matrix() == other.room_T_mri.matrix() && isSame(room_T_coil, other.room_T_coil) &&
         isSame(room_T_second, other.room_T_second) && isSame(room_T_hand, other.room_T_hand) &&
         lamp_scale == other.lamp_scale && ambient_scale == other.ambient_scale &&
         lamp_shift_mm == other.lamp_shift_mm && dots == other.dots && shown.data == other.shown.data &&
         shown_strength == other.shown_strength && lamps == other.lamps &&
         isSame(room_T_body, other.room_T_body) && wetness == other.wetness && gloss == other.gloss &&
         has_mask == other.has_mask && has_glasses == other.has_glasses && stranger == other.stranger &&
         jaw_mm == other.jaw_mm && lids == other.lids && expression == other.expression &&
         hair == other.hair && right_moved.matrix() == other.right_moved.matrix();
}

struct Stage::Implementation {
  cameras::StereoRig rig;
  RigidTransform<Camera, Room> camera_T_room;
  std::shared_ptr<const VirtualPatient> patient;
  FaceShape face;
  std::vector<int> face_vertices;  // spread over the face, to measure how much of it is visible
  struct CoilObjects {
    int body = -1, plate = -1;
  };
  RoomCoil coil;
  std::optional<RoomCoil> second;
  CoilObjects coil_objects, second_objects;
  std::array<FilmOptions, 2> films;  // left, right
  RayScene scene;
  std::vector<std::shared_ptr<const Look>> looks;
  int head = -1, hand = -1, mask = -1, glasses = -1;
  double light_taken = 1.0, defocus_px = 0.0;
  struct Locks {
    std::unique_ptr<LooseHair> hair;  // created when hair is loose for the first time
    int object = -1;                  // -1: no locks
    HairPose pose;
  };
  Locks locks;  // of the patient
  struct Stranger {
    std::shared_ptr<const VirtualPatient> person;
    std::unique_ptr<FaceShape> face;
    int object = -1;
    Locks locks;
  };
  std::map<std::uint64_t, Stranger> strangers;  // created at their first appearance
  struct Prop {
    int object = -1;
    Carrier carrier = Carrier::head;
  };
  std::vector<Prop> props;
  RoomWall wall;
  std::array<CameraRays, 2> rays;
  std::array<Renderer, 2> renderers;
  Lighting lighting;
  std::optional<Cast> shown;                 // as set
  std::array<std::optional<View>, 2> views;  // of that cast, once rendered

  Implementation(const cameras::StereoRig& r, double roll_deg, std::shared_ptr<const VirtualPatient> p,
                 const RoomWall& w)
      : rig(r),
        camera_T_room(cameraFromRoom(r, roll_deg)),
        patient(std::move(p)),
        face(*patient),
        face_vertices(spreadOverFace(*patient)),
        wall(w),
        rays{CameraRays(r.left, r.width_px, r.height_px, Eigen::Isometry3d::Identity()),
             CameraRays(r.right, r.width_px, r.height_px, r.right_T_left.isometry())},
        renderers{Renderer(rays[0], wallIn(0)), Renderer(rays[1], wallIn(1))} {}

  cv::Mat wallIn(std::size_t camera) const {
    return renderWall(rays[camera], camera_T_room.inverse().isometry(), wall);
  }

  /// Moves only a camera that moved: rendering a wall takes some tens of milliseconds.
  void moveRight(const Cast& cast) {
    const Eigen::Isometry3d right_T_world = cast.right_moved * rig.right_T_left.isometry();
    if (rays[1].camera_T_world().matrix() == right_T_world.matrix()) return;
    rays[1].moveTo(right_T_world);
    renderers[1].setBackdrop(wallIn(1));
  }

  int add(const surface::TriangleMesh& mesh, std::shared_ptr<const Look> look) {
    looks.push_back(std::move(look));
    return scene.add(mesh);
  }

  Eigen::Vector3d inCamera(const Eigen::Vector3d& p_room_mm) const {
    return camera_T_room.isometry() * p_room_mm;
  }

  void placeGlasses(const Cast& cast) {
    if (cast.has_glasses && glasses < 0) {
      const auto frame = glassesFrame(*patient);
      if (!frame.triangles.empty()) glasses = add(frame, makePlainLook(0.06f, 0.02f));
    }
    if (glasses < 0) return;
    scene.setShown(glasses, cast.has_glasses && cast.stranger == 0);
    scene.setPose(glasses, (camera_T_room * cast.room_T_mri).isometry());
  }

  FilmOptions filmOf(std::size_t camera) const {
    FilmOptions film = films[camera];
    film.exposure *= light_taken;
    film.blur_px = std::hypot(film.blur_px, defocus_px);
    return film;
  }

  void placeMask(const Cast& cast) {
    if (cast.has_mask && mask < 0) {
      const auto cloth = faceMask(*patient);
      if (!cloth.triangles.empty()) mask = add(cloth, makeClothLook());
    }
    if (mask < 0) return;
    scene.setShown(mask, cast.has_mask && cast.stranger == 0);
    scene.setPose(mask, (camera_T_room * cast.room_T_mri).isometry());
  }

  CoilObjects addCoil(const RoomCoil& one) {
    const double plate_mm = kPlatePerMarker * one.marker_size_mm;
    return {add(coilMesh(one), makePlainLook(0.16f, 0.05f)),
            add(plateMesh(plate_mm, plate_mm),
                makeMarkerLook(one.dictionary, one.marker_id, one.marker_size_mm))};
  }

  void placeCoil(const CoilObjects& objects, const RoomCoil& one,
                 const std::optional<RigidTransform<Room, Coil>>& room_T_coil) {
    scene.setShown(objects.body, room_T_coil.has_value());
    scene.setShown(objects.plate, room_T_coil.has_value());
    if (!room_T_coil) return;
    const auto camera_T_coil = camera_T_room * *room_T_coil;
    scene.setPose(objects.body, camera_T_coil.isometry());
    scene.setPose(objects.plate, (camera_T_coil * one.marker_T_coil.inverse()).isometry());
  }

  void placeProps(const Cast& cast) {
    for (const Prop& prop : props) {
      const bool is_of_head = prop.carrier == Carrier::head;
      scene.setShown(prop.object, is_of_head ? cast.stranger == 0 : cast.room_T_body.has_value());
      if (is_of_head || cast.room_T_body)
        scene.setPose(prop.object,
                      (camera_T_room * (is_of_head ? cast.room_T_mri : *cast.room_T_body)).isometry());
    }
  }

  void placeLocks(const VirtualPatient& person, std::uint64_t seed, bool is_there, const Cast& cast,
                  Locks& own) {
    const bool is_loose = cast.hair.sway_mm > 0.0;
    if (is_loose && is_there && !own.hair) {
      own.hair = std::make_unique<LooseHair>(person, seed);
      if (!own.hair->mesh().triangles.empty())
        own.object = add(own.hair->mesh(), makeLockLook(own.hair->mesh()));
    }
    if (own.object < 0) return;
    if (is_there && !(own.pose == cast.hair)) {
      const auto vertices_mm = own.hair->vertices_mm(cast.hair);
      scene.setVertices(own.object, vertices_mm, vertexNormals(vertices_mm, own.hair->mesh().triangles));
      own.pose = cast.hair;
    }
    scene.setShown(own.object, is_there && is_loose);
    scene.setPose(own.object, (camera_T_room * cast.room_T_mri).isometry());
  }

  void placeStranger(const Cast& cast) {
    if (cast.stranger != 0 && !strangers.count(cast.stranger)) {
      Stranger& one = strangers[cast.stranger];
      one.person = strangerLike(*patient, cast.stranger);
      one.face = std::make_unique<FaceShape>(*one.person);
      one.object = add(one.person->visible, makeHeadLook(*one.person, *one.face));
    }
    scene.setShown(head, cast.stranger == 0);
    for (auto& [seed, one] : strangers) {
      if (one.face->set(cast.jaw_mm, 0.0, cast.expression, cast.hair))
        scene.setVertices(one.object, one.face->vertices_mm(), one.face->normals());
      scene.setShown(one.object, seed == cast.stranger);
      scene.setPose(one.object, (camera_T_room * cast.room_T_mri).isometry());
      placeLocks(*one.person, seed + 1, seed == cast.stranger, cast, one.locks);
    }
  }

  void light(const Cast& cast) {
    lighting.wetness = cast.wetness;
    lighting.gloss = cast.gloss;
    lighting.lamps = {
        {inCamera(Eigen::Vector3d(-600, -900, -350) + cast.lamp_shift_mm), 0.55 * cast.lamp_scale, 1500.0},
        {inCamera(Eigen::Vector3d(700, -500, -500) + 0.5 * cast.lamp_shift_mm), 0.30 * cast.lamp_scale,
         1500.0}};
    if (!cast.lamps.empty()) lighting.lamps.clear();
    for (const RoomLamp& lamp : cast.lamps)
      lighting.lamps.push_back({inCamera(lamp.place_mm), lamp.intensity * cast.lamp_scale, 1500.0});
    lighting.ambient = 0.40 * cast.ambient_scale;
    lighting.up = camera_T_room.rotation() * -Eigen::Vector3d::UnitY();
    lighting.projector.reset();
    if (!cast.dots && cast.shown.empty()) return;
    const auto model = roomProjector(camera_T_room);
    DotProjector projector;
    projector.projector_T_world = model.projector_T_camera.isometry();
    projector.focal_px = model.lens.k(0, 0);
    projector.intensity *= cast.shown.empty() ? 1.0 : cast.shown_strength;
    projector.pattern = cast.shown.empty() ? patternOf(*cast.dots) : cast.shown;
    lighting.projector = projector;
    if (!cast.shown.empty()) return;
    for (auto& lamp : lighting.lamps) lamp.intensity *= 0.5;  // the room is darker while dots are projected
    lighting.ambient *= 0.5;
  }
};

Stage::Stage(const cameras::StereoRig& rig, double rig_roll_deg,
             std::shared_ptr<const VirtualPatient> patient, const RoomCoil& coil,
             const std::array<FilmOptions, 2>& films, const RoomWall& wall)
    : implementation_(std::make_unique<Implementation>(rig, rig_roll_deg, std::move(patient), wall)) {
  auto& all = *implementation_;
  all.coil = coil;
  all.films = films;
  all.head = all.add(all.patient->visible, makeHeadLook(*all.patient, all.face));
  all.coil_objects = all.addCoil(coil);
  all.hand = all.add(handMesh(), makePlainLook(0.40f, 0.02f, 0.08f));
  all.lighting.has_colour = films[0].needsColour() || films[1].needsColour();
  set(Cast{});
}

Stage::~Stage() = default;

void Stage::addProp(const surface::TriangleMesh& mesh, std::shared_ptr<const Look> look, Carrier carrier) {
  if (mesh.triangles.empty()) return;
  auto& all = *implementation_;
  all.props.push_back({all.add(mesh, std::move(look)), carrier});
  all.shown.reset();
  all.views = {};
}

void Stage::addSecondCoil(const RoomCoil& coil) {
  auto& all = *implementation_;
  all.second = coil;
  all.second_objects = all.addCoil(coil);
  all.shown.reset();
  all.views = {};
  set(Cast{});
}

void Stage::expose(const std::array<double, 2>& exposures) {
  for (std::size_t camera : {0, 1}) implementation_->films[camera].exposure = exposures[camera];
}

void Stage::set(const Cast& cast) {
  auto& all = *implementation_;
  if (all.shown && *all.shown == cast) return;
  all.shown = cast;
  all.views = {};
  all.moveRight(cast);
  if (all.face.set(cast.jaw_mm, cast.lids, cast.expression, cast.hair))
    all.scene.setVertices(all.head, all.face.vertices_mm(), all.face.normals());
  all.scene.setPose(all.head, (all.camera_T_room * cast.room_T_mri).isometry());
  all.placeMask(cast);
  all.placeGlasses(cast);
  all.placeProps(cast);
  all.placeStranger(cast);
  all.placeLocks(*all.patient, 0, cast.stranger == 0, cast, all.locks);
  all.placeCoil(all.coil_objects, all.coil, cast.room_T_coil);
  if (all.second) all.placeCoil(all.second_objects, *all.second, cast.room_T_second);
  all.scene.setShown(all.hand, cast.room_T_hand.has_value());
  if (cast.room_T_hand) all.scene.setPose(all.hand, all.camera_T_room.isometry() * *cast.room_T_hand);
  all.light(cast);
  all.lighting.backdrop =
      0.5 * (cast.lamp_scale + cast.ambient_scale) * (cast.dots && cast.shown.empty() ? 0.5 : 1.0);
  all.scene.commit();
}

const View& Stage::view(std::size_t camera) const {
  auto& all = *implementation_;
  if (!all.views[camera])
    all.views[camera] = all.renderers[camera].render(all.scene, all.looks, all.lighting);
  return *all.views[camera];
}

cv::Mat Stage::picture(std::size_t camera, std::uint64_t noise_seed, bool is_open) const {
  const auto& all = *implementation_;
  const FilmOptions film = all.filmOf(camera);
  if (is_open) return develop(view(camera).radiance, film, 2 * noise_seed + camera, view(camera).red);
  const cv::Mat dark = cv::Mat::zeros(all.rig.height_px, all.rig.width_px, CV_32F);
  return develop(dark, film, 2 * noise_seed + camera, all.lighting.has_colour ? dark : cv::Mat());
}

void Stage::adjust(double light, double defocus_px) {
  implementation_->light_taken = light, implementation_->defocus_px = defocus_px;
}

cv::Mat Stage::sweptPicture(std::size_t camera, std::uint64_t noise_seed, const Shutter& shutter,
                            const std::function<Cast(double later_s)>& at) {
  // At 100 mm/s and 20 ms of sweep a band moves by 0.05 mm against the next one, in 10 ms of exposure a
  // sample by 0.3 mm.
  constexpr int kBands = 40, kSamples = 3;
  auto& all = *implementation_;
  const int bands = shutter.rolling_s == 0.0 ? 1 : kBands, samples = shutter.exposure_s == 0.0 ? 1 : kSamples;
  cv::Mat radiance = cv::Mat::zeros(all.rig.height_px, all.rig.width_px, CV_32F), red;
  if (all.lighting.has_colour) red = radiance.clone();
  for (int band = 0; band < bands; ++band) {
    const cv::Range rows(band * all.rig.height_px / bands, (band + 1) * all.rig.height_px / bands);
    const double swept_s = ((band + 0.5) / bands - 0.5) * shutter.rolling_s;
    for (int sample = 0; sample < samples; ++sample) {
      set(at(swept_s + ((sample + 0.5) / samples - 0.5) * shutter.exposure_s));
      const View view = all.renderers[camera].render(all.scene, all.looks, all.lighting, rows);
      radiance.rowRange(rows) += view.radiance.rowRange(rows) / samples;
      if (!red.empty()) red.rowRange(rows) += view.red.rowRange(rows) / samples;
    }
  }
  return develop(radiance, all.filmOf(camera), 2 * noise_seed + camera, red);
}

cameras::StereoFrame Stage::photograph(std::int64_t number, double time_s, std::uint64_t noise_seed) const {
  cameras::StereoFrame frame;
  frame.number = number;
  frame.captured = Timestamp{time_s};
  frame.left = picture(0, noise_seed);
  frame.right = picture(1, noise_seed);
  return frame;
}

double Stage::faceVisibleFraction() const {
  const auto& all = *implementation_;
  if (all.face_vertices.empty()) return 0.0;
  const Eigen::Isometry3d& pose = all.scene.pose(all.head);
  int seen = 0;
  for (const int vertex : all.face_vertices) {
    const Eigen::Vector3d normal = pose.linear() * all.patient->skin.normals[std::size_t(vertex)];
    const Eigen::Vector3d p_mm = pose * all.face.vertices_mm()[std::size_t(vertex)] + 1.0 * normal;
    bool is_seen = true;
    for (const CameraRays& rays : all.rays)
      is_seen = is_seen && normal.dot(rays.origin_mm() - p_mm) > 0.0 && rays.shows(p_mm) &&
                !all.scene.isBlocked(p_mm, rays.origin_mm());
    seen += is_seen;
  }
  return double(seen) / double(all.face_vertices.size());
}

const RigidTransform<Camera, Room>& Stage::camera_T_room() const { return implementation_->camera_T_room; }
const RoomCoil& Stage::coil() const { return implementation_->coil; }
const std::optional<RoomCoil>& Stage::secondCoil() const { return implementation_->second; }
const cameras::StereoRig& Stage::rig() const { return implementation_->rig; }

}  // namespace facenav::room
