#include "ui/view/frame_stats.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <locale>
#include <sstream>

namespace cusp::ui {
namespace {

constexpr std::size_t kKept = 200'000;  // an hour of cutting
constexpr double kGapS = 0.25;          // longer without a change: the hand rested

double quantile(std::vector<float> values, double q) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return static_cast<double>(values[at]);
}

}  // namespace

void FrameStats::frame(Clock::time_point shown, const std::vector<Clock::time_point>& changes, double draw_ms) {
  ++frames_;
  if (draw_ms_.size() < kKept) draw_ms_.push_back(static_cast<float>(draw_ms));
  if (changes.empty()) {
    ++unchanged_;
    return;
  }
  ++changed_frames_;
  for (const Clock::time_point change : changes) {
    const std::chrono::duration<double, std::milli> latency = shown - change;
    if (latency_ms_.size() < kKept) latency_ms_.push_back(static_cast<float>(latency.count()));
  }
  if (last_cutting_) {
    const std::chrono::duration<double> since = shown - *last_cutting_;
    if (since.count() <= kGapS) {
      cutting_s_ += since.count();
      cutting_frames_ += unchanged_ + 1;
    }
  }
  unchanged_ = 0;
  last_cutting_ = shown;
}

FrameFigures FrameStats::figures() const {
  FrameFigures out;
  out.frames = frames_;
  out.changed_frames = changed_frames_;
  out.cutting_frames = cutting_frames_;
  out.cutting_s = cutting_s_;
  out.fps_while_cutting = cutting_s_ > 0 ? static_cast<double>(cutting_frames_) / cutting_s_ : 0;
  out.latency_p50_ms = quantile(latency_ms_, 0.5);
  out.latency_p95_ms = quantile(latency_ms_, 0.95);
  out.latency_max_ms = quantile(latency_ms_, 1.0);
  out.draw_p50_ms = quantile(draw_ms_, 0.5);
  out.draw_p95_ms = quantile(draw_ms_, 0.95);
  return out;
}

std::string FrameStats::json() const {
  const FrameFigures f = figures();
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "{\n  \"frames\": " << f.frames << ",\n  \"changed_frames\": " << f.changed_frames << ",\n  \"cutting_frames\": " << f.cutting_frames
      << ",\n  \"cutting_s\": " << f.cutting_s << ",\n  \"fps_while_cutting\": " << f.fps_while_cutting
      << ",\n  \"latency_p50_ms\": " << f.latency_p50_ms << ",\n  \"latency_p95_ms\": " << f.latency_p95_ms
      << ",\n  \"latency_max_ms\": " << f.latency_max_ms << ",\n  \"draw_p50_ms\": " << f.draw_p50_ms
      << ",\n  \"draw_p95_ms\": " << f.draw_p95_ms << "\n}\n";
  return out.str();
}

void FrameStats::write_where_asked() const {
  const char* path = std::getenv("CUSP_FRAME_STATS");
  if (path == nullptr || *path == '\0') return;
  std::ofstream(path) << json();
}

}  // namespace cusp::ui
