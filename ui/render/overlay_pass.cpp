#include "ui/render/overlay_pass.h"

#include <array>
#include <cstddef>

namespace cusp::ui {
namespace {

struct LineVertex {
  Vec3f from, to;
  float end, across, along_mm;
};

// The line lies on the finest mesh; a coarse one may stand some hundredths above it.
constexpr float kLiftMm = 0.06f;
constexpr float kCasingPx = 1.1f;  // wider than the line, each side

}  // namespace

OverlayPass::~OverlayPass() {
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  if (vertices_ != 0) glDeleteBuffers(1, &vertices_);
}

bool OverlayPass::create(std::string& why) {
  if (!program_.link("line", why)) return false;
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
  for (GLuint i = 0; i < 3; ++i) {
    glEnableVertexAttribArray(i);
    constexpr std::array<std::size_t, 3> kOffset = {offsetof(LineVertex, from), offsetof(LineVertex, to),
                                                    offsetof(LineVertex, end)};
    glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(LineVertex), at(kOffset[i]));
  }
  return true;
}

void OverlayPass::set(const std::vector<OverlayLine>& lines) {
  ranges_.clear();
  std::vector<LineVertex> vertices;
  for (const OverlayLine& line : lines) {
    Range range{line.style, static_cast<GLint>(vertices.size()), 0};
    float along = 0;
    for (std::size_t i = 0; i + 1 < line.points_mm.size(); ++i) {
      const Vec3f from = line.points_mm[i], to = line.points_mm[i + 1];
      for (const auto& [end, across] : {std::pair{0.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {0.f, -1.f}, {1.f, 1.f}, {0.f, 1.f}})
        vertices.push_back({from, to, end, across, along});
      along += glm::length(to - from);
    }
    range.count = static_cast<GLsizei>(vertices.size()) - range.first;
    if (range.count > 0) ranges_.push_back(range);
  }
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(LineVertex)), vertices.data(),
               GL_STATIC_DRAW);
}

void OverlayPass::draw(const FrameView& view) {
  if (ranges_.empty()) return;
  program_.use();
  program_.set("clip_from_world", view.clip_from_world);
  program_.set("eye", view.eye);
  program_.set("view_px", view.view_px);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glBindVertexArray(array_);
  for (const bool casing : {true, false}) {
    for (const Range& range : ranges_) {
      const Colour ink = casing ? range.style.casing : range.style.colour;
      program_.set("ink", glm::vec4(ink.r, ink.g, ink.b, ink.a));
      program_.set("half_px", (range.style.width_px / 2 + (casing ? kCasingPx : 0.0f)) * view.line_scale);
      program_.set("lift_mm", casing ? kLiftMm : kLiftMm * 1.2f);
      program_.set("dash_mm", glm::vec2(range.style.dash_mm, range.style.gap_mm));
      glDrawArrays(GL_TRIANGLES, range.first, range.count);
    }
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glEnable(GL_CULL_FACE);
}

}  // namespace cusp::ui
