#include "scenarios/metrics/tissue_patch.h"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <optional>

#include "scenarios/metrics/caries.h"
#include "scenarios/metrics/evidence.h"
#include "scenarios/metrics/patch_faces.h"
#include "scenarios/metrics/protected_parts.h"
#include "scenarios/metrics/proximal.h"
#include "scenarios/metrics/unsupported.h"
#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

constexpr std::string_view kCaries = "caries_left_";
/// A key, or the beginning of some that ends in '_'.
constexpr std::array<std::string_view, 7> kKeys = {"contact_broken", "clearance_", "unsupported_enamel", kCaries,
                                                   "sound_lost",     "protected_", "pulp_exposure"};

/// The faces between voxels of the tooth and of the neighbour: where they are one body, no surface lies between them.
std::vector<Triangle> joined_border(const Volume& volume, const std::vector<IVec3>& own) {
  const Grid& grid = volume.grid();
  std::vector<Triangle> out;
  for (const IVec3 v : own)
    for (int axis = 0; axis < 3; ++axis)
      for (int step = -1; step <= 1; step += 2) {
        IVec3 next = v;
        next[axis] += step;
        if (!volume.occupied(next) || !is_neighbour(volume.tissue(next))) continue;
        Vec3 u(0.0), w(0.0);
        u[(axis + 1) % 3] = w[(axis + 2) % 3] = 0.5 * grid.voxel_mm;
        const Vec3 middle = 0.5 * (grid.centre_mm(v) + grid.centre_mm(next));
        out.push_back({middle - u - w, middle + u - w, middle + u + w});
        out.push_back({middle - u - w, middle + u + w, middle - u + w});
      }
  return out;
}

EvidencePatch contact_patch(const ProximalForm& form, const Volume& volume) {
  EvidencePatch out{surface_of(volume, form.touching), {}};
  std::ranges::copy(joined_border(volume, form.touching), std::back_inserter(out.triangles));
  return out;
}

EvidencePatch clearance_patch(const ProximalForm& form, std::string_view metric) {
  constexpr std::array<std::string_view, 3> kHeights = {"_gingival", "_middle", "_occlusal"};
  const std::optional<Clearance>* one = nullptr;
  if (metric == "clearance_gingival") one = &form.gingival;
  for (std::size_t i = 0; i < kHeights.size(); ++i) {
    if (!metric.ends_with(kHeights[i])) continue;
    if (metric.starts_with("clearance_buccal_")) one = &form.buccal[i];
    if (metric.starts_with("clearance_lingual_")) one = &form.lingual[i];
  }
  EvidencePatch out;
  if (one != nullptr && *one) out.lines.push_back({(*one)->length.at_mm, (*one)->neighbour_mm});
  return out;
}

EvidencePatch caries_patch(const CariesLeft& left, const Volume& volume, std::string_view metric) {
  const CariesPart* part = nullptr;
  if (metric == "caries_left_periphery") part = &left.periphery;
  if (metric == "caries_left_pulp") part = &left.pulp_soft;
  if (metric == "caries_left_pulp_firm") part = &left.pulp_firm;
  if (metric == "caries_left_enamel") part = &left.enamel;
  if (part == nullptr) return {};
  EvidencePatch out{surface_of(volume, part->voxels), {}};
  if (out.empty()) out.triangles = surface_of(volume, top_above(volume, part->voxels));
  return out;
}

}  // namespace

Vec3 shown_place(std::string_view metric, const EvidencePatch& patch, Vec3 where_mm) noexcept {
  if (!metric.starts_with(kCaries) || patch.triangles.empty()) return where_mm;
  return middle_of(*std::ranges::min_element(patch.triangles, {}, [&](const Triangle& t) {
    const Vec3 off = middle_of(t) - where_mm;
    return glm::dot(off, off);
  }));
}

struct TissuePatches::Later {
  std::once_flag proximal_once, unsupported_once, caries_once, sum_once;
  ProximalForm proximal;
  std::optional<UnsupportedEnamel> unsupported;
  CariesLeft caries;
  RegionShares sum;
};

TissuePatches::TissuePatches(std::shared_ptr<const Reference> reference, std::shared_ptr<const Volume> volume)
    : reference_(std::move(reference)), volume_(std::move(volume)), later_(std::make_unique<Later>()) {}
TissuePatches::~TissuePatches() = default;

bool TissuePatches::has(std::string_view metric) noexcept {
  return std::ranges::any_of(kKeys, [metric](std::string_view key) { return key.ends_with('_') ? metric.starts_with(key) : metric == key; });
}

EvidencePatch TissuePatches::of(std::string_view metric, const CutFaces& faces, const std::vector<MarginPoint>& margin) const {
  Later& later = *later_;
  const bool contact = metric == "contact_broken";
  if (contact || metric.starts_with("clearance_")) {
    if (reference_->shape().empty()) return {};
    std::call_once(later.proximal_once, [&] { later.proximal = proximal_form(faces, margin, *reference_, *volume_); });
    return contact ? contact_patch(later.proximal, *volume_) : clearance_patch(later.proximal, metric);
  }
  if (metric == "unsupported_enamel") {
    std::call_once(later.unsupported_once, [&] { later.unsupported = unsupported_enamel(*reference_, *volume_); });
    return later.unsupported ? EvidencePatch{surface_of(*volume_, later.unsupported->voxels), {}} : EvidencePatch{};
  }
  if (metric.starts_with(kCaries)) {
    std::call_once(later.caries_once, [&] { later.caries = caries_left(*reference_, *volume_); });
    return caries_patch(later.caries, *volume_, metric);
  }
  if (metric == "sound_lost") return reference_->shape().empty() ? EvidencePatch{} : EvidencePatch{sound_lost(*reference_, *volume_).cut_faces, {}};
  if (metric == "pulp_exposure")
    return exposed_pulp(*reference_, *volume_) ? EvidencePatch{bare_faces(*volume_, Tissue::pulp), {}} : EvidencePatch{};
  const bool removed = metric == "protected_removed";
  if (!removed && metric != "protected_damage") return {};
  std::call_once(later.sum_once, [&] {
    for (const int brick : bricks_to_measure(*volume_)) later.sum.add(shares_of_brick(*reference_, *volume_, brick));
  });
  return {protected_faces(*reference_, *volume_, later.sum, removed ? ProtectedMeasure::removed : ProtectedMeasure::damage), {}};
}

}  // namespace cusp::scenarios
