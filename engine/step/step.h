/// The step: contact, force, removal and guard of one tick, pure in (state, input). The same code in play, replay,
/// mirror, bench and test; the same bits on every build and CPU (engine/README.md, "Determinism").
/// Thread: the haptic loop's, or whichever owns the state. No heap, no lock, no I/O in step().
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/step/input.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

/// Events of a scene's phenomena in a tick.
enum class PhenomenonSign : std::uint8_t {
  stalled = 1 << 0,     // the bur stands still under load
  coolant = 1 << 1,     // it runs
  dry = 1 << 2,         // the bur works on tissue without coolant
  overheated = 1 << 3,  // the dry-cutting event: in this tick the rise came to the pulp's criterion (heat.h)
};

/// Result of one tick. Plain values; safe to copy between threads.
struct StepOutput {
  Vec3 device_mm{0.0};           // the input's point
  Vec3 proxy_mm{0.0};            // pivot of the admissible bur
  Vec3 axis{0.0, 0.0, 1.0};      // of the bur, from the head towards the shank
  Vec3 force_raw_n{0.0};         // eq. (1) before the guard: what metrics use
  Vec3 force_n{0.0};             // after the guard: what the device gets
  double stiffness_n_per_mm = 0; // blended over what is touched; 0 without contact
  double advance_mm = 0;         // way of the head into the tissue in this tick; a slide may lift it out again
  Tissue tissue = Tissue::empty; // touched most
  std::uint16_t bur = 0;         // in use: the wanted one once the bur is in the air and the wanted one fits there
  float spindle_rpm = 0;         // of the handpiece; 0 where the scene has none
  std::uint64_t tick = 0;        // 1 after the first step
  std::uint64_t elapsed_us = 0;  // sum of all inputs
  bool contact = false;          // proxy and device point differ
  bool cutting = false;          // cut pressed and advance_mm > 0: a slide faster than the wear leaves a scratch at most
  bool shank = false;            // the neck or shank touches
  bool faulted = false;          // guard latched; force is zero until kRearm
  bool infeasible = false;       // no pose met all constraints: those that the pose before violates gave way to it
  bool overflow = false;         // reserved room ran out; tests want zero
  bool deferred = false;         // the proxy has not converged; the next tick continues
  std::uint8_t phenomena = 0;    // PhenomenonSign bits
  std::uint16_t guard_acts = 0;  // GuardPart bits that changed the force in this tick; 0: force_n is force_raw_n, but for
                                 // drag and vibration where the scene has them
  float heat_k = 0;              // rise of the tooth's temperature; 0 where the scene has no heat

  constexpr bool has(PhenomenonSign sign) const noexcept { return (phenomena & static_cast<unsigned>(sign)) != 0; }
};

/// Fault that the guard latched. late: the tick came late; stale: no new sample for too long; not_finite: the device's
/// position or the force is not finite, or the position lies beyond 100 m.
enum class Fault : std::uint8_t { none, jump, late, gone, not_finite, stale };

class StepState {
 public:
  /// Reserves everything the scene can need. Not on the haptic thread. Pre: the scene has a specimen and a bur.
  explicit StepState(std::shared_ptr<const Scene> scene);
  ~StepState();
  StepState(StepState&&) noexcept;
  StepState& operator=(StepState&&) noexcept;

  const Scene& scene() const noexcept;
  const Volume& volume() const noexcept;
  const StepOutput& last() const noexcept;
  Fault fault() const noexcept;

  /// Volume and every number that the next step depends on (state_fields.h). Equal hashes: the same future.
  /// Reads every cut brick (0.4 us each) and stroke: not for a tick.
  std::uint64_t hash() const noexcept;

  /// All of the state, self-contained but for the scene; little-endian, versioned by kEngineVersion.
  std::vector<std::byte> save() const;
  /// nullopt when the bytes are not a state of this scene and engine version.
  static std::optional<StepState> restore(std::shared_ptr<const Scene> scene, std::span<const std::byte> bytes);

  struct Inner;
  Inner& inner() noexcept { return *inner_; }

 private:
  std::unique_ptr<Inner> inner_;
};

/// Haptic thread. One tick.
StepOutput step(StepState& state, const StepInput& input) noexcept;

}  // namespace cusp::engine
