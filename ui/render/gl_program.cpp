#include "ui/render/gl_program.h"

#include <array>

#include "ui/render/shaders.h"

namespace cusp::ui {
namespace {

const char* text_of(const std::string& name) {
  for (const ShaderText& shader : shader_texts()) {
    if (shader.name == name) return shader.text;
  }
  return nullptr;
}

GLuint compile(GLenum kind, const std::string& name, std::string_view define, std::string& why) {
  const char* text = text_of(name);
  if (text == nullptr) {
    why = name;
    return 0;
  }
  const GLuint shader = glCreateShader(kind);
  // The first line is #version and stays the first.
  const std::string_view whole(text);
  const std::size_t first = whole.find('\n') + 1;
  std::string source(whole.substr(0, first));
  if (!define.empty()) source += "#define " + std::string(define) + "\n";
  source += whole.substr(first);
  const char* const lines = source.c_str();
  glShaderSource(shader, 1, &lines, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  std::array<char, 1024> log{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  why = name + ": " + log.data();
  glDeleteShader(shader);
  return 0;
}

}  // namespace

GlProgram::~GlProgram() {
  if (program_ != 0) glDeleteProgram(program_);
}

bool GlProgram::link(std::string_view name, std::string& why, std::string_view define) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, std::string(name) + ".vert.glsl", define, why);
  const GLuint fragment = vertex ? compile(GL_FRAGMENT_SHADER, std::string(name) + ".frag.glsl", define, why) : 0;
  if (fragment != 0) {
    program_ = glCreateProgram();
    glAttachShader(program_, vertex);
    glAttachShader(program_, fragment);
    glLinkProgram(program_);
    GLint good = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &good);
    if (!good) {
      std::array<char, 1024> log{};
      glGetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
      why = std::string(name) + ": " + log.data();
      glDeleteProgram(program_);
      program_ = 0;
    }
  }
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  return program_ != 0;
}

GLint GlProgram::place(const char* name) {
  const auto [it, made] = places_.try_emplace(name, -1);
  if (made) it->second = glGetUniformLocation(program_, name);
  return it->second;
}

}  // namespace cusp::ui
