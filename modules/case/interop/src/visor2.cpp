#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "json_pose.h"
#include "readers.h"
#include "text.h"

// ANT visor2's .mrk: JSON, tied to one NIfTI by the numbers of its qform.

namespace facenav::interop {
namespace {

using Json = nlohmann::ordered_json;

QformNumbers imageOf(const JsonReader& info) {
  QformNumbers image;
  const auto quatern = info.at("NIfTI_quatern").numbers(3), offset = info.at("NIfTI_qoffset").numbers(3),
             pixdim = info.at("NIfTI_pixdim").numbers(4);
  for (std::size_t i = 0; i < 3; ++i) {
    image.quatern[i] = quatern[i];
    image.offset[i] = offset[i];
  }
  for (std::size_t i = 0; i < 4; ++i) image.pixdim[i] = pixdim[i];
  return image;
}

void requireWord(const JsonReader& target, const char* key, const std::string& word) {
  const std::string found = textOr(target, key, word);
  if (found != word) target.at(key).refuse("is '" + found.substr(0, 40) + "', '" + word + "' was expected");
}

Item itemOf(const JsonReader& target) {
  requireWord(target, "CoordinateSystem", "ASSOCIATED_IMAGE");
  requireWord(target, "PositionalUnit", "mm");
  requireWord(target, "CoilAxesConvention", "simnibs");
  Item item;
  item.name = textOr(target, "Name");
  item.pose = nestedPose(target.at("CoilPose").at("RigidTransformMatrix4x4"));
  if (isGiven(target, "CoilInfo")) item.values["coil"] = textOr(target.at("CoilInfo"), "Type");
  return item;
}

Json configurationOf(const Order& order) {
  const QformNumbers& image = order.t1.qform_numbers;
  return {
      {"SourceInfo", {{"AppName", order.software}, {"AppVersion", "1"}}},
      {"AssociatedImageInfo",
       {{"NIfTI_quatern", image.quatern}, {"NIfTI_qoffset", image.offset}, {"NIfTI_pixdim", image.pixdim}}}};
}

}  // namespace

bool isVisor2(const std::string& content) { return isJsonWith(content, {"TargetMarkers"}); }

OtherFile readVisor2(const Source& source) {
  const auto json = jsonOf(source, "TargetMarkers");
  OtherFile file;
  file.words = "ANT visor2 markers";
  file.space_words = "RAS";
  file.form = Form::qform;
  file.image = imageOf(json.at("Configuration").at("AssociatedImageInfo"));
  int number = 0;
  for (const auto& marker : json.at("TargetMarkers").elements()) {
    ++number;
    if (!isGiven(marker, "CoilTarget")) {
      file.notes.push_back(formatted("marker %d has no pose of a coil and is left out", number));
      continue;
    }
    file.items.push_back(itemOf(marker.at("CoilTarget")));
    file.items.back().where = formatted("marker %d", number);
  }
  return file;
}

Written writeVisor2(const Order& order) {
  if (!order.t1.qform)
    throw Error("the T1 has no qform, which ties a file of visor2 to its image", order.t1.path.string());
  const Eigen::Affine3d world = *order.t1.qform * order.t1.grid.mri_from_voxel.inverse();
  const double apart_mm = order.t1.formsApart_mm();
  Json markers = Json::array();
  for (const auto* target : targetsOf(order)) {
    const Eigen::Matrix4d pose = apart_mm > 1e-3
                                     ? Eigen::Matrix4d(world.matrix() * target->mri_T_coil->matrix())
                                     : target->mri_T_coil->matrix();
    markers.push_back({{"CoilTarget",
                        {{"Name", target->name},
                         {"CoordinateSystem", "ASSOCIATED_IMAGE"},
                         {"PositionalUnit", "mm"},
                         {"CoilAxesConvention", "simnibs"},
                         {"CoilInfo", {{"Type", order.coil}, {"Id", order.coil}}},
                         {"CoilPose", {{"RigidTransformMatrix4x4", nestedJson(pose)}}}}}});
  }
  Written written;
  written.content = jsonText({{"Configuration", configurationOf(order)}, {"TargetMarkers", markers}});
  if (apart_mm > 0.1)
    written.notes.push_back(
        formatted("sform and qform of the T1 lie up to %.1f mm apart; the file is in the qform", apart_mm));
  notePulsesLeft(order, written, "visor2's file");
  return written;
}

}  // namespace facenav::interop
