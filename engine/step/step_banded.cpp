// One tick of the penalty and of the gradient proxy: contact, the cut pose, contact again in the cut field. Removal is
// that of the surface method, but carves every tick and has no memory of past poses.
#include "engine/contact/methods/gradient_proxy.h"
#include "engine/contact/methods/penalty.h"
#include "engine/removal/carve.h"
#include "engine/step/methods.h"
#include "engine/step/state.h"
#include "engine/step/step_fragments.h"
#include "engine/volume/fragments.h"

namespace cusp::engine {

namespace {

/// Finder: Penalty or GradientProxy.
template <class Finder>
class BandedMethod final : public ContactMethod {
 public:
  explicit BandedMethod(const StepState::Inner& state) : finder_(*state.scene, state.volume) {}

  void tick(StepState::Inner& state, const Tick& tick, StepOutput& out) noexcept override {
    const Scene& scene = *state.scene;
    const Vec3 before = state.proxy;
    BandedContact contact = finder_.solve(state.volume, scene, out.bur, state.proxy, tick.device, state.foot);
    state.proxy = contact.pose_mm;
    const bool wears = tick.cut && contact.touching && !contact.deferred;
    if (wears) {
      cut(state, contact, contact.pose_mm - before, tick, out);
      contact = finder_.solve(state.volume, scene, out.bur, state.proxy, tick.device, state.foot);
      state.proxy = contact.pose_mm;
    } else {
      state.cut_valid = false;
    }

    out.infeasible = contact.infeasible;
    out.deferred = contact.deferred;
    out.shank = contact.shank;
    out.contact = contact.touching;
    if (out.contact) press_back(state, tick, {contact.tissue, contact.stiffness_n_per_mm}, before, out);
  }

  bool end_stroke(StepState::Inner& state) noexcept override {
    state.cut_valid = false;
    return true;
  }
  bool fits(StepState::Inner& state, std::uint16_t bur, Vec3, Vec3 pose_mm, Look) noexcept override {
    return finder_.fits(state.volume, bur, pose_mm);
  }
  bool remove_voxels(StepState::Inner& state, std::span<const IVec3> voxels) noexcept override {
    return !engine::remove_voxels(state.volume, voxels).overflow;
  }
  void reload(StepState::Inner&) override {}  // reads the volume itself

 private:
  /// Eq. (4): moves the cut pose with the proxy, advances it by alpha speed dt towards the device point, and carves the
  /// sweep.
  void cut(StepState::Inner& state, const BandedContact& contact, Vec3 slid, const Tick& tick,
           StepOutput& out) noexcept {
    const Vec3 push = tick.device - contact.pose_mm;
    Pressed pressed{{contact.tissue, contact.stiffness_n_per_mm}, length_of(push)};
    if (!(pressed.push_mm > 1e-6)) return;
    if (Finder::kFollowsSideways) pressed.slid = slid - push * (glm::dot(slid, push) / (pressed.push_mm * pressed.push_mm));
    const Bur& bur = state.scene->burs[out.bur];
    pressed.tie_mm = Finder::tie_mm(bur.radius_mm, state.volume.grid().voxel_mm);
    pressed.walls = {&contact.shank_normal, contact.shank ? 1u : 0u};
    Advance advance = advance_of(state, tick, pressed, out);
    const Vec3 next = advance.end();
    if (advance.advance_mm > 0.0) {
      const bool whole = state.cut_valid && swept_whole(length_of(next - state.cut_pose), tick.dt_s);
      const Carved carved = carve_sweep(state.volume, whole ? state.cut_pose : advance.pose, next, bur, tick.axis);
      out.overflow = !drop_crumbs(state, carved) || carved.overflow || out.overflow;
      out.cutting = carved.any;
      out.advance_mm = advance.advance_mm;
    }
    state.cut_pose = next;
    state.cut_valid = true;
  }

  Finder finder_;
};

}  // namespace

std::unique_ptr<ContactMethod> make_banded_method(StepState::Inner& state) {
  if (state.scene->method == Method::penalty) return std::make_unique<BandedMethod<Penalty>>(state);
  return std::make_unique<BandedMethod<GradientProxy>>(state);
}

}  // namespace cusp::engine
