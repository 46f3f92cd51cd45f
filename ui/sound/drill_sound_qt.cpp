// Output through Qt Multimedia. The sink asks for samples on a thread of its own choice: what is to be heard crosses by
// a triple buffer.
#include <QAudioSink>
#include <QMediaDevices>
#include <algorithm>

#include "ui/sound/drill_sound.h"
#include "ui/sound/drill_source.h"

namespace cusp::ui {
namespace {

constexpr int kBufferMs = 100;  // a frame under software OpenGL takes 30

}  // namespace

struct DrillSound::Inner {
  std::unique_ptr<DrillSource> source;
  std::unique_ptr<QAudioSink> sink;
  int volume = 50;
  bool muted = false;

  void apply() const {
    if (sink) sink->setVolume(muted ? 0.0 : volume / 100.0);
  }
};

DrillSound::DrillSound(QObject* parent) : QObject(parent), inner_(std::make_unique<Inner>()) {}

DrillSound::~DrillSound() { stop(); }

bool DrillSound::start() {
  if (inner_->sink) return true;
  const QAudioDevice device = QMediaDevices::defaultAudioOutput();
  if (device.isNull()) return false;
  QAudioFormat format = device.preferredFormat();
  format.setSampleFormat(QAudioFormat::Int16);
  if (!format.isValid() || !device.isFormatSupported(format)) return false;
  inner_->source = std::make_unique<DrillSource>(format.sampleRate(), format.channelCount());
  inner_->sink = std::make_unique<QAudioSink>(device, format);
  inner_->sink->setBufferSize(format.bytesForDuration(kBufferMs * 1000));
  inner_->apply();
  // Queued: stop() destroys the sink, which emits this signal.
  connect(inner_->sink.get(), &QAudioSink::stateChanged, this, [this](QAudio::State state) {
    if (state != QAudio::StoppedState || !inner_->sink || inner_->sink->error() == QAudio::NoError) return;
    stop();
    Q_EMIT lost();
  }, Qt::QueuedConnection);
  inner_->sink->start(inner_->source.get());
  if (inner_->sink->error() != QAudio::NoError) stop();
  return inner_->sink != nullptr;
}

void DrillSound::stop() {
  if (inner_->sink) inner_->sink->stop();
  inner_->sink.reset();
  inner_->source.reset();
}

bool DrillSound::available() const { return inner_->sink != nullptr; }

void DrillSound::follow(const DrillHeard& heard) {
  if (inner_->source) inner_->source->heard().write(heard);
}

void DrillSound::set_volume(int percent) {
  inner_->volume = std::clamp(percent, 0, 100);
  inner_->apply();
}

void DrillSound::set_muted(bool muted) {
  inner_->muted = muted;
  inner_->apply();
}

}  // namespace cusp::ui
