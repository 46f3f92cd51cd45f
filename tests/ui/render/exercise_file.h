/// What the programs of this folder read and write.
#pragma once

#include <png.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "scenarios/format/read.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"

namespace cusp::test {

/// Of a file, or of a built-in exercise with this id.
inline Result<Scenario, FormatFailure> scenario_of(const std::string& name) {
  std::ifstream file(name);
  if (!file) return load_builtin(name);
  std::stringstream text;
  text << file.rdbuf();
  return read_scenario(text.str());
}

/// Top row first, R, G, B, A.
inline bool write_png(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgba) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGBA;
  return png_image_write_to_file(&image, path.c_str(), 0, rgba.data(), 0, nullptr) != 0;
}

}  // namespace cusp::test
