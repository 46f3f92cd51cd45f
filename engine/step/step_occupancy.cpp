// One tick of the paper's method: proxy, eq. (1) to (3), eq. (4) and (5) per time.
#include <cmath>

#include "engine/removal/wear.h"
#include "engine/step/state.h"

namespace cusp {

namespace {

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

/// K_T of eq. (3) as the scene's friction coefficient reads it: the push of the mean offset (about the burr's radius)
/// is this share of the spring's, scaled by alpha, so that it vanishes with the contact.
Vec3 tool_friction(const Scene& scene, const OccupancyContact& contact, double stiffness, double alpha) noexcept {
  return contact.mean_offset_mm * (scene.friction_coefficient * stiffness * alpha);
}

}  // namespace

void step_occupancy(StepState::Inner& state, Vec3 device, bool cut, double dt_s, StepOutput& out) noexcept {
  const Scene& scene = *state.scene;
  OccupancyProxy& proxy = *state.occupancy;
  OccupancyContact contact = proxy.solve(state.volume, scene, out.burr, state.proxy, device);
  state.proxy = contact.pose_mm;
  out.deferred = contact.deferred;
  out.shank = contact.shank;
  const double distance = length_of(device - state.proxy);
  out.contact = contact.touching && distance > 1e-9;
  if (!out.contact) return;

  // K of what is touched: the mean over the voxels that would hit; the most frequent one names the tissue.
  const Specimen& specimen = state.volume.specimen();
  std::array<int, kTissueCodes> count{};
  double sum = 0.0;
  for (const IVec3& v : proxy.hit_voxels()) {
    const std::size_t t = index_of(specimen.tissue(v));
    ++count[t];
    sum += scene.tissues[t].stiffness_n_per_mm;
  }
  std::size_t most = 0;
  for (std::size_t t = 1; t < count.size(); ++t)
    if (count[t] > count[most]) most = t;
  if (contact.hits == 0) {
    // Held by the holder or round a corner: the softest tissue answers, so that nothing kicks.
    double least = 0.0;
    for (std::size_t t = 1; t < kTissueCodes; ++t) {
      const double k = scene.tissues[t].stiffness_n_per_mm;
      if (least == 0.0 || k < least) least = k;
    }
    sum = least;
  }
  const double stiffness = contact.hits > 0 ? sum / contact.hits : sum;
  out.tissue = static_cast<Tissue>(most);
  out.stiffness_n_per_mm = stiffness;
  const double alpha = wear_coefficient(distance, stiffness, scene.full_force_n);
  out.force_raw_n = stiffness * (state.proxy - device);
  if (scene.friction && contact.hits > 0) out.force_raw_n += tool_friction(scene, contact, stiffness, alpha);

  if (!cut || contact.hits == 0 || contact.shank) return;
  // Eq. (5) per time: D' = D - k_tool alpha 40 dt with D_tissue of eq. (6), as a fraction of the tissue's density.
  const double diagonal = length_of(Vec3(contact.step));
  for (std::size_t t = 1; t < kTissueCodes; ++t) {
    if (count[t] == 0) continue;
    const double speed = scene.tissues[t].speed_mm_s;
    const double quanta = 65535.0 * alpha * speed * dt_s / (state.volume.grid().voxel_mm * diagonal) + state.owed[t];
    const auto whole = static_cast<std::int64_t>(std::floor(quanta));
    state.owed[t] = quanta - static_cast<double>(whole);
    if (whole <= 0) continue;
    for (const IVec3& v : proxy.hit_voxels()) {
      if (index_of(specimen.tissue(v)) != t) continue;
      const int brick = specimen.brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
      std::uint16_t* values = state.volume.cut_for_writing(brick);
      if (values == nullptr) {
        out.overflow = true;
        continue;
      }
      std::uint16_t& s = values[brick_offset(v.x & 7, v.y & 7, v.z & 7)];
      s = s > whole ? static_cast<std::uint16_t>(s - whole) : std::uint16_t{0};
      if (s == 0) {
        proxy.occupancy().vanish(v);
        state.volume.touched(brick);
      }
      out.cutting = true;
    }
  }
  if (out.cutting) out.advance_mm = alpha * scene.tissues[most].speed_mm_s * dt_s;
}

}  // namespace cusp
