/// Follows a running attempt on the mirror's thread: rebuilds the mesh where the tooth changed, draws the section a few
/// times a second, and notes when voxels changed. What it makes is taken by the window's thread.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "ui/drill/section_place.h"
#include "ui/render/patch_feed.h"
#include "ui/render/section.h"
#include "ui/render/target_look.h"
#include "ui/session/observer.h"

namespace cusp::ui {

/// Which section the window wants; the panel's plane goes through the bur, SectionPlace chooses the lid's.
struct SectionWish {
  Vec3 right{0.0, -1.0, 0.0}, up{0.0, 0.0, 1.0};  // unit
  int width = 271, height = 202;
  double mm_per_px = 0.045;
  Vec3 shift_mm{0.0};   // of the picture's middle from there
  bool with_bur = true;
};

class DrillFeed : public Observer {
 public:
  /// `changed` is called on the mirror's thread when patches wait to be taken, before a section is drawn. `bounds`: of the
  /// specimen. `scenery` may be null.
  DrillFeed(std::shared_ptr<PatchFeed> patches, TargetLook look, const Box& bounds, std::function<void()> changed,
            std::shared_ptr<const SceneryLook> scenery = nullptr)
      : patches_(std::move(patches)),
        look_(std::move(look)),
        lid_place_(look_, bounds),
        changed_(std::move(changed)),
        scenery_(std::move(scenery)) {}

  void on_tick(const StepInput& input, const StepState& after) override;
  void on_state(const StepState& state, const StateNews& news) override;
  /// Sections that the window wants, also while the session stands.
  void on_idle(const StepState& state) override { draw_sections(state); }

  /// Window's thread. One section for the panel, one as the lid of the cutaway; nullopt: not wanted.
  void want_sections(const std::optional<SectionWish>& panel, const std::optional<SectionWish>& lid);
  /// Window's thread. The newest since the last taking.
  std::optional<SectionImage> take_panel();
  std::optional<SectionImage> take_lid();

 private:
  using Clock = std::chrono::steady_clock;
  /// When the tick happened in the loop: the mirror sees it later.
  Clock::time_point time_of(std::uint64_t elapsed_us);
  SectionImage draw(const StepState& state, const SectionWish& wish, Vec3 through_mm) const;
  /// At most every kSectionEvery, where a wish, the tooth or the bur changed.
  void draw_sections(const StepState& state);

  std::shared_ptr<PatchFeed> patches_;
  TargetLook look_;
  SectionPlace lid_place_;
  std::function<void()> changed_;
  std::shared_ptr<const SceneryLook> scenery_;

  // Mirror's thread only.
  TickTimes changes_;
  std::optional<std::uint64_t> revisions_;                    // of all bricks together, after the last tick
  std::optional<Clock::duration> least_lead_, least_before_;  // wall clock less session clock: this half second, the last
  Clock::time_point lead_since_{};
  Clock::time_point section_at_{};
  Vec3 section_bur_{1e9};
  std::uint16_t section_bur_number_ = 0;
  bool section_stale_ = true;

  std::mutex mutex_;  // guards what follows; held for a copy or a move
  std::optional<SectionWish> panel_wish_, lid_wish_;
  std::optional<SectionImage> panel_, lid_;
  bool wishes_changed_ = false;
};

}  // namespace cusp::ui
