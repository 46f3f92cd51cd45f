/// A linked pair of shaders. Thread: the one that holds the context.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <string_view>
#include <unordered_map>

#include "engine/base/vec.h"
#include "ui/render/colours.h"

namespace cusp::ui {

class GlProgram {
 public:
  GlProgram() = default;
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  /// `name` of "NAME.vert.glsl" and "NAME.frag.glsl"; `define`: a macro that both are compiled with, or empty.
  /// False and the compiler's message in `why` on failure.
  bool link(std::string_view name, std::string& why, std::string_view define = {});
  void use() const { glUseProgram(program_); }

  /// Of the program in use; an unknown name is left alone, as OpenGL does.
  void set(const char* name, int value) { glUniform1i(place(name), value); }
  void set(const char* name, float value) { glUniform1f(place(name), value); }
  void set(const char* name, glm::vec2 v) { glUniform2f(place(name), v.x, v.y); }
  void set(const char* name, glm::vec3 v) { glUniform3f(place(name), v.x, v.y, v.z); }
  void set(const char* name, glm::vec4 v) { glUniform4f(place(name), v.x, v.y, v.z, v.w); }
  void set(const char* name, const glm::mat4& m) { glUniformMatrix4fv(place(name), 1, GL_FALSE, &m[0][0]); }
  void set_array(const char* name, const glm::vec3* first, int count) { glUniform3fv(place(name), count, &first->x); }

 private:
  GLint place(const char* name);
  GLuint program_ = 0;
  std::unordered_map<std::string, GLint> places_;
};

/// sRGB to linear light as the shaders' square root undoes it.
inline glm::vec3 linear(Colour c) noexcept { return {c.r * c.r, c.g * c.g, c.b * c.b}; }

/// What every pass of a frame shares.
struct FrameView {
  glm::mat4 clip_from_world{1.0f};
  glm::vec3 eye{0.0f};
  glm::vec3 key_light{0.0f, 0.0f, 1.0f}, fill_light{0.0f, 0.0f, 1.0f}, up{0.0f, 0.0f, 1.0f};  // unit, towards the light
  glm::vec3 back_light{0.0f, 0.0f, -1.0f}, right{1.0f, 0.0f, 0.0f}, to_eye{0.0f, 0.0f, 1.0f};  // unit; from the view's middle
  glm::vec3 half_way{0.0f, 0.0f, 1.0f};  // unit, between key light and the view's direction
  glm::vec4 lamp{0.0f, 0.0f, 0.0f, 1.0f};  // middle of its beam, radius (mm)
  glm::vec2 view_px{1.0f};
  float line_scale = 1.0f;
};

}  // namespace cusp::ui
