#include "ui/drill/attempt_sound.h"

#include "scenarios/format/keys.h"
#include "ui/drill/handpiece_panel.h"
#include "ui/modules.h"
#include "ui/settings/settings.h"
#include "ui/sound/drill_sound.h"

namespace cusp::ui {

AttemptSound::AttemptSound(HandpiecePanel& panel, QObject* parent) : QObject(parent), panel_(panel), sound_(new DrillSound(this)) {
  connect(&panel_, &HandpiecePanel::volume_changed, this, [this](int percent) {
    sound_->set_volume(percent);
    if (settings_) settings_->set_volume_percent(percent);
  });
  connect(&panel_, &HandpiecePanel::muted_changed, this, [this](bool muted) {
    sound_->set_muted(muted);
    if (settings_) settings_->set_muted(muted);
  });
  connect(sound_, &DrillSound::lost, this, [this] { panel_.set_sound({}); });
}

void AttemptSound::begin(const Scenario& scenario) {
  if (!has_phenomenon(scenario.phenomena, "sound")) return;
  const int volume = settings_ ? settings_->volume_percent() : Settings::kUsualVolumePercent;
  const bool muted = settings_ && settings_->muted();
  sound_->set_volume(volume);
  sound_->set_muted(muted);
  panel_.set_sound({.available = sound_->start(), .volume_percent = volume, .muted = muted});
}

void AttemptSound::follow(const LiveView& live, const Scene& scene) {
  if (!sound_->available()) return;
  sound_->follow(live.phase == LoopPhase::running && !live.silent ? heard_of(live.output, scene) : DrillHeard{});
}

void AttemptSound::stop() { sound_->stop(); }

}  // namespace cusp::ui
