#include "tests/engine/random/random_shards.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace cusp::test {

namespace {

template <class Visit>
void each(auto& counts, Visit&& visit) {
  for (auto* member : {&counts.ticks, &counts.contacts, &counts.faults, &counts.cutting, &counts.cut_bricks,
                       &counts.infeasible, &counts.deferred, &counts.stalled, &counts.overheated})
    visit(*member);
}

/// Writes the engine's name into a folder that is still empty. The name of the one that the folder is of, where that is
/// another.
std::string claim(const std::filesystem::path& folder, const std::string& engine) {
  const auto file = folder / "engine.txt";
  if (!std::filesystem::exists(file)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".txt" && entry.path() != file) return "an unnamed engine";
    // Whole at once, for programs that begin together.
    const auto own = folder / ("engine." + std::to_string(std::random_device{}()));
    std::ofstream(own) << engine << '\n';
    std::filesystem::rename(own, file);
  }
  std::string of;
  std::ifstream in(file);
  std::getline(in, of);
  return of == engine ? "" : of.empty() ? "an unnamed engine" : of;
}

}  // namespace

Counts& Counts::operator+=(const Counts& other) {
  ticks += other.ticks;
  contacts += other.contacts;
  faults += other.faults;
  cutting += other.cutting;
  cut_bricks += other.cut_bricks;
  infeasible += other.infeasible;
  deferred += other.deferred;
  stalled += other.stalled;
  overheated += other.overheated;
  return *this;
}

std::optional<Seeds> shard_of(Seeds all, std::string_view shard) {
  std::uint64_t which = 0, shards = 0;
  const char* end = shard.data() + shard.size();
  const auto [slash, bad] = std::from_chars(shard.data(), end, which);
  if (bad != std::errc{} || slash == end || *slash != '/') return std::nullopt;
  const auto [rest, worse] = std::from_chars(slash + 1, end, shards);
  if (worse != std::errc{} || rest != end || which < 1 || which > shards || shards > 1'000'000) return std::nullopt;
  return Seeds{all.first + all.count() * (which - 1) / shards, all.first + all.count() * which / shards - 1};
}

Done::Done(const std::string& folder, std::string_view method, const std::string& engine) {
  if (folder.empty()) return;
  std::filesystem::create_directories(folder);
  other_engine_ = claim(folder, engine);
  if (!other_engine_.empty()) return;
  path_ = folder + "/" + std::string(method) + ".txt";
  std::ifstream in(path_);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    Line one{};
    words >> one.seed;
    each(one.counts, [&](std::uint64_t& n) { words >> n; });
    // A line that a stopped program has left half lacks its full stop.
    std::string stop;
    if (words >> stop && stop == "." && !has(one.seed)) lines_.push_back(one);
  }
}

bool Done::has(std::uint64_t seed) const {
  return std::ranges::any_of(lines_, [seed](const Line& line) { return line.seed == seed; });
}

void Done::add(std::uint64_t seed, const Counts& counts) {
  if (!has(seed)) lines_.push_back({seed, counts});
  if (path_.empty()) return;
  std::string line = std::to_string(seed);
  each(counts, [&](const std::uint64_t& n) { line += ' ' + std::to_string(n); });
  // One write, at the end of the file: of several programs no line ends within another's. The break before it ends a
  // line that was left half.
  std::ofstream(path_, std::ios::app) << ('\n' + line + " .\n") << std::flush;
}

Counts Done::sum(Seeds of) const {
  Counts out;
  for (const Line& line : lines_)
    if (line.seed >= of.first && line.seed <= of.last) out += line.counts;
  return out;
}

std::uint64_t Done::count(Seeds of) const {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(lines_, [of](const Line& line) { return line.seed >= of.first && line.seed <= of.last; }));
}

}  // namespace cusp::test
