/// Drawing beside a measurement on its own thread: no window, 1280 x 800 with depth, 100,000 lit triangles, at most 60
/// frames a second. 2,000 vertices are uploaded for each frame. Without a graphics card the CPU draws.
#pragma once

#include <memory>

namespace cusp::bench {

class DrawingLoad {
 public:
  /// Begins at once; nullptr if no OpenGL context can be made.
  static std::unique_ptr<DrawingLoad> start();
  virtual ~DrawingLoad() = default;
  /// Mean since start().
  virtual double frames_per_s() const = 0;
};

}  // namespace cusp::bench
