// One libFuzzer program for each reader: CUSP_FUZZ_READER names it.
#include "tests/fuzz/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cusp::fuzz::CUSP_FUZZ_READER({data, size});
  return 0;
}
