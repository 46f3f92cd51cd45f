#include "scenarios/operators/fault_cut.h"

#include <algorithm>
#include <cmath>

#include "scenarios/format/keys.h"
#include "scenarios/operators/fast_cut.h"
#include "scenarios/operators/faulty_path.h"
#include "scenarios/operators/faulty_target.h"
#include "scenarios/shapes/target.h"
#include "scenarios/shapes/tissue_shape.h"
#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

constexpr double kContactMm = 0.1;     // teeth so near to each other touch
constexpr double kOverPulpMm = 0.3;    // that over-excavation leaves
constexpr double kThickestRidgeMm = 4.0, kThinnestRidgeMm = 0.8;
constexpr double kMarchMm = 0.02;
constexpr double kUndercuttingMm = 0.4, kThinnestNeckMm = 0.05;  // radii of a round bur's head and neck
/// The loops of a lone outline leave the enamel beside it alone; poses touch it, and a touch leaves a scratch of 0.02 mm.
constexpr double kScratchMm = 0.05;

/// What the faults of one exercise are made of.
struct Exercise {
  const Scenario& scenario;
  const Specimen& specimen;
  std::shared_ptr<const Specimen> borrowed;
  TargetShape target;

  Exercise(const Scenario& of, const Specimen& its)
      : scenario(of), specimen(its), borrowed(lent(its)), target(of.target, borrowed) {}
  bool tooth() const { return scenario.specimen.generator == "tooth"; }
  bool has(const Region& leaf) const { return !TissueShape(borrowed, tissues_of(leaf)).empty(); }
  IVec3 voxel(Vec3 p) const { return IVec3(glm::floor((p - specimen.grid().origin_mm) / specimen.grid().voxel_mm + 0.5)); }
  bool own_at(Vec3 p) const {
    const IVec3 v = voxel(p);
    if (glm::any(glm::lessThan(v, IVec3(0))) || glm::any(glm::greaterThanEqual(v, specimen.grid().size))) return false;
    return specimen.s(v) >= kHalf && is_own_hard(specimen.tissue(v));
  }
};

bool is_pulpal(FaceName face) { return face == FaceName::pulpal_floor; }
bool is_outer_wall(FaceName face) { return !is_floor(face) && face != FaceName::axial_wall; }

std::optional<Region> moved(const Exercise& on, const FaceChoice& chosen, double out_mm) {
  Region out = on.scenario.target;
  return move_faces(out, chosen, out_mm) ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<Region> tilted(const Exercise& on, double deg) {
  Region out = on.scenario.target;
  return tilt_walls(out, deg) ? std::optional(std::move(out)) : std::nullopt;
}

/// Of the outlines that the target is made of, the highest: a proximal box lies deeper.
double pulpal_floor_mm(const Exercise& on) {
  double out = on.target.floor_mm();
  for (const Outline* outline : outlines_of(on.scenario.target)) out = std::max(out, outline->top_mm - outline->depth_mm);
  return out;
}

/// The walls give way from the pulpal floor up to a head's height above it.
std::optional<Region> undermined(const Exercise& on, double mm, double head_mm) {
  auto wide = moved(on, is_outer_wall, mm);
  if (!on.tooth() || !wide || !on.has(region_of(Tissue::enamel))) return std::nullopt;
  Region below, above, hollow;
  below.kind = above.kind = RegionKind::half_space;
  above.from_mm = Vec3(0.0, 0.0, pulpal_floor_mm(on));
  above.z_axis = Vec3(0.0, 0.0, -1.0);
  below.from_mm = above.from_mm + Vec3(0.0, 0.0, head_mm);
  hollow.kind = RegionKind::common;
  hollow.parts = {std::move(*wide), std::move(below), std::move(above)};
  return either(on.scenario.target, std::move(hollow));
}

/// Of the own tooth between an outline's end and the air beyond it; 0 where the target goes on.
double ridge_beyond(const Exercise& on, Vec3 end, double sign, double half_width) {
  double thick = 0.0;
  for (double off = half_width + kMarchMm; off < half_width + kThickestRidgeMm + 1.0; off += kMarchMm) {
    const Vec3 p = end + Vec3(sign * off, 0.0, 0.0);
    if (on.target.distance_mm(p) < -kMarchMm) return 0.0;
    if (!on.own_at(p)) break;
    thick += kMarchMm;
  }
  return thick;
}

void collect_slots(Region& region, std::vector<Outline*>& out) {
  if (region.kind == RegionKind::outline && region.outline.shape != "box") out.push_back(&region.outline);
  for (Region& part : region.parts) collect_slots(part, out);
}

std::optional<Region> longer(const Exercise& on, double mm) {
  if (!on.tooth()) return std::nullopt;
  Region out = on.scenario.target;
  std::vector<Outline*> slots;
  collect_slots(out, slots);
  Outline* longest = nullptr;
  Vec3 end(0.0), to(0.0);
  double least = kThickestRidgeMm;
  for (Outline* slot : slots)
    for (const double sign : {-1.0, 1.0}) {
      std::optional<Vec3> last;
      for (const auto& path : slot->paths)
        for (const Vec3& p : path)
          if (!last || sign * p.x > sign * last->x) last = p;
      if (!last) continue;
      const double ridge = ridge_beyond(on, Vec3(last->x, last->y, slot->top_mm - 0.5 * slot->depth_mm), sign, 0.5 * slot->width_mm);
      if (ridge < kThinnestRidgeMm || ridge >= least) continue;
      least = ridge;
      longest = slot;
      end = *last;
      to = end + Vec3(sign * mm, 0.0, 0.0);
    }
  if (longest == nullptr) return std::nullopt;
  longest->paths.push_back({end, to});
  return out;
}

/// Whether the target holds some of the contact with a neighbour: own tissue as near to it as teeth that touch.
bool opens_contact(const Exercise& on) {
  const Grid& grid = on.specimen.grid();
  const int reach = static_cast<int>(std::ceil(kContactMm / grid.voxel_mm - 0.5));  // from a centre to the next voxel's face
  IVec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        if (on.specimen.tissue(v) != kNeighbourEnamel || on.specimen.s(v) < kHalf) continue;
        for (int step = -reach; step <= reach; ++step) {
          const Vec3 beside = grid.centre_mm(v + IVec3(step, 0, 0));
          if (on.own_at(beside) && on.target.distance_mm(beside) < 0.0) return true;
        }
      }
  return false;
}

