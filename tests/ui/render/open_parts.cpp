// cusp-open-parts SCENARIO...: what opening an attempt is made of, one part after the other, and what reading the specimen from a file
// instead would take: seconds by the clock, and of processor time. SCENARIO: a file, or the id of a built-in exercise.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>

#include "scenarios/metrics/reference.h"
#include "scenarios/specimens/specimens.h"
#include "storage/base/hash.h"
#include "storage/records/trace_codec.h"
#include "tests/modules.h"
#include "tests/ui/render/exercise_file.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/patch_feed.h"
#include "ui/render/scenery_look.h"
#include "ui/render/target_look.h"
#include "ui/render/tooth_picture.h"
#include "ui/session/scene_builder.h"
#include "ui/session/specimen_blob.h"

using namespace cusp;
using namespace cusp::test;

namespace {

template <class Work>
auto timed(const char* part, Work work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  auto out = work();
  std::printf("  %-34s %6.2f (%5.2f)\n", part, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
              static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC);
  return out;
}

bool print_parts(const std::string& name) {
  const auto scenario = scenario_of(name);
  if (!scenario) return false;
  std::printf("%s\n", name.c_str());
  const auto dense = timed("grow the specimen", [&] { return make_specimen(scenario->specimen, {}); });
  if (!dense) return false;
  const auto specimen = timed("its bricks and surface", [&] { return Specimen::build(*dense, reading_of(scenario->method)); });
  const auto grown = timed("grow the scenery", [&] { return make_scenery(scenario->specimen); });
  if (!grown) return false;
  const auto scenery = timed("the scenery's patches", [&] {
    std::vector<SceneryMesh> meshes;
    for (const JawSurface& one : *grown) meshes.push_back(one.mesh);
    return SceneryLook(std::move(meshes));
  });
  const TargetLook look(scenario->target, scenario->leeway, specimen);
  const Volume volume(specimen);
  PatchFeed feed(look.feed());
  timed("the mesh", [&] { return feed.build_all(volume), 0; });
  const auto lines = timed("lines of the target", [&] { return look.lines(volume); });
  timed("reference of the grade", [&] { return Reference(*scenario, specimen), 0; });
  const auto blob = timed("the specimen as bytes", [&] { return specimen_bytes(specimen->dense()); });
  const auto packed = timed("packed", [&] { return cusp::storage::pack(blob); });
  timed("unpacked", [&] { return cusp::storage::unpack(packed)->size(); });
  timed("read from bytes", [&] { return specimen_from_bytes(blob)->s.size(); });
  timed("hashed", [&] { return cusp::storage::blake2b_256(blob); });
  const auto context = EglContext::create(1280, 800);
  if (!context) return false;
  const auto picture = timed("OpenGL", [&] { return ToothPicture::create(); });
  if (!picture) return false;
  timed("first picture", [&] {
    for (const BakedPatch& patch : feed.take(~std::size_t{0}).patches) picture->put(patch);
    picture->set_scenery(&scenery);
    picture->set_lines(lines);
    picture->draw(Scene3d{}, 1280, 800);
    return context->read_rgba().size();
  });
  std::printf("  %zu voxels, %.1f MB as bytes, %.1f MB of scenery\n", dense->s.size(), static_cast<double>(blob.size()) / 1e6,
              static_cast<double>(scenery.bytes()) / 1e6);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::printf("part, s by the clock (of processor time)\n");
  for (int i = 1; i < argc; ++i)
    if (!print_parts(argv[i])) return 1;
  return argc > 1 ? 0 : 2;
}
