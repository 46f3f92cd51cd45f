#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdio>
#include <mutex>

#include "ui/render/gl_context_egl.h"
#include "ui/render/opengl_allowed.h"

namespace cusp::ui {
namespace {

/// EGL gives every caller the same display, and eglTerminate() ends it for all of them: a picture that is done on one
/// thread must not end the display under another. The last context to go terminates it.
struct SharedDisplay {
  std::mutex mutex;
  EGLDisplay display = EGL_NO_DISPLAY;
  int users = 0;
};
SharedDisplay& shared_display() {
  static SharedDisplay shared;
  return shared;
}

/// EGL_NO_DISPLAY when there is none. Each success needs one release_display().
EGLDisplay acquire_display() {
  SharedDisplay& shared = shared_display();
  const std::lock_guard lock(shared.mutex);
  if (shared.users == 0) {
    // Surfaceless first: it needs neither a display server nor a card.
    EGLDisplay display = EGL_NO_DISPLAY;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
      display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_DISPLAY;
    shared.display = display;
  }
  ++shared.users;
  return shared.display;
}

void release_display() {
  SharedDisplay& shared = shared_display();
  const std::lock_guard lock(shared.mutex);
  if (--shared.users == 0) eglTerminate(shared.display);
}

/// "eglMakeCurrent 0x3002"
std::string with_code(const char* call, unsigned code) {
  std::array<char, 16> number{};
  std::snprintf(number.data(), number.size(), " 0x%04x", code);
  return call + std::string(number.data());
}

}  // namespace

std::unique_ptr<EglContext> EglContext::create(int width_px, int height_px, std::string* why) {
  if (!opengl_allowed()) {
    if (why != nullptr) *why = "opengl_allowed";
    return nullptr;
  }
  const auto give_up = [why](const char* call) {
    if (why != nullptr) *why = with_code(call, static_cast<unsigned>(eglGetError()));
    return nullptr;
  };
  std::unique_ptr<EglContext> out(new EglContext);
  EGLDisplay display = acquire_display();
  if (display == EGL_NO_DISPLAY) return give_up("eglInitialize");
  out->display_ = display;
  if (!eglBindAPI(EGL_OPENGL_API)) return give_up("eglBindAPI");
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &found) || found == 0) config = EGL_NO_CONFIG_KHR;
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT) return give_up("eglCreateContext");
  out->context_ = context;
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return give_up("eglMakeCurrent");

  out->framebuffer_ = Framebuffer::create({width_px, height_px}, Multisampling::off, why);
  if (!out->framebuffer_) return nullptr;
  return out;
}

EglContext::~EglContext() {
  if (display_ == nullptr) return;
  if (context_ != nullptr) {
    framebuffer_.reset();
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }
  release_display();
}

std::string EglContext::failed_call() const {
  const GLenum code = glGetError();
  return code == GL_NO_ERROR ? std::string() : with_code("OpenGL", code);
}

std::vector<std::uint8_t> EglContext::read_rgba() const {
  std::vector<std::uint8_t> out(4 * static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()));
  framebuffer_->read(PixelOrder::rgba, out);
  return out;
}

}  // namespace cusp::ui
