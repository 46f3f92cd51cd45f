#include "ui/render/framebuffer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace cusp::ui {
namespace {

constexpr int kSamples = 4;

void release(unsigned framebuffer, unsigned colour, unsigned depth) {
  if (framebuffer != 0) glDeleteFramebuffers(1, &framebuffer);
  if (colour != 0) glDeleteRenderbuffers(1, &colour);
  if (depth != 0) glDeleteRenderbuffers(1, &depth);
}

}  // namespace

bool draws_in_software() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (name == nullptr) return true;
  const auto in_software = [name](const char* rasteriser) { return std::strstr(name, rasteriser) != nullptr; };
  constexpr std::array<const char*, 4> kRasterisers = {"llvmpipe", "softpipe", "SwiftShader", "Software Rasterizer"};
  return std::ranges::any_of(kRasterisers, in_software);
}

Multisampling usual_multisampling() { return draws_in_software() ? Multisampling::off : Multisampling::four; }

FramebufferSize drawable(FramebufferSize wanted) {
  GLint most_px = 0;
  std::array<GLint, 2> viewport_px{};
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most_px);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport_px.data());
  const double share = std::min({1.0, std::min(most_px, viewport_px[0]) / static_cast<double>(wanted.width_px),
                                 std::min(most_px, viewport_px[1]) / static_cast<double>(wanted.height_px)});
  const auto scaled = [share](int side_px) { return std::max(1, static_cast<int>(share * side_px)); };
  return {scaled(wanted.width_px), scaled(wanted.height_px)};
}

void Framebuffer::attach(Buffers& to, FramebufferSize size, int samples) {
  glGenFramebuffers(1, &to.framebuffer);
  glGenRenderbuffers(1, &to.colour);
  glGenRenderbuffers(1, &to.depth);
  glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, to.colour);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, size.width_px, size.height_px);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, to.colour);
  glBindRenderbuffer(GL_RENDERBUFFER, to.depth);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8, size.width_px, size.height_px);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, to.depth);
}

std::unique_ptr<Framebuffer> Framebuffer::create(FramebufferSize size, Multisampling multisampling, std::string* why) {
  std::unique_ptr<Framebuffer> out(new Framebuffer);
  out->size_ = size;
  const bool multisampled = multisampling == Multisampling::four;
  if (multisampled) attach(out->resolved_, size, 0);
  attach(out->drawn_, size, multisampled ? kSamples : 0);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return out;
  if (why != nullptr) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "glCheckFramebufferStatus 0x%04x", status);
    *why = text.data();
  }
  return nullptr;
}

Framebuffer::~Framebuffer() {
  release(drawn_.framebuffer, drawn_.colour, drawn_.depth);
  release(resolved_.framebuffer, resolved_.colour, resolved_.depth);
}

void Framebuffer::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer); }

void Framebuffer::read(PixelOrder order, std::span<std::uint8_t> pixels) {
  const int width = size_.width_px, height = size_.height_px;
  if (resolved_.framebuffer != 0) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.framebuffer);
  }
  const auto row = static_cast<std::size_t>(width) * 4;
  bottom_up_.resize(row * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, order == PixelOrder::rgba ? GL_RGBA : GL_BGRA, GL_UNSIGNED_BYTE, bottom_up_.data());
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    std::memcpy(pixels.data() + row * y, bottom_up_.data() + row * (static_cast<std::size_t>(height) - 1 - y), row);
  bind();
}

}  // namespace cusp::ui
