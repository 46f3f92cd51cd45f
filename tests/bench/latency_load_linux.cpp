#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <future>
#include <thread>
#include <vector>

#include "tests/bench/latency_load.h"
#include "tests/bench/tick_times.h"

namespace cusp::bench {

namespace {

constexpr int kWidth = 1280, kHeight = 800;
constexpr int kAcross = 224;  // a sheet of 224 x 224 squares: 100,352 triangles
constexpr int kAnew = 2000;   // vertices that are uploaded for each frame
constexpr auto kFrame = std::chrono::microseconds(16'667);

constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec3 place;
out vec3 normal;
uniform float turn;
void main() {
  float c = cos(turn), s = sin(turn);
  normal = normalize(vec3(-cos(9.0 * place.x), -sin(9.0 * place.y), 1.0));
  gl_Position = vec4(c * place.x - s * place.y, s * place.x + c * place.y, 0.3 * place.z, 1.0);
})";
constexpr const char* kFragment = R"(#version 330 core
in vec3 normal;
out vec4 colour;
void main() {
  vec3 n = normalize(normal);
  float lit = max(dot(n, normalize(vec3(0.4, 0.5, 0.8))), 0.0);
  colour = vec4(vec3(0.25 + 0.6 * lit + 0.3 * pow(lit, 24.0)), 1.0);
})";

std::vector<float> sheet() {
  std::vector<float> out;
  for (int y = 0; y <= kAcross; ++y) {
    for (int x = 0; x <= kAcross; ++x) {
      const float u = 2.0f * static_cast<float>(x) / kAcross - 1.0f, v = 2.0f * static_cast<float>(y) / kAcross - 1.0f;
      out.insert(out.end(), {u, v, 0.5f * std::sin(9.0f * u) * std::cos(9.0f * v)});
    }
  }
  return out;
}

std::vector<std::uint32_t> triangles() {
  std::vector<std::uint32_t> out;
  constexpr std::uint32_t kRow = kAcross + 1;
  for (std::uint32_t y = 0; y < kAcross; ++y) {
    for (std::uint32_t x = 0; x < kAcross; ++x) {
      const std::uint32_t a = y * kRow + x;
      out.insert(out.end(), {a, a + 1, a + kRow, a + 1, a + kRow + 1, a + kRow});
    }
  }
  return out;
}

GLuint program() {
  const GLuint out = glCreateProgram();
  const auto add = [out](GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(out, shader);
    glDeleteShader(shader);
  };
  add(GL_VERTEX_SHADER, kVertex);
  add(GL_FRAGMENT_SHADER, kFragment);
  glLinkProgram(out);
  GLint linked = 0;
  glGetProgramiv(out, GL_LINK_STATUS, &linked);
  return linked != 0 ? out : 0;
}

class EglDrawingLoad final : public DrawingLoad {
 public:
  /// False where there is no context.
  bool begin() {
    std::promise<bool> works;
    auto started = works.get_future();
    thread_ = std::thread([this, works = std::move(works)]() mutable { draw(works); });
    return started.get();
  }
  ~EglDrawingLoad() override {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  double frames_per_s() const override {
    const double s = std::chrono::duration<double>(Clock::now() - begun_).count();
    return s > 0 ? static_cast<double>(frames_.load()) / s : 0.0;
  }

 private:
  void draw(std::promise<bool>& works) {
    EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
      return works.set_value(false);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
      return works.set_value(false);
    GLuint frame = 0, colour = 0, depth = 0, array = 0, vertices = 0, indices = 0;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glGenRenderbuffers(1, &colour);
    glBindRenderbuffer(GL_RENDERBUFFER, colour);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kWidth, kHeight);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kWidth, kHeight);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    const GLuint shading = program();
    if (shading == 0 || glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return works.set_value(false);
    const std::vector<float> places = sheet();
    const std::vector<std::uint32_t> order = triangles();
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &vertices);
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(float)), places.data(), GL_DYNAMIC_DRAW);
    glGenBuffers(1, &indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(order.size() * sizeof(std::uint32_t)), order.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(float), nullptr);
    glViewport(0, 0, kWidth, kHeight);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(shading);
    const GLint turn = glGetUniformLocation(shading, "turn");
    begun_ = Clock::now();
    works.set_value(true);
    auto due = begun_;
    for (int n = 0; !stop_; ++n) {
      glBufferSubData(GL_ARRAY_BUFFER, 0, kAnew * 3 * static_cast<GLsizeiptr>(sizeof(float)), places.data());
      glUniform1f(turn, 0.01f * static_cast<float>(n % 628));
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(order.size()), GL_UNSIGNED_INT, nullptr);
      glFinish();
      ++frames_;
      due = std::max(due + kFrame, Clock::now());
      std::this_thread::sleep_until(due);
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglTerminate(display);
  }

  std::atomic<bool> stop_{false};
  std::atomic<std::uint64_t> frames_{0};
  Clock::time_point begun_{};
  std::thread thread_;
};

}  // namespace

std::unique_ptr<DrawingLoad> DrawingLoad::start() {
  auto load = std::make_unique<EglDrawingLoad>();
  if (!load->begin()) return nullptr;
  return load;
}

}  // namespace cusp::bench
