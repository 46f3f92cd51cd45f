#include "ui/drill/drill_feed.h"

#include <algorithm>
#include <utility>

namespace cusp::ui {
namespace {

constexpr std::chrono::milliseconds kSectionEvery{200};
constexpr std::chrono::milliseconds kLeadWindow{500};

/// Rises with every change of a voxel.
std::uint64_t revisions(const Volume& volume) {
  std::uint64_t out = 0;
  for (const std::int32_t brick : volume.cut_bricks()) out += volume.revision(brick);
  return out;
}

}  // namespace

DrillFeed::Clock::time_point DrillFeed::time_of(std::uint64_t elapsed_us) {
  // The mirror is late by a changing amount; the least lateness of the last half second or two stands for none. Windows,
  // because the session's clock stands still in a pause.
  const Clock::time_point now = Clock::now();
  const Clock::duration lead = now.time_since_epoch() - std::chrono::microseconds(elapsed_us);
  if (now - lead_since_ > kLeadWindow) {
    least_before_ = now - lead_since_ > 2 * kLeadWindow ? std::nullopt : least_lead_;
    least_lead_.reset();
    lead_since_ = now;
  }
  if (!least_lead_ || lead < *least_lead_) least_lead_ = lead;
  Clock::duration least = *least_lead_;
  if (least_before_) least = std::min(least, *least_before_);
  return Clock::time_point(least + std::chrono::microseconds(elapsed_us));
}

void DrillFeed::on_tick(const StepInput&, const StepState& after) {
  const Clock::time_point when = time_of(after.last().elapsed_us);
  // A cutting tick need not change a voxel, for the step carves a sweep in parts. Only ticks that changed one count.
  const std::uint64_t now = revisions(after.volume());
  const std::optional<std::uint64_t> before = std::exchange(revisions_, now);
  if (before && now != *before) changes_.push_back(when);
}

SectionImage DrillFeed::draw(const StepState& state, const SectionWish& wish, Vec3 through_mm) const {
  SectionSettings settings;
  const StepOutput& out = state.last();
  const Scene& scene = state.scene();
  settings.plane = {through_mm + wish.shift_mm, wish.right, wish.up};
  settings.width = wish.width;
  settings.height = wish.height;
  settings.mm_per_px = wish.mm_per_px;
  look_.put_into(settings);
  settings.scenery = scenery_;
  if (wish.with_bur) {
    settings.bur = scene.burs[std::min<std::size_t>(out.bur, scene.burs.size() - 1)];
    settings.pivot_mm = out.proxy_mm;
    settings.axis = out.axis;
  }
  return draw_section(state.volume(), settings);
}

void DrillFeed::on_state(const StepState& state, const StateNews& news) {
  if (!news.changed_bricks.empty() && !(news.first && state.last().tick == 0)) {
    patches_->update(state.volume(), news.changed_bricks, state.last().tick, changes_);
    section_stale_ = true;
    if (changed_) changed_();  // the tooth is drawn while its section is
  }
  changes_.clear();
  // Running behind, the section waits: the ticks come first.
  if (news.behind_ticks < 100) draw_sections(state);
}

void DrillFeed::draw_sections(const StepState& state) {
  std::optional<SectionWish> panel, lid;
  {
    const std::lock_guard lock(mutex_);
    panel = panel_wish_;
    lid = lid_wish_;
    if (std::exchange(wishes_changed_, false)) section_stale_ = true;
  }
  const Clock::time_point now = Clock::now();
  const bool moved = glm::length(state.last().proxy_mm - section_bur_) > 0.02 || state.last().bur != section_bur_number_;
  if ((panel || lid) && (section_stale_ || moved) && now - section_at_ >= kSectionEvery) {
    section_at_ = now;
    section_bur_ = state.last().proxy_mm;
    section_bur_number_ = state.last().bur;
    const Vec3 through_mm = lid_place_.follow(section_bur_);
    section_stale_ = false;
    std::optional<SectionImage> panel_image, lid_image;
    if (panel) panel_image = draw(state, *panel, section_bur_);
    if (lid) lid_image = draw(state, *lid, through_mm);
    const std::lock_guard lock(mutex_);
    if (panel_image) panel_ = std::move(panel_image);
    if (lid_image) lid_ = std::move(lid_image);
  }
}

void DrillFeed::want_sections(const std::optional<SectionWish>& panel, const std::optional<SectionWish>& lid) {
  const std::lock_guard lock(mutex_);
  panel_wish_ = panel;
  lid_wish_ = lid;
  wishes_changed_ = true;
}

std::optional<SectionImage> DrillFeed::take_panel() {
  const std::lock_guard lock(mutex_);
  return std::exchange(panel_, std::nullopt);
}

std::optional<SectionImage> DrillFeed::take_lid() {
  const std::lock_guard lock(mutex_);
  return std::exchange(lid_, std::nullopt);
}

}  // namespace cusp::ui
