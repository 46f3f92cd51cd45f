#include "ui/render/snapshot.h"

#include <algorithm>
#include <future>
#include <memory>
#include <optional>

#include "ui/render/gl_context_egl.h"
#include "ui/render/place_view.h"

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

/// The tooth's meshes, uploaded and for rays.
struct Meshed {
  PatchStore tooth, beside;
  Meshes all() const { return {&tooth, &beside}; }
};

Meshed put_meshes(ToothPicture& picture, const Volume& volume, const PictureRequest& request) {
  FeedSettings settings;
  settings.deviation = request.deviation;
  PatchFeed feed(settings);
  feed.build_all(volume);
  Meshed out;
  for (BakedPatch& patch : feed.take(~std::size_t{0}).patches) {
    picture.put(patch);
    out.tooth.put(std::move(patch));
  }
  picture.set_scenery(request.scenery.get());
  if (request.scenery)
    for (const BakedPatch& patch : request.scenery->patches()) out.beside.put(patch);
  if (request.sideways_mm) {
    const Volume uncut(volume.specimen_ptr());
    picture.set_lines(target_lines(uncut, request.sideways_mm, request.leeway_mm));
  }
  return out;
}

/// Where the picture shows a place; nullopt: hidden, or outside.
std::optional<glm::dvec2> place_px(const Camera& camera, const Meshed& meshes, Vec3 place, const Picture& picture) {
  const auto at = camera.project(place, {picture.width, picture.height});
  const bool inside = at && at->x >= 0 && at->y >= 0 && at->x < picture.width && at->y < picture.height;
  return inside && seen_from(camera, meshes.all(), place) ? at : std::nullopt;
}

Picture draw_closeup(ToothPicture& picture, Framebuffer& onto, const Meshed& meshes, Scene3d scene, Vec3 place) {
  scene.camera = look_at_place(Camera::about(place, kCloseupMm), meshes.all(), place);
  onto.bind();
  const auto [width, height] = onto.size();
  picture.draw(scene, width, height);
  std::vector<std::uint8_t> twice(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  onto.read(PixelOrder::rgba, twice);
  Picture out = halved(width / 2, height / 2, twice);
  out.places_px.push_back(place_px(scene.camera, meshes, place, out));
  return out;
}

Result<Picture, PictureFailure> draw_here(const Volume& volume, const PictureRequest& request) {
  std::string why;
  const int width = std::clamp(request.width_px, 16, 4096), height = std::clamp(request.height_px, 16, 4096);
  const std::unique_ptr<EglContext> context = EglContext::create(2 * width, 2 * height, &why);
  if (!context) return fail(PictureError::no_opengl, "EGL", why);
  const std::unique_ptr<ToothPicture> picture = ToothPicture::create(&why);
  if (!picture) return fail(PictureError::no_opengl, "OpenGL", why);

  const Meshed meshes = put_meshes(*picture, volume, request);
  Box box = request.look_at;
  if (box.low == box.high) box = meshes.tooth.bounds().value_or(Box{Vec3(-5.0), Vec3(5.0)});
  Scene3d scene;
  scene.camera = Camera::about(0.5 * (box.low + box.high), 0.5 * glm::length(box.high - box.low));
  scene.camera.set_preset(request.view);
  scene.colouring = request.colouring;
  scene.line_scale = 2.0f * static_cast<float>(std::min(width, height)) / 700.0f;
  picture->draw(scene, context->width(), context->height());
  Picture out = halved(width, height, context->read_rgba());
  for (const Vec3& place : request.places_mm) out.places_px.push_back(place_px(scene.camera, meshes, place, out));

  if (!request.closeups_mm.empty()) {
    const int side = 2 * std::clamp(request.closeup_px, 16, 2048);
    const auto onto = Framebuffer::create({side, side}, Multisampling::off, &why);
    if (!onto) return fail(PictureError::drawing, "OpenGL", why);
    for (std::size_t i = 0; i < request.closeups_mm.size(); ++i) {
      picture->set_marks(i < request.closeup_marks.size() ? request.closeup_marks[i] : SurfaceMarks{});
      out.closeups.push_back(draw_closeup(*picture, *onto, meshes, scene, request.closeups_mm[i]));
    }
  }
  if (const std::string failed = context->failed_call(); !failed.empty()) return fail(PictureError::drawing, "OpenGL", failed);
  return out;
}

}  // namespace

Result<Picture, PictureFailure> draw_tooth(const Volume& volume, const PictureRequest& request) {
  // A window's thread may hold the window's context, and cannot have a second one of another kind beside it.
  return std::async(std::launch::async, [&] { return draw_here(volume, request); }).get();
}

}  // namespace cusp::ui
