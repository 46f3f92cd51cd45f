// One tick of a method on the filled reading: proxy, eq. (1) to (3), eq. (4) and (5) per time.
#include "engine/contact/methods/occupancy_proxy.h"
#include "engine/contact/methods/ray_proxy.h"
#include "engine/removal/voxel_wear.h"
#include "engine/removal/wear.h"
#include "engine/step/methods.h"
#include "engine/step/state.h"
#include "engine/step/step_fragments.h"
#include "engine/volume/fragments.h"

namespace cusp::engine {

namespace {

/// Force and wear of a proxy.
void answer(StepState::Inner& state, ToolOverlap& overlap, const VoxelContact& contact, const Tick& tick,
            StepOutput& out) noexcept {
  const Scene& scene = *state.scene;
  state.proxy = contact.pose_mm;
  out.deferred = contact.deferred;
  out.shank = contact.shank;
  const double distance = length_of(tick.device - state.proxy);
  out.contact = contact.touching && distance > 1e-9;
  if (!out.contact) return;

  // K is the mean over the hit voxels; the most frequent tissue among them is the touched one.
  const Specimen& specimen = state.volume.specimen();
  std::array<int, kTissueCodes> count{};
  double sum = 0.0;
  const std::span<const IVec3> hit = overlap.hit_voxels();
  for (const IVec3& v : hit) {
    const std::size_t t = index_of(specimen.tissue(v));
    ++count[t];
    sum += scene.tissues[t].stiffness_n_per_mm;
  }
  std::size_t most = 0;
  for (std::size_t t = 1; t < count.size(); ++t)
    if (count[t] > count[most]) most = t;
  if (hit.empty()) {
    // The holder alone touches, or the proxy is behind a corner: the softest tissue's stiffness avoids a kick.
    double least = 0.0;
    for (std::size_t t = 1; t < kTissueCodes; ++t) {
      const double k = scene.tissues[t].stiffness_n_per_mm;
      if (least == 0.0 || k < least) least = k;
    }
    sum = least;
  }
  const double stiffness = hit.empty() ? sum : sum / static_cast<double>(hit.size());
  out.tissue = static_cast<Tissue>(most);
  out.stiffness_n_per_mm = stiffness;
  const double alpha = wear_coefficient(distance, stiffness, scene.full_force_n);
  out.force_raw_n = stiffness * (state.proxy - tick.device);
  // Eq. (3) with K_T from the scene's friction coefficient. The push of the mean offset (about the bur's radius) is this
  // share of the spring's force. It is scaled by alpha, so that it vanishes with the contact.
  if (scene.friction && !hit.empty()) out.force_raw_n += contact.mean_offset_mm * (scene.friction_coefficient * stiffness * alpha);

  if (!tick.cut || hit.empty() || contact.shank) return;
  const VoxelWear worn = wear_voxels(state.volume, overlap.occupancy(), scene, hit, contact.step, alpha,
                                     tick.dt_s * tick.removal_factor, state.wear_remainder);
  out.overflow = worn.overflow || out.overflow;
  if (worn.gone) out.overflow = !drop_crumbs(state, worn.low, worn.high) || out.overflow;
  out.cutting = worn.any;
  if (worn.any) out.advance_mm = alpha * scene.tissues[most].speed_mm_s * tick.dt_s * tick.removal_factor;
}

/// Finder: OccupancyProxy or RayProxy.
template <class Finder>
class FilledMethod final : public ContactMethod {
 public:
  explicit FilledMethod(const StepState::Inner& state) : finder_(*state.scene, state.volume) {}

  void tick(StepState::Inner& state, const Tick& tick, StepOutput& out) noexcept override {
    const Grid& grid = state.volume.grid();
    ToolOverlap& overlap = finder_.overlap();
    overlap.forget_hits();
    VoxelContact contact;
    contact.pose_mm = tick.device;
    if (!overlap.apart(grid, *state.scene, out.bur, state.proxy, tick.device)) contact = finder_.solve(grid, out.bur, state.proxy, tick.device);
    if (contact.touching) overlap.hit_further(grid, out.bur, tick.device, contact);
    answer(state, overlap, contact, tick, out);
  }
  bool end_stroke(StepState::Inner&) noexcept override { return true; }
  bool fits(StepState::Inner& state, std::uint16_t bur, Vec3, Vec3 pose_mm, Look) noexcept override {
    return finder_.overlap().free(bur, ToolOverlap::voxel_at(state.volume.grid(), pose_mm));
  }
  bool remove_voxels(StepState::Inner& state, std::span<const IVec3> voxels) noexcept override {
    return engine::remove_voxels(state.volume, finder_.overlap().occupancy(), voxels);
  }
  void reload(StepState::Inner& state) override { finder_ = Finder(*state.scene, state.volume); }

 private:
  Finder finder_;
};

}  // namespace

std::unique_ptr<ContactMethod> make_filled_method(StepState::Inner& state) {
  if (state.scene->method == Method::ray) return std::make_unique<FilledMethod<RayProxy>>(state);
  return std::make_unique<FilledMethod<OccupancyProxy>>(state);
}

}  // namespace cusp::engine
