/// cusp-library-text: the keys of the library, one a line. cusp-library-text KEY: the scenario.json of that exercise, for
/// scripts (scenarios/audit/table.py). Exit 1: no such key.

#include <cstdio>

#include "scenarios/library/library.h"
#include "tests/modules.h"

int main(int argc, char** argv) {
  using namespace cusp::scenarios;
  if (argc < 2) {
    for (const std::string_view key : builtin_scenarios()) std::printf("%.*s\n", static_cast<int>(key.size()), key.data());
    return 0;
  }
  const std::string_view text = builtin_scenario_text(argv[1]);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return text.empty() ? 1 : 0;
}
