/// A flat cut through specimen, target and bur, as a picture: the section panel, and the lid of the cutaway.
/// Thread: the volume's owner; the image is a plain value.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/tool/bur.h"
#include "engine/volume/volume.h"
#include "ui/modules.h"
#include "ui/render/colours.h"

namespace cusp::ui {

class SceneryLook;

/// A plane with its picture's axes; right x up points to the viewer.
struct SectionPlane {
  Vec3 centre_mm{0.0};
  Vec3 right{0.0, 1.0, 0.0};  // unit
  Vec3 up{0.0, 0.0, 1.0};     // unit
  Vec3 normal() const noexcept { return glm::cross(right, up); }
  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

struct SectionImage {
  int width = 0, height = 0;
  double mm_per_px = 0.0;
  SectionPlane plane;
  std::vector<std::uint32_t> rgba;  // [y][x], top row first, 0xAABBGGRR (bytes R, G, B, A), not premultiplied
};

struct SectionSettings {
  SectionPlane plane;
  int width = 271, height = 202;
  double mm_per_px = 0.045;
  /// Signed distances to the target and to the outer side of its leeway (below 0 inside); empty: none drawn.
  std::function<double(Vec3 mm)> target;
  std::function<double(Vec3 mm)> leeway;
  std::shared_ptr<const Volume> ghost;         // another cut of the same specimen, whose walls are drawn dashed; null: none
  std::shared_ptr<const SceneryLook> scenery;  // drawn where the specimen never had tissue; null: none
  std::optional<Bur> bur;
  Vec3 pivot_mm{0.0};
  Vec3 axis{0.0, 0.0, 1.0};
  Colour edge = kTargetCasing;      // line round the tissue
  Colour metal = colour_of(0x9AA2AE);
};

/// Transparent where nothing is.
SectionImage draw_section(const Volume& volume, const SectionSettings& settings);

}  // namespace cusp::ui
