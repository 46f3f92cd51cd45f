/// Caries as lesions placed on a tooth: which enamel, cementum and dentine is carious, and how soft it is.
/// Units: mm, in the frame of the tooth's table. Any thread (read only).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

class ToothShape;
struct ToothLandmarks;

struct Lesion {
  enum class Kind : std::uint8_t {
    fissure,   // from the bottom of a pit or fissure, widening to the dentine, then shallower to its end
    proximal,  // below a contact, narrowing to the dentine, then spreading along it
    root,      // a saucer below the CEJ
  };
  Kind kind = Kind::fissure;
  /// fissure: a pit or fissure of the tooth ("central", "mesiobuccal"); proximal, root: "mesial", "distal", root also
  /// "buccal", "lingual".
  std::string site = "central";
  double radius_mm = 0.8;  // fissure, proximal: about where it meets the dentine; root: on the surface. [0.2, 4]
  double depth_mm = 1.0;   // below the dentine's surface (root: below the tooth's); 0: enamel alone. [0, 5]
  double softness = 0.7;   // share of the way from its middle to its rim that is soft; the rest is firm. [0, 1]
  friend bool operator==(const Lesion&, const Lesion&) = default;
};

/// Sites of that tooth for such a lesion: pits, or sides; empty where it cannot (a front tooth has no fissure), and for a
/// number that is no tooth's.
std::vector<std::string> lesion_sites(int fdi, Lesion::Kind kind);

/// A carious lesion keeps this far from the pulp, whatever its depth [M]: exposing it is for the bur.
inline constexpr double kLesionFromPulpMm = 0.5;

/// A lesion on its tooth. It reads the tooth's fields: the tooth must outlive it.
class PlacedLesion {
 public:
  /// Nothing when the tooth has no such site.
  static std::optional<PlacedLesion> place(const Lesion& lesion, const ToothShape& shape, const ToothLandmarks& landmarks);

  /// What the sound tissue of a place becomes. outside_mm as in Body; dentine_mm: below 0 within dentine.
  Tissue carious(Tissue sound, Vec3 p, double outside_mm, double dentine_mm) const noexcept;
  Vec3 site_mm() const noexcept { return at_; }
  /// No place further from the site than this is touched.
  double reach_mm() const noexcept { return reach_; }

 private:
  PlacedLesion(const Lesion& lesion, const ToothShape& shape) : lesion_(lesion), shape_(&shape) {}
  Lesion lesion_;
  const ToothShape* shape_;
  Vec3 at_{0.0}, in_{0.0}, junction_{0.0};  // site, unit direction inwards, where that meets the dentine
  double to_junction_ = 0.0, reach_ = 0.0;
};

}  // namespace cusp::scenarios
