#include <pugixml.hpp>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "readers.h"
#include "text.h"
#include "xml_text.h"

// SofTaxic's .stmpx: one <fp> with six digits a point of stimulation.

namespace facenav::interop {
namespace {

constexpr const char* kPlaces[] = {"x", "y", "z"};

Item itemOf(const pugi::xml_node& outer, const pugi::xml_node& point, int number) {
  Item item;
  item.where = formatted("fp %d", number);
  item.name = outer.attribute("id").value();
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  for (int row = 0; row < 3; ++row) {
    pose(row, 3) = numberOrNan(point.attribute(kPlaces[row]).value());
    for (int column = 0; column < 3; ++column)
      pose(row, column) = numberOrNan(point.attribute(formatted("m%d%d", row, column).c_str()).value());
  }
  item.pose = toFaceNav(pose, CoilAxes::softaxic);
  if (const auto ms = valueIn(point.attribute("ts").value()); ms && *ms > 0 && *ms < 1e13) {
    item.clock_s = *ms / 1000.0;
    item.time = dateOf(*item.clock_s) + " " + timeOf(*item.clock_s);
  }
  return item;
}

}  // namespace

bool isSoftaxic(const std::string& content) { return contains(content.substr(0, 2000), "<stmp"); }

OtherFile readSoftaxic(const Source& source) {
  pugi::xml_document document;
  const auto root = rootOf(document, source);
  OtherFile file;
  file.words = "SofTaxic";
  file.space_words = "RAS";
  int number = 0;
  for (const auto& found : root.select_nodes(".//fmp")) {
    const auto outer = found.node();
    for (const auto& point : outer.children("fp")) file.items.push_back(itemOf(outer, point, ++number));
  }
  return file;
}

Written writeSoftaxic(const Order& order) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("stmp");
  auto list = document.append_child("stmp").append_child("fmpm");
  std::string dataset = order.utc.substr(0, 10) + "-" + order.utc.substr(11, 8);
  std::string digits;
  for (const char c : dataset)
    if ((c >= '0' && c <= '9') || (c == '-' && digits.size() == 8)) digits += c;
  setText(list, "dataset", digits);
  const double clock_s = clockOf(order.utc.substr(0, 10), order.utc.substr(11, 12)).value_or(0);
  int number = 0;
  for (const auto* target : targetsOf(order)) {
    auto outer = list.append_child("fmp");
    setText(outer, "global", "0");
    setText(outer, "id", target->name);
    auto point = outer.append_child("fp");
    const Eigen::Matrix4d pose = fromFaceNav(target->mri_T_coil->matrix(), CoilAxes::softaxic);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        setText(point, formatted("m%d%d", row, column).c_str(), formatted("%.6g", pose(row, column) + 0.0));
    for (int row = 0; row < 3; ++row) setText(point, kPlaces[row], formatted("%.6g", pose(row, 3) + 0.0));
    setText(point, "id", std::to_string(++number));
    setText(point, "ts", formatted("%.0f", target->clock_s.value_or(clock_s) * 1000.0));
  }
  Written written;
  written.content = xmlText(document, false, " ");
  notePulsesLeft(order, written, "SofTaxic's file");
  return written;
}

}  // namespace facenav::interop
