/// Drawing beside a measurement: a context without a window, 1280 x 800 with depth, 100,000 lit triangles of which some
/// are uploaded anew for every frame, at most sixty frames a second, on a thread of its own (and on those of the
/// driver: without a card all of it is processor time).
#pragma once

#include <memory>

namespace cusp::bench {

class DrawingLoad {
 public:
  /// Begins at once; nullptr where no context can be made.
  static std::unique_ptr<DrawingLoad> start();
  virtual ~DrawingLoad() = default;
  /// So far, over its time.
  virtual double frames_per_s() const = 0;
};

}  // namespace cusp::bench
