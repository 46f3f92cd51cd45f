// A scene's ticks, to be counted by valgrind: `lean METHOD [TICKS] [PHENOMENON]`. This program is built twice, the second
// time from a step that lacks the phenomena (without.cmake). Prints the heap that making the state took and what the ticks
// took; what the ticks themselves cost is between the beginning and the end of run_ticks().
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace {

std::size_t blocks = 0, bytes = 0;

void* counted(std::size_t size) {
  ++blocks;
  bytes += size;
  if (void* at = std::malloc(size)) return at;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* at) noexcept { std::free(at); }
void operator delete[](void* at) noexcept { std::free(at); }
void operator delete(void* at, std::size_t) noexcept { std::free(at); }
void operator delete[](void* at, std::size_t) noexcept { std::free(at); }

namespace cusp::test {

__attribute__((noinline)) double run_ticks(StepState& state, const std::vector<StepInput>& inputs) {
  double sum = 0.0;
  for (const StepInput& input : inputs) sum += step(state, input).force_n.z;
  return sum;
}

}  // namespace cusp::test

int main(int argc, char** argv) {
  using namespace cusp::test;
  const Method method = argc > 1 && !std::strcmp(argv[1], "occupancy") ? Method::occupancy : Method::surface;
  const std::size_t ticks = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 3000;
  auto scene = std::const_pointer_cast<Scene>(test::block_scene(method));
  if (argc > 3 && !std::strcmp(argv[3], "all")) {
    scene->phenomena.handpiece = Handpiece::electric;
    scene->phenomena.vibration = scene->phenomena.heat = true;
    scene->friction = true;
  }
  std::vector<StepInput> inputs;
  StepInput last;
  for (std::size_t i = 0; i < ticks; ++i) inputs.push_back(last = quantise(test::drilling_sample(i), 1000, last));
  blocks = bytes = 0;
  StepState state(scene);
  const std::size_t made_blocks = blocks, made_bytes = bytes;
  blocks = bytes = 0;
  const double sum = run_ticks(state, inputs);
  std::printf("state %zu blocks %zu bytes; %zu ticks %zu blocks; hash %016llx sum %.6f\n", made_blocks, made_bytes, ticks,
              blocks, static_cast<unsigned long long>(state.hash()), sum);
  return 0;
}
