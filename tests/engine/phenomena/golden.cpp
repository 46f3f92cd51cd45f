// The same bits on every build and CPU with every phenomenon on: integers in, hashed. Beside tests/determinism, which
// holds the scenes that ask for none: what changes those hashes changes these. The constants were made by g++ 12 -O2 on x86-64.
#include <gtest/gtest.h>

#include <ostream>

#include "engine/volume/hash.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// As in tests/determinism; answers: poses, forces and what phenomena show, of every tick.
struct Golden {
  std::uint64_t answers = 0, volume = 0, state = 0;
  friend bool operator==(const Golden&, const Golden&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Golden& g) {
    return out << "{" << g.answers << "ull, " << g.volume << "ull, " << g.state << "ull}";
  }
};

Golden run(Method method, Handpiece handpiece) {
  // A ball of dentine under a slab of enamel: only + - * / and sqrt make it.
  auto scene = test::scene_of(test::from_distance(3.2, 0.1, [](Vec3 p) { return test::length(p) - 1.5; },
                                                  [](Vec3 p) { return p.z > 1.0 ? Tissue::enamel : Tissue::dentine; }),
                              method, 0.4);
  scene->tissues[index_of(Tissue::enamel)] = {2.0, 1.5};
  scene->tissues[index_of(Tissue::dentine)] = {1.0, 3.0};
  scene->full_force_n = 1.5;
  scene->friction = true;
  scene->guard = GuardSettings{};
  scene->tool_axis = Vec3(0.6, 0.0, 0.8);
  scene->phenomena = {handpiece, true, true};
  StepState state(scene);
  Hash64 hash;
  for (int k = 0; k < 2500; ++k) {
    StepInput input;
    input.x = (k % 800 < 400 ? k % 400 : 400 - k % 400) * 25 - 5000;
    input.y = (k % 600 < 300 ? k % 300 : 300 - k % 300) * 20 - 3000;
    input.z = 21000 - 4 * k;
    if (input.z < 13000) input.z = 13000;
    input.pedal = static_cast<std::uint16_t>(k % 900 < 700 ? 30000 + 50 * (k % 700) : 0);
    input.buttons = k % 700 > 450 ? StepInput::kCoolant : std::uint16_t{0};
    const StepOutput out = step(state, input);
    for (int i = 0; i < 3; ++i) {
      hash.add_double(out.proxy_mm[i]);
      hash.add_double(out.force_n[i]);
    }
    hash.add_double(out.spindle_rpm);
    hash.add_double(out.heat_k);
    hash.add(out.phenomena);
  }
  EXPECT_FALSE(state.volume().cut_bricks().empty());
  return {hash.value(), state.volume().hash(), state.hash()};
}

TEST(GoldenHash, drilling_with_every_phenomenon_on_by_the_surface_proxy) {
  EXPECT_EQ(run(Method::surface, Handpiece::turbine), (Golden{12292283799281941455ull, 1477052488273179049ull, 6872143770722649920ull}));
}
TEST(GoldenHash, drilling_with_every_phenomenon_on_by_the_papers_proxy) {
  EXPECT_EQ(run(Method::occupancy, Handpiece::slow), (Golden{12214965102902366071ull, 2460960802914835284ull, 12754328309123743896ull}));
}

}  // namespace
}  // namespace cusp::test
