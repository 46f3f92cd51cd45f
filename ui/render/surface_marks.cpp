#include "ui/render/surface_marks.h"

#include "scenarios/metrics/evidence_patch.h"

namespace cusp::ui {
namespace {

constexpr LineStyle kEvidenceStyle{kEvidenceLine, kEvidenceCasing, 3.0f, 0.0f, 0.0f};

}  // namespace

SurfaceMarks marks_of(const EvidencePatch& patch) {
  SurfaceMarks out;
  out.triangles.reserve(patch.triangles.size());
  for (const std::array<Vec3, 3>& t : patch.triangles) out.triangles.push_back({Vec3f(t[0]), Vec3f(t[1]), Vec3f(t[2])});
  for (const std::array<Vec3, 2>& line : patch.lines) out.lines.push_back({{Vec3f(line[0]), Vec3f(line[1])}, {}, kEvidenceStyle});
  return out;
}

}  // namespace cusp::ui
