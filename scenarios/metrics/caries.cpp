#include "scenarios/metrics/caries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scenarios/metrics/region_classifier.h"
#include "scenarios/metrics/region_shares.h"
#include "scenarios/metrics/surface_search.h"
#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

/// Rms distance of a plane from the nearest voxel border.
constexpr double kBorderVoxels = 0.2887;  // 1 / sqrt(12)

/// The nearest voxel's cube stands out of a slanting border; mean over its slants.
constexpr double kCubeStandsOut = 0.35;

enum class Part : std::uint8_t { periphery, pulp_soft, pulp_firm, enamel, none };
constexpr std::size_t kParts = 4;

bool is_carious(Tissue t) noexcept {
  return t == Tissue::carious_dentine || t == Tissue::carious_enamel || t == kFirmCariousDentine;
}
bool is_sound(Tissue t) noexcept { return t == Tissue::enamel || t == Tissue::dentine || t == Tissue::cementum; }

/// Which part of the lesion a voxel belongs to.
class Parts {
 public:
  explicit Parts(const Reference& reference) : specimen_(reference.specimen()), shell_(reference.shell()) {}
  Part of(IVec3 v) const noexcept {
    const Tissue t = specimen_.tissue(v);
    if (t == Tissue::carious_enamel) return Part::enamel;
    if (t != Tissue::carious_dentine && t != kFirmCariousDentine) return Part::none;
    const double within = kPeripheryMm - kCubeStandsOut * specimen_.grid().voxel_mm;
    if (!shell_.empty() && shell_.distance_mm(specimen_.grid().centre_mm(v), within) < within) return Part::periphery;
    return t == Tissue::carious_dentine ? Part::pulp_soft : Part::pulp_firm;
  }

 private:
  const Specimen& specimen_;
  const VoxelIndex& shell_;
};

/// Adds up a solid by the parts of its voxels: a piece of a cell belongs to the voxel that is nearest to its middle.
class PartSink final : public SolidSink {
 public:
  PartSink(const Specimen& specimen, const Parts& parts, double surface_sigma_mm)
      : specimen_(specimen), parts_(parts), surface_sigma_mm_(surface_sigma_mm) {}
  std::array<double, kParts> mm3{}, sigma_mm3{};

  void cell(Vec3, Vec3) override {}
  void box(Vec3 low, Vec3 high, Tissue tissue) override {
    if (!is_carious(tissue)) return;
    const Vec3 size = high - low;
    if (size.x < 0.75 * specimen_.grid().voxel_mm) return add(0.5 * (low + high), size.x * size.y * size.z);
    // A whole cell: its eight octants are of eight voxels.
    for (int i = 0; i < 8; ++i) add(low + size * (0.25 + 0.5 * Vec3(i & 1, i >> 1 & 1, i >> 2)), size.x * size.y * size.z / 8.0);
  }
  void tetrahedron(const std::array<Vec3, 4>& c, double volume, Tissue tissue) override {
    if (is_carious(tissue)) add(0.25 * (c[0] + c[1] + c[2] + c[3]), volume);
  }
  void face(const std::array<Vec3, 3>& c, double mm2, Tissue tissue) override {
    const auto part = is_carious(tissue) ? parts_.of(nearest_voxel(specimen_.grid(), (c[0] + c[1] + c[2]) / 3.0)) : Part::none;
    if (part != Part::none) sigma_mm3[static_cast<std::size_t>(part)] += surface_sigma_mm_ * mm2;
  }

 private:
  void add(Vec3 p, double volume) noexcept {
    const IVec3 v = nearest_voxel(specimen_.grid(), p);
    if (v != last_) part_ = parts_.of(v);
    last_ = v;
    if (part_ != Part::none) mm3[static_cast<std::size_t>(part_)] += volume;
  }
  const Specimen& specimen_;
  const Parts& parts_;
  double surface_sigma_mm_;
  IVec3 last_{-1};  // whose part was asked last: pieces of one voxel follow each other
  Part part_ = Part::none;
};

