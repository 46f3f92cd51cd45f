#include "ui/render/body_buffer.h"

#include <cstddef>

namespace cusp::ui {

BodyBuffer::~BodyBuffer() {
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  if (vertices_ != 0) glDeleteBuffers(1, &vertices_);
}

void BodyBuffer::create() {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
  for (GLuint i = 0; i < 3; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(BodyVertex), at(offsetof(BodyVertex, position_mm)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(BodyVertex), at(offsetof(BodyVertex, normal)));
  glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, sizeof(BodyVertex), at(offsetof(BodyVertex, cutting)));
}

void BodyBuffer::fill(std::span<const BodyVertex> triangles) {
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(), GL_STATIC_DRAW);
  count_ = static_cast<GLsizei>(triangles.size());
}

void BodyBuffer::draw(GLint first, GLsizei count) const {
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, first, count);
}

}  // namespace cusp::ui
