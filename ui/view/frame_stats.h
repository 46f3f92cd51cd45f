/// Counts frames while cutting and how long a change of the tooth takes to be seen: from the tick that changed a voxel
/// to the end of the frame that shows it. Written as JSON to the file that CUSP_FRAME_STATS names, when a session ends.
/// Thread: GUI.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cusp::ui {

struct FrameFigures {
  std::uint64_t frames = 0;          // shown at all
  std::uint64_t changed_frames = 0;  // that showed a changed tooth
  double cutting_s = 0;              // time with changes coming in (gaps above 0.25 s left out)
  std::uint64_t cutting_frames = 0;  // shown in that time, with a change or with the moved bur alone
  double fps_while_cutting = 0;      // cutting_frames / cutting_s
  double latency_p50_ms = 0, latency_p95_ms = 0, latency_max_ms = 0;
  double draw_p50_ms = 0, draw_p95_ms = 0;  // of the view's own drawing
};

class FrameStats {
 public:
  using Clock = std::chrono::steady_clock;

  /// A frame ended at `shown`; `changes` are the moments of ticks that changed the tooth and that it is the first to
  /// show (a few of them stand for all), empty when the tooth is as before.
  void frame(Clock::time_point shown, const std::vector<Clock::time_point>& changes, double draw_ms);
  FrameFigures figures() const;
  void reset() { *this = FrameStats(); }

  std::string json() const;
  /// To the file that the environment names; nothing without it.
  void write_where_asked() const;

 private:
  std::uint64_t frames_ = 0, changed_frames_ = 0, cutting_frames_ = 0;
  std::uint64_t unchanged_ = 0;  // frames since the last change
  double cutting_s_ = 0;
  std::optional<Clock::time_point> last_cutting_;
  std::vector<float> latency_ms_, draw_ms_;  // at most kKept: later ones are left out
};

}  // namespace cusp::ui