std::optional<Region> contact_closed(const Exercise& on, double mm) {
  const Region neighbour = region_of(kNeighbourEnamel);
  if (!on.tooth() || !on.has(neighbour) || !opens_contact(on)) return std::nullopt;
  return without(on.scenario.target, grown(neighbour, mm));
}

/// The target without its leaves of voxels; nullopt if nothing else is there.
std::optional<Region> access_of(const Region& region) {
  if (!needs_voxels(region)) return region;
  if (region.kind != RegionKind::joined) return std::nullopt;
  Region out = region;
  out.parts.clear();
  for (const Region& part : region.parts)
    if (auto kept = access_of(part)) out.parts.push_back(std::move(*kept));
  return out.parts.empty() ? std::nullopt : std::optional(std::move(out));
}

/// Whether the access takes most of the lesion: the box of caries-46 takes 96 % of it, the outline of caries-26 26 %.
bool takes_lesion(const Exercise& on, const Region& access, const TissueShape& lesion) {
  const TargetShape shape(access, on.borrowed);
  const IVec3 from = on.voxel(lesion.low()), to = on.voxel(lesion.high());
  int all = 0, taken = 0;
  IVec3 v;
  for (v.z = from.z; v.z <= to.z; ++v.z)
    for (v.y = from.y; v.y <= to.y; ++v.y)
      for (v.x = from.x; v.x <= to.x; ++v.x) {
        const Vec3 p = on.specimen.grid().centre_mm(v);
        if (!lesion.contains(p) || on.target.distance_mm(p) >= 0.0) continue;
        ++all;
        taken += shape.distance_mm(p) < 0.0;
      }
  return 2 * taken > all;
}

/// The lesion stays where it is outside a column about its middle, which is narrower than the lesion by `mm` on each side.
std::optional<Region> caries_left(const Exercise& on, double mm) {
  const Region lesion = lesion_of(on.scenario.target);
  if (!on.tooth()) return std::nullopt;
  const TissueShape shape(on.borrowed, tissues_of(lesion));
  if (shape.empty()) return std::nullopt;
  const Vec3 middle = 0.5 * (shape.low() + shape.high()), half = 0.5 * (shape.high() - shape.low());
  Region column;
  column.kind = RegionKind::cylinder;
  column.from_mm = middle - Vec3(0.0, 0.0, half.z + 1.0);
  column.to_mm = middle + Vec3(0.0, 0.0, half.z + 1.0);
  column.radius_mm = std::max(kMarchMm, std::max(half.x, half.y) - mm);
  Region rest = without(on.scenario.target, without(lesion, std::move(column)));
  if (!needs_voxels(on.scenario.target)) return rest;
  auto access = access_of(on.scenario.target);
  // An access through sound tissue is cut all the same; one that takes the lesion spares its rim.
  if (!access || takes_lesion(on, *access, shape)) return rest;
  return either(std::move(*access), std::move(rest));
}

