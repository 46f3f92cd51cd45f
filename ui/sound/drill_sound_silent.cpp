// Built where Qt Multimedia is not installed: start() is false.
#include "ui/sound/drill_sound.h"

namespace cusp::ui {

struct DrillSound::Inner {};

DrillSound::DrillSound(QObject* parent) : QObject(parent) {}
DrillSound::~DrillSound() = default;
bool DrillSound::start() { return false; }
void DrillSound::stop() {}
bool DrillSound::available() const { return false; }
void DrillSound::follow(const DrillHeard&) {}
void DrillSound::set_volume(int) {}
void DrillSound::set_muted(bool) {}

}  // namespace cusp::ui
