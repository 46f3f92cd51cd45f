// cusp-open-scene SCENARIO [PICTURE.png]: opens an exercise as the drilling screen does, but for the window: specimen,
// scenery, meshes and the first picture. Prints how long that took, how much memory, and what a frame of 976 x 680 costs
// with the scenery and without. SCENARIO: a file, or the id of a built-in exercise. Exit 1 beyond 10 s or 600 MB.
#include <epoxy/gl.h>
#include <png.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/format/read.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/patch_feed.h"
#include "ui/render/scenery_look.h"
#include "ui/render/target_look.h"
#include "ui/render/tooth_picture.h"
#include "ui/session/scene_builder.h"

using namespace cusp;
using namespace cusp::test;

namespace {

constexpr int kWidth = 976, kHeight = 680, kFrames = 40;
constexpr double kMostSeconds = 10.0;
constexpr long kMostKb = 600 * 1024;

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

long peak_kb() {
  std::ifstream status("/proc/self/status");
  long out = 0;
  for (std::string field; status >> field;) {
    if (field == "VmHWM:") status >> out;
  }
  return out;
}

Result<Scenario, FormatFailure> scenario_of(const std::string& name) {
  std::ifstream file(name);
  if (!file) return load_builtin(name);
  std::stringstream text;
  text << file.rdbuf();
  return read_scenario(text.str());
}

struct Frames {
  double cpu_ms = 0.0;
  DrawStats stats;
};
Frames measure(ToothPicture& picture, Scene3d scene) {
  Frames out;
  const double from = cpu_s();
  for (int n = 0; n < kFrames; ++n) {
    scene.camera.orbit(0.01, 0.0);
    out.stats = picture.draw(scene, kWidth, kHeight);
    glFinish();
  }
  out.cpu_ms = 1e3 * (cpu_s() - from) / kFrames;
  return out;
}

bool write_png(const std::string& path, const std::vector<std::uint8_t>& rgba) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = kWidth;
  image.height = kHeight;
  image.format = PNG_FORMAT_RGBA;
  return png_image_write_to_file(&image, path.c_str(), 0, rgba.data(), 0, nullptr) != 0;
}

/// What is drawn, and the picture that draws it.
struct Shown {
  std::shared_ptr<const SceneryLook> scenery;
  std::shared_ptr<const Specimen> specimen;
  std::unique_ptr<TargetLook> look;
  std::unique_ptr<EglContext> context;
  std::unique_ptr<ToothPicture> picture;
  PatchStore store;
};

/// Builds the specimen beside its scenery and gives all patches to the picture. False: something could not be made.
bool show(const Scenario& scenario, Shown& shown) {
  Outcome<std::shared_ptr<const Specimen>> specimen;
  {
    const std::jthread beside([&] { shown.scenery = scenery_of(scenario.specimen); });
    specimen = build_specimen(scenario, {});
  }
  if (!specimen) return false;
  shown.specimen = *specimen;
  const Volume volume(shown.specimen);
  shown.look = std::make_unique<TargetLook>(scenario.target, scenario.leeway);
  PatchFeed feed(shown.look->feed());
  feed.build_all(volume);
  shown.context = EglContext::create(kWidth, kHeight);
  shown.picture = ToothPicture::create();
  if (!shown.context || !shown.picture) return false;
  for (BakedPatch& patch : feed.take(~std::size_t{0}).patches) {
    shown.picture->put(patch);
    shown.store.put(std::move(patch));
  }
  shown.picture->set_scenery(shown.scenery.get());
  shown.picture->set_lines(shown.look->lines(volume));
  return true;
}

/// The views that are measured: near, whole, jaw.
std::array<Scene3d, 3> views_of(const Shown& shown) {
  std::array<Scene3d, 3> out;
  const Box box = shown.store.bounds().value_or(Box{Vec3(-5.0), Vec3(5.0)});
  for (Scene3d& scene : out) scene.camera = Camera::about(0.5 * (box.low + box.high), 0.5 * glm::length(box.high - box.low));
  if (!shown.look->empty()) {
    const auto& target = shown.look->shape();
    out[0].camera = Camera::about(Vec3(0.5 * (target.low() + target.high()), target.top_mm()), 3.5);
  }
  if (shown.scenery) out[2].camera = Camera::about(0.5 * (shown.scenery->bounds().low + shown.scenery->bounds().high), 36.0);
  return out;
}

void print_frames(const Shown& shown, const char* what, const Scene3d& from) {
  shown.picture->set_scenery(nullptr);
  const Frames bare = measure(*shown.picture, from);
  shown.picture->set_scenery(shown.scenery.get());
  const Frames with = measure(*shown.picture, from);
  std::printf("%s: %.1f ms of processor time a frame without scenery (%zu triangles), %.1f ms with it (%zu)\n", what,
              bare.cpu_ms, bare.stats.triangles, with.cpu_ms, with.stats.triangles);
}

/// "name.png" becomes "name-1.png" to "name-3.png".
bool write_views(const Shown& shown, const std::array<Scene3d, 3>& views, const std::string& path) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    shown.picture->draw(views[i], kWidth, kHeight);
    std::string numbered = path;
    numbered.insert(numbered.size() - 4, "-" + std::to_string(i + 1));
    if (!write_png(numbered, shown.context->read_rgba())) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto start = std::chrono::steady_clock::now();
  const double cpu = cpu_s();
  const auto scenario = scenario_of(argv[1]);
  if (!scenario) {
    std::fprintf(stderr, "cusp-open-scene: %s: %s\n", argv[1], scenario.error().where.c_str());
    return 1;
  }
  Shown shown;
  if (!show(*scenario, shown)) return 1;
  const std::array<Scene3d, 3> views = views_of(shown);
  const auto& [near, whole, jaw] = views;
  shown.picture->draw(whole, kWidth, kHeight);
  glFinish();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const long kb = peak_kb();
  std::printf("%s: first picture after %.1f s (%.1f s of processor time), at most %ld MB resident\n", argv[1], seconds,
              cpu_s() - cpu, kb / 1024);
  std::printf("kept: %.1f MB of bricks, %.1f MB of scenery in %zu patches, %zu triangles of the specimen\n",
              static_cast<double>(shown.specimen->bytes()) / 1e6, shown.scenery ? static_cast<double>(shown.scenery->bytes()) / 1e6 : 0.0,
              shown.scenery ? shown.scenery->patches().size() : 0, shown.store.triangles());
  if (!shown.look->empty()) print_frames(shown, "at the target", near);
  print_frames(shown, "the whole specimen", whole);
  if (shown.scenery) print_frames(shown, "the whole jaw", jaw);
  if (argc > 2 && !write_views(shown, views, argv[2])) return 1;
  return seconds < kMostSeconds && kb < kMostKb ? 0 : 1;
}
