/// What part of the tooth a measure is about: the patch or line that report and paper paint, beside the one place of `evidence.h`.
/// Frame: specimen. Millimetres.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/metrics/cut_faces.h"
#include "scenarios/metrics/margin.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/metrics/tissue_patch.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Patches of one volume's measures. Any thread but the haptic one: tenths of a second to make, tens of milliseconds to ask.
///
/// wall_angle_, convergence_: the walls. floor_, depth_: the pulpal floor. gingival_above_cej: the gingival floor; box_height:
/// both floors; axial_past_junction_: the axial wall. isthmus_width, ridge_: the line that is measured. cavosurface_: the margin
/// where its angle is off. overcut_: the cut surface in that zone, off those faces. surface_within_: what is further off, of
/// surface_rms, _p95, _greatest what is more than kOffMm off. target_removed, uncut_remainder: the surface of what stands in the
/// target. remaining_over_pulp: the cut surface less than kThinMm above the least. tissue_patch.h has those of contact, caries and other
/// tissue. Empty of any other, and of a measure that is not measured.
class EvidencePatches {
 public:
  /// Keeps both. Pre: the volume is of the reference's specimen, and does not change.
  EvidencePatches(std::shared_ptr<const Reference> reference, std::shared_ptr<const Volume> volume);
  [[nodiscard]] EvidencePatch of(std::string_view key) const;

  static constexpr double kOffMm = 0.1, kThinMm = 0.2;

 private:
  EvidencePatch faces_of(std::string_view metric) const;
  EvidencePatch lines_of(std::string_view metric) const;
  EvidencePatch surface_of(std::string_view metric) const;

  std::shared_ptr<const Reference> reference_;
  std::shared_ptr<const Volume> volume_;
  CutFaces faces_;
  std::vector<MarginPoint> margin_;
  std::shared_ptr<const TissuePatches> tissues_;
  std::map<std::string, EvidencePatches, std::less<>> targets_;  // by name: of several targets
};

}  // namespace cusp::scenarios
