/// Patches of the measures of tissue: proximal, unsupported enamel, caries, what is protected. From the measures' own walks.
/// Frame: specimen. Millimetres.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/metrics/cut_faces.h"
#include "scenarios/metrics/margin.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct EvidencePatch {
  std::vector<std::array<Vec3, 3>> triangles;  // of the surface
  std::vector<std::array<Vec3, 2>> lines;      // from place to place
  bool empty() const noexcept { return triangles.empty() && lines.empty(); }
};

/// Where a picture shows the place of a measure. The place of caries may lie within what is left, under tissue: then it is the place of
/// the patch nearest to it. Of any other measure, and without a patch, the place itself.
[[nodiscard]] Vec3 shown_place(std::string_view metric, const EvidencePatch& patch, Vec3 where_mm) noexcept;

/// contact_broken: the surface of the tooth that is left less than kOpenContactMm off the neighbour, and the border where both are
/// one body of voxels. clearance_: the line of the least clearance. unsupported_enamel: the surface of the enamel that is counted.
/// caries_left_: the bare surface of what is left; of what tissue covers wholly, the surface straight above. sound_lost: the cut surface
/// in sound tissue beyond the tolerance zone. protected_: `protected_parts.h`. pulp_exposure: where the cut went into the pulp or
/// laid it bare.
/// Any thread but the haptic one. The first question of a group takes as long as its measure, tenths of a second; others are milliseconds.
class TissuePatches {
 public:
  /// Keeps both. Pre: the volume is of the reference's specimen, and does not change.
  TissuePatches(std::shared_ptr<const Reference> reference, std::shared_ptr<const Volume> volume);
  ~TissuePatches();
  TissuePatches(const TissuePatches&) = delete;
  TissuePatches& operator=(const TissuePatches&) = delete;
  /// Whether the metric is one of these.
  [[nodiscard]] static bool has(std::string_view metric) noexcept;
  /// Empty of a measure that is not measured, or has nothing to show. `faces`, `margin`: of the volume.
  [[nodiscard]] EvidencePatch of(std::string_view metric, const CutFaces& faces, const std::vector<MarginPoint>& margin) const;

 private:
  struct Later;  // what is made when it is first asked for

  std::shared_ptr<const Reference> reference_;
  std::shared_ptr<const Volume> volume_;
  std::unique_ptr<Later> later_;
};

}  // namespace cusp::scenarios
