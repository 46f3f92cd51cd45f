// The same bits on every build and CPU: an exploration and a drilling whose inputs are integers, hashed. The constant
// was made by g++ 12 -O2 on x86-64; the release and ASan/UBSan builds in ./check must come to it.
// A change of the step that changes it raises kEngineVersion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <vector>

#include "engine/step/step.h"
#include "engine/tool/heads.h"
#include "engine/volume/hash.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// Triangle wave in integers: -amplitude to amplitude over `period` ticks.
int wave(int k, int period, int amplitude) {
  const int t = k % period;
  const int up = t * 2 < period ? t * 2 : period * 2 - t * 2;
  return amplitude * (2 * up - period) / period;
}

std::vector<Bur> balls() { return {Bur{"1", 0.4, 0.24, 4.0, 0.8, 12.0}, Bur{"1/4", 0.25, 0.15, 4.0, 0.8, 12.0}}; }
/// A straight fissure and a pear.
std::vector<Bur> heads() {
  return {Bur{"57", 0.5, 0.3, 6.0, 0.8, 12.0, *flat_head(0.5, 0.5, 3.0)}, Bur{"330", 0.4, 0.24, 4.0, 0.8, 12.0, *pear_head(0.4, 0.2, 0.3, 1.6)}};
}

std::shared_ptr<const Scene> scene_of(Method method, const std::vector<Bur>& burs) {
  // A ball of dentine under a slab of enamel: only + - * / and sqrt make it.
  Grid grid{IVec3(40), 0.1, Vec3(-1.95)};
  VoxelVolume volume(grid);
  IVec3 v;
  for (v.z = 0; v.z < 40; ++v.z)
    for (v.y = 0; v.y < 40; ++v.y)
      for (v.x = 0; v.x < 40; ++v.x) {
        const Vec3 p = grid.centre_mm(v);
        const double d = std::sqrt(glm::dot(p, p)) - 1.5;
        volume.s[grid.index(v)] = solid_from_distance(d / 0.1);
        if (volume.s[grid.index(v)] > 0) volume.tissue[grid.index(v)] = p.z > 1.0 ? Tissue::enamel : Tissue::dentine;
      }
  auto scene = std::make_shared<Scene>();
  scene->specimen = Specimen::build(volume, reading_of(method));
  scene->method = method;
  scene->burs = burs;
  scene->tissues[index_of(Tissue::enamel)] = {2.0, 1.5};
  scene->tissues[index_of(Tissue::dentine)] = {1.0, 3.0};
  scene->friction = true;
  return scene;
}

/// Three hashes, to see what a change affects: outputs, volume or state alone.
struct Golden {
  std::uint64_t poses_and_forces = 0;  // of every tick
  std::uint64_t volume = 0, state = 0;
  friend bool operator==(const Golden&, const Golden&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Golden& g) {
    return out << "{" << g.poses_and_forces << "ull, " << g.volume << "ull, " << g.state << "ull}";
  }
};

enum class Task : std::uint8_t { exploring, drilling };

Golden run(Method method, Task task, const std::vector<Bur>& burs = balls()) {
  StepState state(scene_of(method, burs));
  Hash64 hash;
  for (int k = 0; k < 2500; ++k) {
    StepInput input;
    input.x = wave(k, 900, 6000);
    input.y = wave(k, 610, 5000);
    input.z = 21000 - 4 * k;
    if (input.z < 14000) input.z = 14000 + wave(k, 400, 1500);
    input.z += std::max(0, 120 * (100 - std::abs(k - 1500)));  // the bur is changed in the air
    input.buttons = task == Task::drilling && k % 500 > 60 ? StepInput::kCut : std::uint16_t{0};
    input.bur = k < 1500 ? 0 : 1;
    const StepOutput out = step(state, input);
    for (int i = 0; i < 3; ++i) {
      hash.add_double(out.proxy_mm[i]);
      hash.add_double(out.force_n[i]);
    }
  }
  return {hash.value(), state.volume().hash(), state.hash()};
}

TEST(GoldenHash, exploring_with_the_surface_proxy) {
  EXPECT_EQ(run(Method::surface, Task::exploring),
            (Golden{5231725318764714840ull, 11804965707866407605ull, 4969871864714017831ull}));
}
TEST(GoldenHash, drilling_with_the_surface_proxy) {
  EXPECT_EQ(run(Method::surface, Task::drilling),
            (Golden{17130333414862704380ull, 11089140791038418623ull, 12766963385979560698ull}));
}
TEST(GoldenHash, drilling_with_a_fissure_and_a_pear) {
  EXPECT_EQ(run(Method::surface, Task::drilling, heads()),
            (Golden{1270556234900753192ull, 7632272937417336016ull, 8624097352867375977ull}));
}
TEST(GoldenHash, drilling_with_the_papers_proxy) {
  EXPECT_EQ(run(Method::occupancy, Task::drilling),
            (Golden{11611298795140839205ull, 15706819921514603496ull, 9086824833464216981ull}));
}
TEST(GoldenHash, drilling_with_the_ray_proxy) {
  EXPECT_EQ(run(Method::ray, Task::drilling),
            (Golden{14207350624821002406ull, 15673717644847552070ull, 10639647387083014121ull}));
}
TEST(GoldenHash, drilling_with_the_penalty) {
  EXPECT_EQ(run(Method::penalty, Task::drilling),
            (Golden{15490376857508342558ull, 18316227448196263079ull, 16342622618324642361ull}));
}
TEST(GoldenHash, drilling_with_the_gradient_proxy) {
  EXPECT_EQ(run(Method::gradient, Task::drilling),
            (Golden{17717658991813566686ull, 8493588897491379370ull, 466642735663600563ull}));
}

}  // namespace
}  // namespace cusp::test
