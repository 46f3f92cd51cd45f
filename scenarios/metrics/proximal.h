/// A proximal box against the tooth beside it. Source: dentistry.md, group "proximal"; dental.md 2.2, row set B (class II box: 0.5 mm
/// clearance buccal, lingual and gingival).
///
/// contact_broken (1 yes, 0 no): what is left of the tooth stands kOpenContactMm or more off the neighbour, on each side where the target
/// holds some of the contact, that is of the tooth that stood nearer. The uncertainty is 1 where the least gap is known no better.
/// clearance_<buccal|lingual>_<gingival|middle|occlusal> (mm): least distance from that wall's proximal margin to the neighbour, in
/// the lowest, middle and highest third of that margin.
/// clearance_gingival (mm): least distance from the gingival floor's proximal margin to the neighbour.
/// A neighbour that was cut counts as it stood: its damage is no clearance.
/// gingival_floor_mesiodistal (mm): mean depth of the gingival floor from its proximal margin to the axial wall, over the middle half of
/// the floor's buccolingual width.
/// Needs: a grown tooth, walls by name, a banded volume; all but the last a neighbour and a target that holds the contact.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/box.h"
#include "scenarios/metrics/cut_faces.h"
#include "scenarios/metrics/margin.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Floss passes such a gap, mm [M]: the contact is open.
inline constexpr double kOpenContactMm = 0.1;

/// A wider gap is not looked for: the contact is open by far.
inline constexpr double kContactReachMm = 0.2;

enum class Height : std::uint8_t { gingival, middle, occlusal };

/// From a place of the margin to the neighbour's surface.
struct Clearance {
  MeasuredLength length;
  Vec3 neighbour_mm{0.0};  // where it ends
};

struct ProximalForm {
  std::optional<MeasuredLength> contact_gap;  // least gap between the teeth; kContactReachMm where they stand further apart
  std::vector<IVec3> touching;  // the tooth's last voxels before a gap below kOpenContactMm, on the prepared sides
  std::array<std::optional<Clearance>, 3> buccal, lingual;  // by Height
  std::optional<Clearance> gingival;
  std::optional<MeasuredLength> floor_mesiodistal;
};

[[nodiscard]] ProximalForm proximal_form(const CutFaces& faces, const std::vector<MarginPoint>& margin, const Reference& reference,
                                         const Volume& volume);

void add_proximal(const CutFaces& faces, const std::vector<MarginPoint>& margin, const Reference& reference, const Volume& volume,
                  std::vector<Measure>& out);

}  // namespace cusp::scenarios
