/// A measure's patch as the picture draws it: striped triangles, and lines. Plain values, any thread.
#pragma once

#include <array>
#include <vector>

#include "ui/modules.h"
#include "ui/render/overlay_line.h"

namespace cusp::scenarios {
struct EvidencePatch;
}

namespace cusp::ui {

struct SurfaceMarks {
  std::vector<std::array<Vec3f, 3>> triangles;  // mm, specimen frame
  std::vector<OverlayLine> lines;
  bool empty() const noexcept { return triangles.empty() && lines.empty(); }
};

[[nodiscard]] SurfaceMarks marks_of(const EvidencePatch& patch);

}  // namespace cusp::ui
