#include "ui/render/mark_pass.h"

namespace cusp::ui {
namespace {

constexpr float kLiftMm = 0.05f;   // a coarse mesh may stand some hundredths above the cut surface
constexpr float kStripePx = 3.0f;  // at 100 %

}  // namespace

MarkPass::~MarkPass() {
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  if (vertices_ != 0) glDeleteBuffers(1, &vertices_);
}

bool MarkPass::create(std::string& why) {
  if (!program_.link("mark", why)) return false;
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), nullptr);
  return true;
}

void MarkPass::set(const std::vector<std::array<Vec3f, 3>>& triangles) {
  count_ = static_cast<GLsizei>(3 * triangles.size());
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(triangles.front())), triangles.data(), GL_STATIC_DRAW);
}

void MarkPass::draw(const FrameView& view) {
  if (count_ == 0) return;
  program_.use();
  program_.set("clip_from_world", view.clip_from_world);
  program_.set("eye", view.eye);
  program_.set("lift_mm", kLiftMm);
  program_.set("ink", glm::vec4(kEvidence.r, kEvidence.g, kEvidence.b, kEvidence.a));
  program_.set("stripe_px", kStripePx * view.line_scale);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, count_);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glEnable(GL_CULL_FACE);
}

}  // namespace cusp::ui
