#include "engine/lab/device_model.h"

#include <cmath>

namespace cusp::engine::lab {

namespace {

/// exp(A t) of the motion of one axis: x, v, force f and its rate g, by its power series. Pre: |A| t well below 1.
using Matrix = std::array<std::array<double, 4>, 4>;

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix out{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) out[i][j] += a[i][k] * b[k][j];
  return out;
}

struct MassOnSpring {
  double mass, damping, stiffness;  // in N, mm and s
};

Matrix motion(const MassOnSpring& of, double seconds) {
  const auto [mass, damping, stiffness] = of;
  // Scaled, so that the series is short and exact for a light, well damped mass.
  constexpr int kHalvings = 6, kTerms = 14;
  const double t = seconds / (1 << kHalvings);
  Matrix a{};
  a[0][1] = t;
  a[1][0] = -stiffness / mass * t;
  a[1][1] = -damping / mass * t;
  a[1][2] = t / mass;
  a[2][3] = t;
  Matrix sum{}, term{};
  for (std::size_t i = 0; i < 4; ++i) sum[i][i] = term[i][i] = 1.0;
  for (int n = 1; n <= kTerms; ++n) {
    term = times(term, a);
    for (auto& row : term)
      for (double& e : row) e /= n;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) sum[i][j] += term[i][j];
  }
  for (int i = 0; i < kHalvings; ++i) sum = times(sum, sum);
  return sum;
}

}  // namespace

DeviceSettings falcon(const MovingMass& moving) noexcept {
  DeviceSettings out;
  out.mass_kg = moving.mass_kg;
  out.damping_ns_per_m = moving.damping_ns_per_m;
  out.friction_n = moving.friction_n;
  out.encoder_step_mm = 0.049;
  out.force_quantum_n = 16.2 / 4095.0;
  out.limit_n = 6.1;
  return out;
}

Plant::Plant(const DeviceSettings& device, const Grip& grip, Vec3 start_mm)
    : mass_kg_(device.mass_kg + (grip.holds() ? grip.mass_kg : 0.0)),
      grip_n_per_mm_(grip.stiffness_n_per_mm),
      grip_ns_per_mm_(grip.holds() ? grip.damping_ns_per_m * 1e-3 : 0.0),
      friction_n_(device.friction_n),
      weight_(device.weight_n),
      x_(start_mm),
      intended_(start_mm) {
  // kg = N s2/m = 1e-3 N s2/mm; N s/m = 1e-3 N s/mm.
  const double mass = mass_kg_ * 1e-3, damping = device.damping_ns_per_m * 1e-3 + grip_ns_per_mm_;
  for (std::size_t n = 1; n < flows_.size(); ++n) {
    const Matrix m = motion({mass, damping, grip_n_per_mm_}, static_cast<double>(n) * kSliceUs * 1e-6);
    flows_[n] = {m[0][0], m[0][1], m[0][2], m[0][3], m[1][0], m[1][1], m[1][2], m[1][3]};
  }
}

double Plant::kinetic_mj() const noexcept { return 0.5 * mass_kg_ * 1e-3 * glm::dot(v_, v_); }

void Plant::intend(Vec3 at_mm, Vec3 velocity_mm_s) noexcept {
  intended_ = at_mm;
  intended_v_ = velocity_mm_s;
}

void Plant::drive(Vec3 velocity_mm_s) noexcept {
  driven_ = true;
  v_ = velocity_mm_s;
}

void Plant::rail(Vec3 first, Vec3 second) noexcept {
  rail_a_ = first;
  rail_b_ = second;
  v_ = allowed(v_);
}

void Plant::place(Vec3 at_mm, Vec3 velocity_mm_s) noexcept {
  x_ = at_mm;
  v_ = allowed(velocity_mm_s);
  sticks_ = false;
}

void Plant::flow(const Flow& by, Vec3 force_n, Vec3 rate, double seconds) noexcept {
  // A rail blocks its directions and bears the spring's pull along them.
  const Vec3 from = x_;
  const Vec3 x = by.xx * x_ + by.xv * v_ + by.xf * force_n + by.xg * rate;
  v_ = allowed(by.vx * x_ + by.vv * v_ + by.vf * force_n + by.vg * rate);
  x_ = from + allowed(x - from);
  intended_ += intended_v_ * seconds;
}

void Plant::slice(Vec3 force_n, Vec3 rate) noexcept {
  constexpr double kSeconds = kSliceUs * 1e-6;
  const Flow& by = flows_[1];
  // The pull without friction and without the damper's force of the mass's own speed.
  const Vec3 pull = allowed(force_n - grip_n_per_mm_ * x_);
  const double stop = length_of(v_) * mass_kg_ * 1e-3 / kSeconds;
  if (stop + length_of(pull) <= friction_n_) {  // friction holds the mass, or stops it in this slice and then holds it
    friction_mj_ += kinetic_mj();
    v_ = Vec3(0.0);
    intended_ += intended_v_ * kSeconds;
    sticks_ = true;
    return;
  }
  sticks_ = false;
  const Vec3 from = x_;
  flow(by, force_n, rate, kSeconds);
  // Friction acts against the motion, at most with the force that stops it.
  const double speed = length_of(v_);
  if (speed == 0.0) return;
  const Vec3 against = -v_ / speed;
  const double force = std::min(friction_n_, speed / by.vf);
  x_ += against * (force * by.xf);
  v_ += against * (force * by.vf);
  friction_mj_ -= force * glm::dot(against, x_ - from);
}

void Plant::advance(Vec3 force_n, int slices) noexcept {
  if (driven_) {
    x_ += v_ * (slices * kSliceUs * 1e-6);
    intended_ += intended_v_ * (slices * kSliceUs * 1e-6);
    return;
  }
  // The grip's spring and damper end at the intended place, which moves evenly.
  const Vec3 rate = grip_n_per_mm_ * intended_v_;
  const Vec3 outside = force_n + weight_ + push_ + grip_ns_per_mm_ * intended_v_;
  if (friction_n_ <= 0.0) {
    flow(flows_[static_cast<std::size_t>(slices)], outside + grip_n_per_mm_ * intended_, rate,
         slices * kSliceUs * 1e-6);
    return;
  }
  for (int i = 0; i < slices; ++i) slice(outside + grip_n_per_mm_ * intended_, rate);
}

}  // namespace cusp::engine::lab