/// Bricks whose cells may hold carious tissue, ascending: a brick's cells read the voxels beyond its high sides.
std::vector<int> carious_bricks(const Specimen& specimen) {
  const auto holds = [&](int brick) {
    if (specimen.uniform(brick)) return is_carious(specimen.tissue_in(brick, 0));
    for (int o = 0; o < kBrickVoxels; ++o)
      if (is_carious(specimen.tissue_in(brick, o))) return true;
    return false;
  };
  const IVec3 bricks = specimen.brick_count();
  std::vector<int> out;
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    if (!holds(b)) continue;
    for (int i = 0; i < 8; ++i)
      if (const int low = specimen.brick_index(specimen.brick_at(b) - IVec3(i & 1, i >> 1 & 1, i >> 2)); low >= 0) out.push_back(low);
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Borders of what is left of each part with other tissues, its voxels and a place of it.
void add_borders(const Parts& parts, const Volume& volume, int brick, std::array<CariesPart*, kParts> out) {
  const Grid& grid = volume.grid();
  const double mm3 = kBorderVoxels * grid.voxel_mm * grid.voxel_mm * grid.voxel_mm;
  const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
  for (int o = 0; o < kBrickVoxels; ++o) {
    const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
    if (!is_carious(volume.tissue(v)) || !volume.occupied(v)) continue;
    const Part part = parts.of(v);
    CariesPart& one = *out[static_cast<std::size_t>(part)];
    one.at_mm = grid.centre_mm(v);
    one.voxels.push_back(v);
    for (int axis = 0; axis < 3; ++axis)
      for (int step = -1; step <= 1; step += 2) {
        IVec3 next = v;
        next[axis] += step;
        if (volume.occupied(next) && parts.of(next) != part) one.uncertainty_mm3 += mm3;
      }
  }
}

/// Sound tissue removed beyond the tolerance zone.
class SoundSink final : public RegionClassifier {
 public:
  explicit SoundSink(const Reference& reference) : RegionClassifier(reference.shape(), reference.leeway()), reference_(reference) {}
  SoundLost lost;
  void face(const std::array<Vec3, 3>& c, double mm2, Tissue tissue) override {
    const Vec3 middle = (c[0] + c[1] + c[2]) / 3.0;
    double d = 0;
    if (!is_sound(tissue) || wholly_in_target() || !is_beyond(place_at(middle, d))) return;
    lost.uncertainty_mm3 += reference_.surface_sigma_mm() * mm2;
    lost.cut_faces.push_back(c);
    if (d <= furthest_) return;
    furthest_ = d;
    lost.at_mm = middle;
  }

 private:
  static bool is_beyond(Place place) noexcept { return place == Place::beyond_floor || place == Place::beyond_side; }
  void solid(Place place, double volume, Tissue tissue) override {
    if (is_sound(tissue) && is_beyond(place)) lost.mm3 += volume;
  }
  const Reference& reference_;
  double furthest_ = 0;
};

}  // namespace

CariesLeft caries_left(const Reference& reference, const Volume& volume) {
  const Specimen& specimen = reference.specimen();
  CariesLeft out;
  const std::vector<int> lesion = carious_bricks(specimen);
  if (lesion.empty()) return out;
  const Parts parts(reference);
  const std::array<CariesPart*, kParts> all = {&out.periphery, &out.pulp_soft, &out.pulp_firm, &out.enamel};
  PartSink before(specimen, parts, 0.0), removed(specimen, parts, reference.surface_sigma_mm());
  for (const int brick : lesion) {
    emit_specimen(specimen, brick, before);
    emit_removed(volume, brick, removed);
    add_borders(parts, volume, brick, all);
  }
  const double voxel = volume.grid().voxel_mm;
  for (std::size_t i = 0; i < kParts; ++i) {
    all[i]->before_mm3 = before.mm3[i];
    all[i]->mm3 = std::max(0.0, before.mm3[i] - removed.mm3[i]);
    all[i]->uncertainty_mm3 += removed.sigma_mm3[i] + voxel * voxel * voxel;
  }
  return out;
}

SoundLost sound_lost(const Reference& reference, const Volume& volume) {
  SoundSink sink(reference);
  for (const int brick : bricks_to_measure(volume)) emit_removed_by_place(volume, brick, sink);
  return std::move(sink.lost);
}

void add_caries(const Reference& reference, const Volume& volume, std::vector<Measure>& out) {
  const CariesLeft left = caries_left(reference, volume);
  const auto add = [&](const char* key, const CariesPart& part) {
    if (part.before_mm3 > 0.0) out.push_back({key, true, part.mm3, part.uncertainty_mm3, "mm3", part.at_mm});
    else out.push_back(not_measured(key, "mm3"));
  };
  add("caries_left_periphery", left.periphery);
  add("caries_left_pulp", left.pulp_soft);
  add("caries_left_pulp_firm", left.pulp_firm);
  add("caries_left_enamel", left.enamel);
  if (reference.shape().empty()) {
    out.push_back(not_measured("sound_lost", "mm3"));
    return;
  }
  const SoundLost sound = sound_lost(reference, volume);
  out.push_back({"sound_lost", true, sound.mm3, sound.uncertainty_mm3, "mm3", sound.at_mm});
}

}  // namespace cusp::scenarios
