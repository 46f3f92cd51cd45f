/// The mouth mirror: marks its glass in the stencil, so that a reflected view fills it, and draws mount and handle.
/// Thread: the one that holds the context. The framebuffer has a stencil.
#pragma once

#include <epoxy/gl.h>

#include "ui/render/body_buffer.h"
#include "ui/render/gl_program.h"
#include "ui/render/mouth_mirror.h"

namespace cusp::ui {

/// The view of the mirror's glass: eye and lamps are reflected, and triangles come out turned round.
FrameView reflected(const FrameView& view, const MouthMirror& mirror);
/// Keeps what lies before the glass; a clip plane of the tooth's pass.
glm::vec4 before_glass(const MouthMirror& mirror);

class MirrorPass {
 public:
  MirrorPass() = default;
  ~MirrorPass();
  MirrorPass(const MirrorPass&) = delete;
  MirrorPass& operator=(const MirrorPass&) = delete;
  bool create(std::string& why);

  /// Until end_glass() drawing reaches the seen part of the glass alone, over what the mouth mirrors where nothing stands.
  void begin_glass(const FrameView& view, const MouthMirror& mirror);
  void end_glass(const FrameView& view, const MouthMirror& mirror);
  void draw_mount(const FrameView& view, const MouthMirror& mirror);

 private:
  struct Part {
    GLint first = 0;
    GLsizei count = 0;
  };
  void draw_glass(const FrameView& view, const MouthMirror& mirror);
  void draw_body(Vec3 origin_mm, Vec3 along, Part part);

  GlProgram glass_, metal_;
  GLuint glass_array_ = 0;
  BodyBuffer bodies_;
  Part mount_, handle_;
};

}  // namespace cusp::ui
