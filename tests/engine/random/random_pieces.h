/// The full form of the random ticks in pieces that run apart and go on where they were stopped: which seeds a piece has,
/// and what those that are done came to. README.md beside this says what the environment may ask for.
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

/// "3/8" is the third of eight equal runs of seeds; nothing where that is no such thing.
std::optional<Seeds> piece_of(Seeds all, std::string_view piece);

/// Seeds that are done, in a file of the method's own in a folder: a line for each, written when it has passed. Several
/// programs may add to it. Without a folder nothing is kept. A folder is of one engine, whose name stands in its
/// engine.txt: what another one has passed says nothing of this one.
class Done {
 public:
  /// engine: names the engine (one line), by its version and a hash of what it was built from.
  Done(const std::string& folder, std::string_view method, const std::string& engine);
  /// The engine that the folder is of where that is another; empty where it is this one, and all may go on. A folder
  /// that holds seeds and does not say of which engine is of "an unnamed engine".
  const std::string& other_engine() const { return other_engine_; }
  bool has(std::uint64_t seed) const;
  void add(std::uint64_t seed, const Counts& counts);
  /// Of the seeds of a piece that are done.
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
