#include "ui/render/snapshot.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "ui/render/gl_context_egl.h"

namespace cusp::ui {
namespace {

/// Half the size, four pixels into one: the edges come out smooth without multisampling.
Picture halved(int width, int height, const std::vector<std::uint8_t>& twice) {
  Picture out{width, height, {}, {}};
  const auto row = static_cast<std::size_t>(width) * 8;
  out.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  std::size_t to = 0;
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const std::size_t from = 2 * y * row + 8 * x + c;
        const int sum = twice[from] + twice[from + 4] + twice[from + row] + twice[from + row + 4];
        out.rgba[to++] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
  return out;
}

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// libpng leaves by longjmp: nothing with a destructor lives in here.
bool write_png_rows(std::FILE* file, int width, int height, png_bytep first, std::size_t row) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_init_io(png, file);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8, PNG_COLOR_TYPE_RGBA,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  for (int y = 0; y < height; ++y) png_write_row(png, first + static_cast<std::size_t>(y) * row);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

Result<Picture, PictureFailure> draw_here(const Volume& volume, const PictureRequest& request) {
  std::string why;
  const int width = std::clamp(request.width_px, 16, 4096), height = std::clamp(request.height_px, 16, 4096);
  const std::unique_ptr<EglContext> context = EglContext::create(2 * width, 2 * height, &why);
  if (!context) return fail(PictureError::no_opengl, "EGL", why);
  const std::unique_ptr<ToothPicture> picture = ToothPicture::create(&why);
  if (!picture) return fail(PictureError::no_opengl, "OpenGL", why);

  FeedSettings settings;
  settings.deviation = request.deviation;
  PatchFeed feed(settings);
  feed.build_all(volume);
  PatchStore store;
  for (BakedPatch& patch : feed.take(~std::size_t{0}).patches) {
    picture->put(patch);
    store.put(std::move(patch));
  }
  picture->set_scenery(request.scenery.get());
  Box box = request.look_at;
  if (box.low == box.high) box = store.bounds().value_or(Box{Vec3(-5.0), Vec3(5.0)});

  Scene3d scene;
  scene.camera = Camera::about(0.5 * (box.low + box.high), 0.5 * glm::length(box.high - box.low));
  scene.camera.set_preset(request.view);
  scene.colouring = request.colouring;
  scene.line_scale = 2.0f * static_cast<float>(std::min(width, height)) / 700.0f;
  if (request.sideways_mm) {
    const Volume uncut(volume.specimen_ptr());
    picture->set_lines(target_lines(uncut, request.sideways_mm, request.leeway_mm));
  }
  picture->draw(scene, context->width(), context->height());
  const std::vector<std::uint8_t> pixels = context->read_rgba();
  if (const std::string failed = context->failed_call(); !failed.empty()) return fail(PictureError::drawing, "OpenGL", failed);
  Picture out = halved(width, height, pixels);
  PatchStore beside;
  if (request.scenery)
    for (const BakedPatch& patch : request.scenery->patches()) beside.put(patch);
  for (const Vec3& place : request.places_mm) {
    const auto at = scene.camera.project(place, width, height);
    const bool inside = at && at->x >= 0 && at->y >= 0 && at->x < width && at->y < height;
    const bool seen = inside && store.shows(place, scene.camera.eye_mm()) && beside.shows(place, scene.camera.eye_mm());
    out.places_px.push_back(seen ? at : std::nullopt);
  }
  return out;
}

}  // namespace

Result<Picture, PictureFailure> draw_tooth(const Volume& volume, const PictureRequest& request) {
  // A window's thread may hold the window's context, and cannot have a second one of another kind beside it.
  std::optional<Result<Picture, PictureFailure>> drawn;
  std::thread([&] { drawn.emplace(draw_here(volume, request)); }).join();
  return std::move(*drawn);
}

Result<void, PictureFailure> write_png(const std::string& path, const Picture& picture) {
  const std::string part = path + ".part";
  std::error_code ignored;
  bool good = false;
  {
    const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(part.c_str(), "wb"));
    if (!file) return fail(PictureError::cannot_write, path);
    good = write_png_rows(file.get(), picture.width, picture.height, const_cast<png_bytep>(picture.rgba.data()),
                          static_cast<std::size_t>(picture.width) * 4) &&
           std::fflush(file.get()) == 0;
  }
  if (good) {
    std::error_code failed;
    std::filesystem::rename(part, path, failed);
    if (!failed) return {};
  }
  std::filesystem::remove(part, ignored);
  return fail(PictureError::cannot_write, path);
}

Result<void, PictureFailure> write_tooth_png(const std::string& path, const Volume& volume,
                                             const PictureRequest& request) {
  Result<Picture, PictureFailure> picture = draw_tooth(volume, request);
  if (!picture) return std::unexpected(picture.error());
  return write_png(path, *picture);
}

}  // namespace cusp::ui
