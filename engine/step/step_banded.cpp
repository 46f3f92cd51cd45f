// One tick of the penalty and of the gradient proxy: contact, the cut pose, contact again in the cut field. Removal is
// that of the surface method, but carves every tick and has no memory of past poses.
#include "engine/contact/friction.h"
#include "engine/contact/gradient_proxy.h"
#include "engine/contact/penalty.h"
#include "engine/removal/carve.h"
#include "engine/removal/wear.h"
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
    if (!out.contact) return;
    const Vec3 spring = state.proxy - tick.device;
    out.tissue = contact.tissue;
    out.stiffness_n_per_mm = contact.stiffness_n_per_mm;
    out.force_raw_n = contact.stiffness_n_per_mm * spring;
    if (scene.friction && tick.dt_s > 0.0)
      out.force_raw_n += coulomb_n((state.proxy - before) / tick.dt_s, scene.friction_coefficient,
                                   contact.stiffness_n_per_mm * length_of(spring));
  }

  bool end_stroke(StepState::Inner& state) noexcept override {
    state.cut_valid = false;
    return true;
  }
  bool fits(StepState::Inner& state, std::uint16_t bur, Vec3, Vec3 pose_mm, Look) noexcept override {
    return finder_.fits(state.volume, bur, pose_mm);
  }
  bool cut_along(StepState::Inner& state, std::uint16_t bur, Vec3 from_mm, Vec3 to_mm) noexcept override {
    state.cut_valid = false;
    return !carve_sweep(state.volume, from_mm, to_mm, state.scene->burs[bur], state.scene->tool_axis).overflow;
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
    const Scene& scene = *state.scene;
    const Bur& bur = scene.burs[out.bur];
    const double radius = bur.radius_mm;
    const Vec3 push = tick.device - contact.pose_mm;
    const double distance = length_of(push);
    if (!(distance > 1e-6)) return;
    slid = Finder::kFollowsSideways ? slid - push * (glm::dot(slid, push) / (distance * distance)) : Vec3(0.0);
    Vec3 pose = state.cut_valid ? state.cut_pose + slid : contact.pose_mm;
    const Vec3 off = pose - contact.pose_mm;
    const double apart = length_of(off);
    const double tie = Finder::tie_mm(radius, state.volume.grid().voxel_mm);
    if (apart > tie) pose = contact.pose_mm + off * (tie / apart);

    const HeadPush head = push_of_head(tick.device - pose, {&contact.shank_normal, contact.shank ? 1u : 0u});
    const double alpha = wear_coefficient(distance * head.share, contact.stiffness_n_per_mm, scene.full_force_n);
    const double own = scene.tissues[index_of(contact.tissue)].speed_mm_s;
    const double speed = bur.head.ball() ? front_speed(state.volume, scene, pose, radius, head.direction, own, out.tick)
                                          : front_speed(state.volume, scene, pose, state.fronts[out.bur],
                                                        scene.tool_axis, head.direction, own, out.tick);
    double advance = alpha * speed * tick.dt_s * tick.removal_factor;
    if (advance > head.gap_mm) advance = head.gap_mm;
    const Vec3 next = pose + head.direction * advance;
    if (advance > 0.0) {
      const bool whole = state.cut_valid && swept_whole(length_of(next - state.cut_pose), tick.dt_s);
      const Carved carved = carve_sweep(state.volume, whole ? state.cut_pose : pose, next, bur, scene.tool_axis);
      out.overflow = !drop_crumbs(state, carved) || carved.overflow || out.overflow;
      out.cutting = carved.any;
      out.advance_mm = advance;
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
