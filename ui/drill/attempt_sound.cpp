#include "ui/drill/attempt_sound.h"

#include <algorithm>

#include "scenarios/format/keys.h"
#include "ui/modules.h"
#include "ui/settings/settings.h"
#include "ui/sound/drill_sound.h"

namespace cusp::ui {
namespace {

// An output that never comes back, or that fails again at once, is asked for ever more rarely: the system's libraries log each failure.
constexpr std::chrono::seconds kLongestPause{60};

}  // namespace

AttemptSound::AttemptSound(HandpiecePanel& panel, QObject* parent, DrillSound* sound)
    : QObject(parent), panel_(panel), sound_(sound != nullptr ? sound : new DrillSound(this)) {
  connect(&panel_, &HandpiecePanel::volume_changed, this, [this](int percent) {
    state_.volume_percent = percent;
    sound_->set_volume(percent);
    if (settings_) settings_->set_volume_percent(percent);
  });
  connect(&panel_, &HandpiecePanel::muted_changed, this, [this](bool muted) {
    state_.muted = muted;
    sound_->set_muted(muted);
    if (settings_) settings_->set_muted(muted);
  });
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, [this] { sound_->start() ? show(true) : look_later(); });
  connect(sound_, &DrillSound::lost, this, [this] { show(false); });
}

void AttemptSound::begin(const Scenario& scenario) {
  if (!has_phenomenon(scenario.phenomena, "sound")) return;
  state_.volume_percent = settings_ ? settings_->volume_percent() : Settings::kUsualVolumePercent;
  state_.muted = settings_ && settings_->muted();
  sound_->set_volume(state_.volume_percent);
  sound_->set_muted(state_.muted);
  show(sound_->start());
}

void AttemptSound::show(bool available) {
  state_.available = available;
  panel_.set_sound(state_);
  if (!available) look_later();
}

void AttemptSound::look_later() {
  again_.start(pause_);
  pause_ = std::min(2 * pause_, kLongestPause);
}

void AttemptSound::follow(const LiveView& live, const Scene& scene) {
  if (!sound_->available()) return;
  sound_->follow(live.phase == LoopPhase::running && !live.silent ? heard_of(live.output, scene) : DrillHeard{});
}

void AttemptSound::stop() {
  again_.stop();
  sound_->stop();
}

}  // namespace cusp::ui
