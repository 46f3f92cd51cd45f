/// Shards of the full form of the random ticks, which run apart and can be resumed: the seeds of a shard, and the
/// counts of finished seeds. README.md lists the environment's variables.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cusp::test {

inline constexpr int kTicksOfASeed = 20'000;

struct Counts {
  std::uint64_t ticks = 0, contacts = 0, faults = 0, cutting = 0, cut_bricks = 0, infeasible = 0, deferred = 0;
  std::uint64_t stalled = 0, overheated = 0;
  Counts& operator+=(const Counts& other);
};

/// Seeds first to last, both of them; none where last < first.
struct Seeds {
  std::uint64_t first = 1, last = 0;
  std::uint64_t count() const { return last < first ? 0 : last - first + 1; }
  friend bool operator==(const Seeds&, const Seeds&) = default;
};

/// "3/8" is the third of eight equal shards; nothing for any other text.
std::optional<Seeds> shard_of(Seeds all, std::string_view shard);

/// Finished seeds, in a file for each method in a folder: one line a seed, written when it has passed. Several programs
/// may add to it. Without a folder nothing is kept. A folder belongs to one engine, which engine.txt names: the results
/// of another engine do not count.
class Done {
 public:
  /// engine: names the engine (one line), by its version and a hash of what it was built from.
  Done(const std::string& folder, std::string_view method, const std::string& engine);
  /// The folder's engine if it is another one; empty for this one. A folder with seeds and without engine.txt belongs
  /// to "an unnamed engine".
  const std::string& other_engine() const { return other_engine_; }
  bool has(std::uint64_t seed) const;
  void add(std::uint64_t seed, const Counts& counts);
  /// Of a shard's finished seeds.
  Counts sum(Seeds of) const;
  std::uint64_t count(Seeds of) const;

 private:
  struct Line {
    std::uint64_t seed;
    Counts counts;
  };
  std::string path_, other_engine_;
  std::vector<Line> lines_;
};

}  // namespace cusp::test