std::optional<Region> over_excavated(const Exercise& on, double mm) {
  const Region lesion = lesion_of(on.scenario.target);
  if (!on.tooth()) return std::nullopt;
  const TissueShape shape(on.borrowed, tissues_of(lesion));
  if (shape.empty()) return std::nullopt;
  Region more = grown(lesion, mm);
  const Region pulp = region_of(Tissue::pulp);
  if (on.has(pulp)) more = without(std::move(more), grown(pulp, kOverPulpMm));
  const Region neighbour = region_of(kNeighbourEnamel);
  if (on.has(neighbour)) more = without(std::move(more), grown(neighbour, kContactMm));
  return either(on.scenario.target, std::move(more));
}

/// nullopt where the fault changes no target.
std::optional<Region> faulty_target(SizedFault fault, const Exercise& on) {
  const double amount = fault.amount();
  switch (fault.fault) {
    case SingleFault::too_deep: return moved(on, is_pulpal, amount);
    case SingleFault::too_shallow: return moved(on, is_pulpal, -amount);
    case SingleFault::too_wide: return moved(on, is_outer_wall, amount);
    case SingleFault::tilted_wall: return tilted(on, amount);
    case SingleFault::thin_ridge: return longer(on, amount);
    case SingleFault::contact_closed: return contact_closed(on, amount);
    case SingleFault::caries_left: return caries_left(on, amount);
    case SingleFault::over_excavated: return over_excavated(on, amount);
    default: return std::nullopt;
  }
}

/// A ball no wider than the bur, on a neck that lets it reach `mm` beneath an edge.
Bur undercutting(const Bur& bur, double mm) {
  Bur out;
  out.name = bur.name;
  out.radius_mm = std::min(bur.radius_mm, kUndercuttingMm);
  out.neck_radius_mm = std::max(kThinnestNeckMm, out.radius_mm - mm - kScratchMm);
  return out;
}

Plan plan_instead(Region target, const Exercise& on, const Bur& cuts, std::uint16_t bur) {
  Scenario other = on.scenario;
  other.target = std::move(target);
  other.instruments = {cuts};
  PlanErrors errors;
  if (cut_in_loops(on.scenario, on.target)) errors.clear_mm = kScratchMm;
  Plan plan = plan_target(other, on.specimen, errors);
  plan.bur = bur;
  return plan;
}

}  // namespace

std::optional<FaultCut> fault_cut(SizedFault fault, const Scenario& scenario, const Specimen& specimen, const Plan& reference) {
  const double amount = fault.amount();
  FaultCut out;
  out.passes.reserve(2);
  out.passes.push_back({reference, scenario.instruments[reference.bur]});
  auto& [plan, bur] = out.passes.front();
  switch (fault.fault) {
    case SingleFault::wrong_bur:
      bur = wider(bur, amount);
      raise(plan, bur.radius_mm - scenario.instruments[reference.bur].radius_mm);
      return out;
    case SingleFault::tremor: shake(plan, amount); return out;
    case SingleFault::dry_cutting:
      out.dry_s = amount;
      return phenomena_from_keys(scenario.phenomena).heat ? std::optional(std::move(out)) : std::nullopt;
    default: break;
  }
  const Exercise on(scenario, specimen);
  const CutTools tools{specimen, on.target, bur};
  bool made = true;
  if (fault.fault == SingleFault::rough_floor) {
    made = add_pits(plan, tools, amount);
  } else if (fault.fault == SingleFault::exposed_pulp) {
    made = add_way_into_pulp(plan, scenario, specimen, amount);
  } else if (fault.fault == SingleFault::nicked_neighbour) {
    made = on.tooth() && add_nick(plan, tools, amount);
  } else if (fault.fault == SingleFault::undermined) {
    const Bur round = undercutting(bur, amount);
    auto target = undermined(on, amount, 2.0 * round.radius_mm);
    if (!target) return std::nullopt;
    out.passes.push_back({plan_instead(std::move(*target), on, round, reference.bur), round});
    made = !out.passes.back().plan.strokes.empty();
  } else {
    auto target = faulty_target(fault, on);
    if (!target) return std::nullopt;
    plan = plan_instead(std::move(*target), on, bur, reference.bur);
    made = !plan.strokes.empty();
  }
  return made ? std::optional(std::move(out)) : std::nullopt;
}

bool cut_along(const FaultCut& fault, Volume& volume) {
  return std::ranges::all_of(fault.passes, [&](const FaultCut::Pass& pass) { return cut_along(pass.plan, pass.bur, volume); });
}

}  // namespace cusp::scenarios
