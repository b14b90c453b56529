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

/// The skin of a person's scan.
struct WorldScan {
  std::string name;  // of the head
  surface::ScalpSurface scalp;
  Point<Mri> target;  // 80 mm behind the bridge of the nose
};

/// The person of a world, and this person's scan.
struct WorldHead : WorldScan {
  std::shared_ptr<const room::VirtualPatient> person;
};

class GateHeads {
 public:
  /// `labels`: folder of the labelled heads; empty: that of the shared data, if it is there.
  GateHeads(Context& context, std::filesystem::path labels);
  /// Makes the head of a world. `further`: another head of the list, for another person.
  WorldHead of(const room::World& world, std::size_t further = 0);
  /// Makes the scan of the world's own head.
  WorldScan scanOf(const room::World& world);
  /// Makes the scans of other persons, in the world's shape. The world's seed draws whose; none has the name
  /// of the world's own head. Fewer than `count` if there are no more heads.
  std::vector<WorldScan> strangersOf(const room::World& world, std::size_t count);

 private:
  struct Base {
    surface::ScalpSurface scalp;
    std::shared_ptr<const room::VirtualPatient> person;
    bool has_face = false;
  };
  const Base& base(std::size_t number);
  std::size_t numberOf(const room::World& world, std::size_t further);
  std::string nameOf(std::size_t number) const;
  WorldScan makeScan(std::size_t number, const room::World& world);

  Context& context_;
  std::vector<std::string> specs_;
  std::map<std::size_t, Base> bases_;
};

}  // namespace facenav::app
