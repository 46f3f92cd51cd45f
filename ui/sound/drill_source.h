/// The drilling sound as the device that Qt Multimedia reads: 16 bits, the same in each channel.
/// Thread: heard() is written by the GUI's; all else belongs to the sink's.
#pragma once

#include <QIODevice>
#include <vector>

#include "engine/base/triple_buffer.h"
#include "ui/modules.h"
#include "ui/sound/drill_synth.h"

namespace cusp::ui {

/// Makes samples as they are asked for, without end.
class DrillSource : public QIODevice {
 public:
  DrillSource(double sample_rate_hz, int channels) : channels_(channels), synth_(sample_rate_hz) {
    open(ReadOnly | Unbuffered);  // a buffer of Qt's renders 16 KiB at once, 85 ms of stereo at 48 kHz
  }
  TripleBuffer<DrillHeard>& heard() { return heard_; }

  bool isSequential() const override { return true; }
  qint64 bytesAvailable() const override { return 1 << 16; }

 protected:
  qint64 readData(char* data, qint64 most) override {
    const auto frame = static_cast<qint64>(sizeof(qint16)) * channels_;
    const auto frames = static_cast<std::size_t>(most / frame);
    mono_.resize(frames);
    synth_.follow(heard_.read());
    synth_.render(mono_);
    auto* out = reinterpret_cast<qint16*>(data);
    for (const float sample : mono_)
      for (int c = 0; c < channels_; ++c) *out++ = static_cast<qint16>(sample * 32767.0f);
    return static_cast<qint64>(frames) * frame;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  int channels_;
  DrillSynth synth_;
  TripleBuffer<DrillHeard> heard_;
  std::vector<float> mono_;
};

}  // namespace cusp::ui
