// cusp-open-scene SCENARIO [PICTURE.png [WIDTH HEIGHT [CENTRE EDGE]]]: opens an exercise as the drilling screen does, but
// for the window: specimen, scenery, meshes and the first picture. It then cuts the target in layers. Prints how long that
// took, how much memory, what a patch costs to bake, and what a frame costs with the scenery and without, whole and cut,
// and what of it each pass takes, at the sizes of pictures in motion too.
// SCENARIO: a file, or the id of a built-in exercise. WIDTH, HEIGHT: 1280 800. CENTRE, EDGE: the background, RRGGBB. Exit 1
// beyond 10 s or 600 MB.
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/ui/render/exercise_file.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/patch_feed.h"
#include "ui/render/scenery_look.h"
#include "ui/render/target_look.h"
#include "ui/render/tooth_picture.h"
#include "ui/session/scene_builder.h"

using namespace cusp;
using namespace cusp::test;

namespace {

constexpr int kFrames = 40, kLayers = 12;
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

struct Size {
  int width = 1280, height = 800;
};

/// What is drawn, and the picture that draws it.
struct Shown {
  std::shared_ptr<const SceneryLook> scenery;
  std::shared_ptr<const Specimen> specimen;
  std::unique_ptr<Volume> volume;
  std::unique_ptr<TargetLook> look;
  std::unique_ptr<PatchFeed> feed;
  Size size;
  std::unique_ptr<EglContext> context;
  std::unique_ptr<ToothPicture> picture;
  PatchStore store;
};

struct Frames {
  double cpu_ms = 0.0, wall_ms = 0.0;
  DrawStats stats;
};
/// The median of single frames.
Frames measure(const Shown& shown, Scene3d scene) {
  Frames out;
  std::vector<double> ms, wall;
  for (int n = 0; n < kFrames; ++n) {
    scene.camera.orbit(0.01, 0.0);
    const double from = cpu_s();
    const auto start = std::chrono::steady_clock::now();
    out.stats = shown.picture->draw(scene, shown.size.width, shown.size.height);
    glFinish();
    ms.push_back(1e3 * (cpu_s() - from));
    wall.push_back(1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(ms);
  std::ranges::sort(wall);
  out.cpu_ms = ms[kFrames / 2];
  out.wall_ms = wall[kFrames / 2];
  return out;
}

/// Gives what the feed has to picture and store; the number of patches.
std::size_t take_patches(Shown& shown) {
  std::vector<BakedPatch> patches = shown.feed->take(~std::size_t{0}).patches;
  const std::size_t out = patches.size();
  for (BakedPatch& patch : patches) {
    shown.picture->put(patch);
    shown.store.put(std::move(patch));
  }
  return out;
}

/// Builds the specimen beside its scenery and gives all patches to the picture. False: something could not be made.
bool show(const Scenario& scenario, Shown& shown) {
  Outcome<std::shared_ptr<const Specimen>> specimen;
  {
    const std::jthread beside([&] { shown.scenery = scenery_of(scenario.specimen); });
    specimen = build_specimen(scenario, {});
  }
  if (!specimen) return false;
  shown.specimen = *specimen;
  shown.volume = std::make_unique<Volume>(shown.specimen);
  shown.look = std::make_unique<TargetLook>(scenario.target, scenario.leeway, shown.specimen);
  shown.feed = std::make_unique<PatchFeed>(shown.look->feed());
  const double from = cpu_s();
  shown.feed->build_all(*shown.volume);
  std::printf("all patches: %.0f ms of processor time\n", 1e3 * (cpu_s() - from));
  shown.context = EglContext::create(shown.size.width, shown.size.height);
  shown.picture = ToothPicture::create();
  if (!shown.context || !shown.picture) return false;
  take_patches(shown);
  shown.picture->set_scenery(shown.scenery.get());
  shown.picture->set_lines(shown.look->lines(*shown.volume));
  return true;
}

/// Cuts the target layer by layer, as a bur does, and prints what the patches cost.
void cut(Shown& shown) {
  const TargetShape& target = shown.look->shape();
  constexpr double kFarMm = 0.5;  // beyond it only the sign counts
  const double top = std::max(target.top_mm(), shown.store.bounds()->high.z);
  std::size_t patches = 0;
  double seconds = 0.0, most = 0.0;
  for (int layer = 1; layer <= kLayers; ++layer) {
    const double z = top + (target.floor_mm() - top) * layer / kLayers;
    carved::carve(*shown.volume, [&](Vec3 p) {
      const double out = std::max({z - p.z, target.low().x - p.x, target.low().y - p.y, p.x - target.high().x, p.y - target.high().y});
      return out > kFarMm ? out : std::max(target.distance_mm(p), z - p.z);
    });
    const auto bricks = shown.volume->cut_bricks();
    const double from = cpu_s();
    shown.feed->update(*shown.volume, bricks, static_cast<std::uint64_t>(layer));
    seconds += cpu_s() - from;
    most = std::max(most, cpu_s() - from);
    patches += take_patches(shown);
  }
  if (patches == 0) return;
  std::printf("the target cut in %d layers: %zu patches of %.0f us, at most %.1f ms a layer\n", kLayers, patches,
              1e6 * seconds / static_cast<double>(patches), 1e3 * most);
}

/// The views that are measured: target, crown, whole specimen, jaw.
std::vector<Scene3d> views_of(const Shown& shown, const Scene3d& empty) {
  std::vector<Scene3d> out(shown.scenery ? 4 : 3, empty);
  const Box box = shown.store.bounds().value_or(Box{Vec3(-5.0), Vec3(5.0)});
  for (Scene3d& scene : out) scene.camera = Camera::about(0.5 * (box.low + box.high), 0.5 * glm::length(box.high - box.low));
  if (!shown.look->empty()) {
    const auto& target = shown.look->shape();
    const Vec3 middle(0.5 * (target.low() + target.high()), target.top_mm());
    out[0].camera = Camera::about(middle, 3.5);
    out[1].camera = Camera::about(middle, 6.5);
  }
  if (shown.scenery) out[3].camera = Camera::about(0.5 * (shown.scenery->bounds().low + shown.scenery->bounds().high), 36.0);
  return out;
}

void print_frames(const Shown& shown, const char* what, const Scene3d& from) {
  shown.picture->set_scenery(nullptr);
  const Frames bare = measure(shown, from);
  shown.picture->set_scenery(shown.scenery.get());
  const Frames with = measure(shown, from);
  std::printf("%s: %.1f ms of processor time a frame without scenery (%zu triangles), %.1f ms with it (%zu), %.1f ms by the clock\n",
              what, bare.cpu_ms, bare.stats.triangles, with.cpu_ms, with.stats.triangles, with.wall_ms);
}

void print_all_frames(const Shown& shown, const std::vector<Scene3d>& views) {
  constexpr std::array kNames = {"  at the target", "  the crown", "  the whole specimen", "  the whole jaw"};
  for (std::size_t i = 0; i < views.size(); ++i) print_frames(shown, kNames[i], views[i]);
}

/// What a frame at the target is spent on: each part as the difference to a frame without it, and the same at smaller sizes.
void print_split(Shown& shown, Scene3d scene) {
  scene.bur = BurPose{.bur = Bur{}, .pivot_mm = scene.camera.centre_mm()};
  scene.show_handpiece = true;
  const Size whole = shown.size;
  for (const double share : {1.0, 0.85, 0.7, 0.6, 0.5, 0.02}) {
    shown.size = {static_cast<int>(share * whole.width), static_cast<int>(share * whole.height)};
    const double all = measure(shown, scene).cpu_ms;
    Scene3d less = scene;
    less.show_handpiece = false;
    const double no_handpiece = measure(shown, less).cpu_ms;
    less.show_target = false;
    const double no_lines = measure(shown, less).cpu_ms;
    less.bur.reset();
    const double no_bur = measure(shown, less).cpu_ms;
    less.camera.set_centre(scene.camera.centre_mm() + Vec3(0.0, 0.0, 1e3));
    const double background = measure(shown, less).cpu_ms;
    std::printf("  %.2f of each side: %.1f ms; handpiece %.1f, lines %.1f, bur %.1f, tooth %.1f, background %.1f\n", share, all,
                all - no_handpiece, no_handpiece - no_lines, no_lines - no_bur, no_bur - background, background);
  }
  shown.size = whole;
}

/// "name.png" becomes "name-WHAT.png".
std::string named(std::string path, const std::string& what) { return path.insert(path.size() - 4, "-" + what); }

/// Each view, then the target's with its lines and as a difference map, then a section through its middle.
bool write_views(const Shown& shown, std::vector<Scene3d> views, const std::string& path, const std::string& state) {
  Scene3d lines = views[0], map = views[0];
  map.colouring = Colouring::deviation;
  for (Scene3d& scene : views) scene.show_target = false;
  views.push_back(lines);
  views.push_back(map);
  for (std::size_t i = 0; i < views.size(); ++i) {
    shown.picture->draw(views[i], shown.size.width, shown.size.height);
    if (!write_png(named(path, state + std::to_string(i + 1)), shown.size.width, shown.size.height, shown.context->read_rgba())) return false;
  }
  SectionSettings settings;
  settings.plane.centre_mm = views[0].camera.centre_mm();
  settings.width = 542, settings.height = 404, settings.mm_per_px = 0.0225;
  shown.look->put_into(settings);
  const SectionImage section = draw_section(*shown.volume, settings);
  std::vector<std::uint8_t> rgba(section.rgba.size() * 4);
  std::memcpy(rgba.data(), section.rgba.data(), rgba.size());
  return write_png(named(path, state + "-section"), section.width, section.height, rgba);
}

Colour hex(const char* text) { return colour_of(static_cast<std::uint32_t>(std::strtoul(text, nullptr, 16))); }

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
  if (argc > 4) shown.size = {std::atoi(argv[3]), std::atoi(argv[4])};
  if (!show(*scenario, shown)) return 1;
  Scene3d empty;
  if (argc > 6) empty.background_middle = hex(argv[5]), empty.background_edge = hex(argv[6]);
  const std::vector<Scene3d> views = views_of(shown, empty);
  shown.picture->draw(views[2], shown.size.width, shown.size.height);
  glFinish();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const long kb = peak_kb();
  std::printf("%s: first picture after %.1f s (%.1f s of processor time), at most %ld MB resident\n", argv[1], seconds,
              cpu_s() - cpu, kb / 1024);
  std::printf("kept: %.1f MB of bricks, %.1f MB of scenery in %zu patches, %zu triangles of the specimen\n",
              static_cast<double>(shown.specimen->bytes()) / 1e6, shown.scenery ? static_cast<double>(shown.scenery->bytes()) / 1e6 : 0.0,
              shown.scenery ? shown.scenery->patches().size() : 0, shown.store.triangles());
  std::printf("whole:\n");
  print_all_frames(shown, views);
  if (argc > 2 && !write_views(shown, views, argv[2], "whole")) return 1;
  if (!shown.look->empty()) {
    cut(shown);
    print_all_frames(shown, views);
    print_split(shown, views[0]);
    if (argc > 2 && !write_views(shown, views, argv[2], "cut")) return 1;
  }
  return seconds < kMostSeconds && kb < kMostKb ? 0 : 1;
}
