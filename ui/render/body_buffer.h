/// The triangles of bodies of revolution in OpenGL's memory. Thread: the one that holds the context, from create() on.
#pragma once

#include <epoxy/gl.h>

#include <span>

#include "ui/render/turned_body.h"

namespace cusp::ui {

class BodyBuffer {
 public:
  BodyBuffer() = default;
  ~BodyBuffer();
  BodyBuffer(const BodyBuffer&) = delete;
  BodyBuffer& operator=(const BodyBuffer&) = delete;
  void create();
  /// Pre: create().
  void fill(std::span<const BodyVertex> triangles);
  /// Draws `count` vertices from `first` on by the program in use.
  void draw(GLint first, GLsizei count) const;
  void draw() const { draw(0, count_); }

 private:
  GLuint array_ = 0, vertices_ = 0;
  GLsizei count_ = 0;
};

}  // namespace cusp::ui
