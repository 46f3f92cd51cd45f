#include "engine/base/fp_guard.h"
#include "tests/bench/program.h"

int main(int argc, char** argv) {
  const cusp::FpGuard fp;
  return cusp::bench::run_program({argv + 1, argv + argc});
}
