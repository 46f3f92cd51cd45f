// cusp-open-scene SCENARIO [PICTURE.png]: opens an exercise as the drilling screen does, but for the window: specimen,
// scenery, meshes and the first picture. Prints how long that took, how much memory, and what a frame of 976 x 680 costs
// with the scenery and without. SCENARIO: a file, or the id of a built-in exercise. Exit 1 beyond 10 s or 600 MB.
#include <epoxy/gl.h>
#include <png.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
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
  std::shared_ptr<const SceneryLook> scenery;
  Outcome<std::shared_ptr<const Specimen>> specimen;
  {
    const std::jthread beside([&] { scenery = scenery_of(scenario->specimen); });
    specimen = build_specimen(*scenario, {});
  }
  if (!specimen) return 1;
  const Volume volume(*specimen);
  const TargetLook look(scenario->target, scenario->leeway);
  PatchFeed feed(look.feed());
  feed.build_all(volume);
  const auto lines = look.lines(volume);
  const auto context = EglContext::create(kWidth, kHeight);
  const auto picture = ToothPicture::create();
  if (!context || !picture) return 1;
  PatchStore store;
  for (BakedPatch& patch : feed.take(~std::size_t{0}).patches) {
    picture->put(patch);
    store.put(std::move(patch));
  }
  picture->set_scenery(scenery.get());
  picture->set_lines(lines);
  Scene3d scene;
  const Box box = store.bounds().value_or(Box{Vec3(-5.0), Vec3(5.0)});
  scene.camera = Camera::about(0.5 * (box.low + box.high), 0.5 * glm::length(box.high - box.low));
  picture->draw(scene, kWidth, kHeight);
  glFinish();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const long kb = peak_kb();
  std::printf("%s: first picture after %.1f s (%.1f s of processor time), at most %ld MB resident\n", argv[1], seconds,
              cpu_s() - cpu, kb / 1024);
  std::printf("kept: %.1f MB of bricks, %.1f MB of scenery in %zu patches, %zu triangles of the specimen\n",
              static_cast<double>((*specimen)->bytes()) / 1e6, scenery ? static_cast<double>(scenery->bytes()) / 1e6 : 0.0,
              scenery ? scenery->patches().size() : 0, store.triangles());
  const auto print_frames = [&](const char* what, const Scene3d& from) {
    picture->set_scenery(nullptr);
    const Frames bare = measure(*picture, from);
    picture->set_scenery(scenery.get());
    const Frames with = measure(*picture, from);
    std::printf("%s: %.1f ms of processor time a frame without scenery (%zu triangles), %.1f ms with it (%zu)\n", what,
                bare.cpu_ms, bare.stats.triangles, with.cpu_ms, with.stats.triangles);
  };
  Scene3d near = scene;
  if (!look.empty()) {
    near.camera = Camera::about(Vec3(0.5 * (look.shape().low() + look.shape().high()), look.shape().top_mm()), 3.5);
    print_frames("at the target", near);
  }
  print_frames("the whole specimen", scene);
  Scene3d all = scene;
  if (scenery) {
    all.camera = Camera::about(0.5 * (scenery->bounds().low + scenery->bounds().high), 36.0);
    print_frames("the whole jaw", all);
  }
  if (argc > 2) {
    int number = 0;
    for (const Scene3d* from : {&near, &scene, &all}) {
      picture->draw(*from, kWidth, kHeight);
      std::string path = argv[2];
      path.insert(path.size() - 4, "-" + std::to_string(++number));
      if (!write_png(path, context->read_rgba())) return 1;
    }
  }
  return seconds < kMostSeconds && kb < kMostKb ? 0 : 1;
}
