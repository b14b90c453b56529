#pragma once
// The heads that drawn worlds use: the virtual patient and the labelled heads, each prepared once. A world
// changes their shape: scan and person alike.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "context.h"
#include "facenav/room/world.h"
#include "facenav/surface/scalp_surface.h"

namespace facenav::app {

/// The person of a world and the skin of this person's scan.
struct WorldHead {
  std::string name;
  surface::ScalpSurface scalp;
  std::shared_ptr<const room::VirtualPatient> person;
  Point<Mri> target;  // 80 mm behind the bridge of the nose
};

class GateHeads {
 public:
  /// `labels`: folder of the labelled heads; empty: that of the shared data, if it is there.
  GateHeads(Context& context, std::filesystem::path labels);
  /// Makes the head of a world. `further`: another head of the list, for another person.
  WorldHead of(const room::World& world, std::size_t further = 0);
  std::size_t size() const { return specs_.size(); }

 private:
  struct Base {
    surface::ScalpSurface scalp;
    std::shared_ptr<const room::VirtualPatient> person;
    bool has_face = false;
  };
  const Base& base(std::size_t number);

  Context& context_;
  std::vector<std::string> specs_;
  std::map<std::size_t, Base> bases_;
};

}  // namespace facenav::app
