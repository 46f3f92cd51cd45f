// Writes a school of two thousand students and many sessions to a new database, for pictures and by hand:
//   cusp-grow-school DB SESSIONS
// Administrator "admin" signs in with "correct horse", instructor "okafor" with "battery staple", student 20260000 with the PIN 314159.

#include <cstdio>
#include <cstdlib>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/storage/many_sessions.h"

namespace cusp::test {
namespace {

/// The last of the library: teeth, after the blocks.
std::vector<PublishedExercise> teeth() {
  std::vector<PublishedExercise> out;
  const auto keys = builtin_scenarios();
  for (std::size_t i = keys.size() - ManySessions::kExercises; i < keys.size(); ++i) {
    Scenario scenario = load_builtin(keys[i]).value();
    std::string json = canonical_json(scenario);
    const Hash256 content = content_hash(scenario).bytes;
    out.push_back({std::move(scenario), std::move(json), content});
  }
  return out;
}

int grow(const char* file, int sessions) {
  StoreOptions options;
  options.cost = PasswordCost::least();
  options.clock = [] { return kNow; };
  const auto store = must(Store::open(file, options));
  const ManySessions m = write_many(*store, sessions, CopiedRows::all, teeth());
  must(store->accounts.set_pin(m.admin.actor(), m.students.front().id, "314159"));
  std::printf("%d sessions of %zu students\n", m.listed, m.students.size());
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace cusp::test

int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  return cusp::test::grow(argv[1], std::atoi(argv[2]));
}
