/// The shaders' text, embedded at build from ui/render/shaders.
#pragma once

#include <span>
#include <string_view>

namespace cusp::ui {

struct ShaderText {
  std::string_view name;  // file name, "tooth.vert.glsl"
  const char* text;
};

std::span<const ShaderText> shader_texts() noexcept;

}  // namespace cusp::ui
