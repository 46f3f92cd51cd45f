#include "scenarios/operators/layer.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

namespace cusp::scenarios {

namespace {
/// An end of a row, or a point of an edge, is as exact.
constexpr double kEdgeMm = 1e-3;
/// Lines that turn by less make no corner.
constexpr double kCornerSine = 0.3;
constexpr std::size_t kNoNode = ~std::size_t{0};
}  // namespace

Layer::Layer(const Poses& poses, const PlanGrid& grid, double z_mm, std::vector<char>& open, std::vector<char> worth)
    : poses_(&poses), grid_(grid), z_(z_mm), out_(grid.size(), 1.0f), worth_(std::move(worth)) {
  for (std::size_t node = 0; node < grid.size(); ++node) {
    const Vec3 pivot(grid.at(node), z_mm);
    const double beside = poses.beside_mm(pivot);
    if (beside > 0.0 && !open[node]) continue;
    const double blocked = poses.blocked_mm(pivot);
    if (blocked > 0.0) open[node] = 0;
    out_[node] = static_cast<float>(std::max(beside, blocked));
  }
  for (std::size_t node = 0; node < grid.size(); ++node)
    if (out_[node] > 0.0f) worth_[node] = 0;
}

bool Layer::idle() const noexcept {
  return std::ranges::none_of(worth_, [](char one) { return one != 0; });
}

Vec2 Layer::edge_point(Vec2 inside, Vec2 outside) const noexcept {
  const double length = glm::length(inside - outside);
  const Vec2 way = (inside - outside) / length;
  // No pose nearer than `out` is allowed.
  for (double gone = 0.0; gone < length;) {
    const Vec2 p = outside + gone * way;
    const double out = out_at(p);
    if (out <= 0.0) return p;
    gone += std::max(out, kEdgeMm);
  }
  return inside;
}

void Layer::add_runs(int j, std::vector<PoseLine>& out) const {
  const auto node = [&](int i) { return grid_.index(i, j); };
  for (int i = 0; i < grid_.nx; ++i) {
    if (!allowed(node(i))) continue;
    int last = i;
    while (last + 1 < grid_.nx && allowed(node(last + 1))) ++last;
    int first_worth = i, last_worth = last;
    while (first_worth <= last && !worth_[node(first_worth)]) ++first_worth;
    while (last_worth >= i && !worth_[node(last_worth)]) --last_worth;
    if (first_worth <= last_worth) {
      PoseLine run{{grid_.at(node(first_worth)), grid_.at(node(last_worth))}, node(first_worth), node(last_worth)};
      if (first_worth == i && i > 0) run.points.front() = edge_point(run.points.front(), grid_.at(node(i - 1)));
      if (last_worth == last && last + 1 < grid_.nx) run.points.back() = edge_point(run.points.back(), grid_.at(node(last + 1)));
      out.push_back(std::move(run));
    }
    i = last;
  }
}

std::vector<PoseLine> Layer::rows(int every) const {
  int first = grid_.ny, last = -1;
  for (std::size_t node = 0; node < worth_.size(); ++node) {
    if (!worth_[node]) continue;
    first = std::min(first, grid_.row(node));
    last = std::max(last, grid_.row(node));
  }
  std::vector<PoseLine> out;
  for (int j = first; j <= last; ++j)
    if ((j - first) % every == 0 || j == last) add_runs(j, out);
  return out;
}

namespace {

/// Crossings of an area's edge with the lines between nodes, and how they follow one another.
struct EdgeGraph {
  struct Crossing {
    Vec2 at{0.0};
    std::size_t node = kNoNode;  // the allowed one
    std::vector<int> next;
    bool used = false;
  };
  std::vector<Crossing> crossings;

  PoseLine follow(int start) {
    PoseLine line;
    line.first_node = crossings[static_cast<std::size_t>(start)].node;
    bool closes = false;
    for (int at = start; at >= 0;) {
      Crossing& here = crossings[static_cast<std::size_t>(at)];
      here.used = true;
      line.points.push_back(here.at);
      line.last_node = here.node;
      int onward = -1;
      for (const int next : here.next) {
        if (next == start && line.points.size() > 2) closes = true;
        if (!crossings[static_cast<std::size_t>(next)].used) onward = next;
      }
      at = onward;
    }
    if (closes) {
      line.points.push_back(crossings[static_cast<std::size_t>(start)].at);
      line.last_node = line.first_node;
    }
    return line;
  }
};

}  // namespace

/// Crossings cut off a corner of the area between two nodes: puts it back where it is allowed.
void Layer::sharpen(PoseLine& line) const {
  const auto cross = [](Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; };
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    out.push_back(line.points[i]);
    if (i < 1 || i + 2 >= line.points.size()) continue;
    const Vec2 a = line.points[i], b = line.points[i + 1], before = a - line.points[i - 1], after = line.points[i + 2] - b;
    const double turn = cross(before, after), sine = turn / std::max(1e-12, glm::length(before) * glm::length(after));
    if (std::fabs(sine) < kCornerSine) continue;
    const double along = cross(b - a, after) / turn, back = cross(b - a, before) / turn;
    const Vec2 corner = a + along * before;
    const bool onward = along > 0.0 && back < 0.0 && glm::length(corner - a) < 2.0 * grid_.step_mm;
    if (onward && out_at(corner) <= 0.0) out.push_back(corner);
  }
  line.points = std::move(out);
}

std::vector<PoseLine> Layer::edges() const {
  EdgeGraph graph;
  std::map<std::pair<std::size_t, std::size_t>, int> known;
  // The crossing between two neighbouring nodes, one of them allowed; -1 where no work is.
  const auto crossing = [&](std::size_t a, std::size_t b) {
    const auto [it, fresh] = known.try_emplace({std::min(a, b), std::max(a, b)}, -1);
    if (!fresh) return it->second;
    const std::size_t inside = allowed(a) ? a : b, outside = allowed(a) ? b : a;
    if (!worth_[inside]) return -1;
    it->second = static_cast<int>(graph.crossings.size());
    graph.crossings.push_back({edge_point(grid_.at(inside), grid_.at(outside)), inside, {}, false});
    return it->second;
  };
  const auto join = [&](int a, int b) {
    if (a < 0 || b < 0) return;
    graph.crossings[static_cast<std::size_t>(a)].next.push_back(b);
    graph.crossings[static_cast<std::size_t>(b)].next.push_back(a);
  };
  for (int j = 0; j + 1 < grid_.ny; ++j)
    for (int i = 0; i + 1 < grid_.nx; ++i) {
      const std::array<std::size_t, 4> corner = {grid_.index(i, j), grid_.index(i + 1, j), grid_.index(i + 1, j + 1),
                                                 grid_.index(i, j + 1)};
      std::vector<int> on;
      for (std::size_t c = 0; c < 4; ++c)
        if (allowed(corner[c]) != allowed(corner[(c + 1) % 4])) on.push_back(crossing(corner[c], corner[(c + 1) % 4]));
      if (on.size() == 2) join(on[0], on[1]);
      // Two allowed corners across: each has an edge of its own.
      if (on.size() == 4) {
        const std::size_t turn = allowed(corner[0]) ? 3 : 0;
        join(on[turn], on[(turn + 1) % 4]);
        join(on[(turn + 2) % 4], on[(turn + 3) % 4]);
      }
    }
  std::vector<PoseLine> out;
  // Open lines from their ends first, then the loops.
  for (const bool loops : {false, true})
    for (std::size_t i = 0; i < graph.crossings.size(); ++i)
      if (!graph.crossings[i].used && (loops || graph.crossings[i].next.size() < 2)) out.push_back(graph.follow(static_cast<int>(i)));
  for (PoseLine& line : out) sharpen(line);
  return out;
}

std::vector<int> Layer::areas() const {
  std::vector<int> area(grid_.size(), 0);
  int count = 0;
  for (std::size_t seed = 0; seed < grid_.size(); ++seed) {
    if (!allowed(seed) || area[seed] != 0) continue;
    ++count;
    std::deque<std::size_t> waiting{seed};
    area[seed] = count;
    while (!waiting.empty()) {
      const std::size_t node = waiting.front();
      waiting.pop_front();
      grid_.each_beside(node, [&](std::size_t next) {
        if (!allowed(next) || area[next] != 0) return;
        area[next] = count;
        waiting.push_back(next);
      });
    }
  }
  return area;
}

bool Layer::straight(std::size_t a, std::size_t b) const noexcept {
  const Vec2 from(grid_.column(a), grid_.row(a)), way = Vec2(grid_.column(b), grid_.row(b)) - from;
  const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * glm::length(way))));
  for (int k = 0; k <= steps; ++k) {
    const Vec2 p = from + way * (static_cast<double>(k) / steps);
    const int i = static_cast<int>(std::floor(p.x)), j = static_cast<int>(std::floor(p.y));
    for (int c = 0; c < 4; ++c) {
      const int x = i + (c & 1), y = j + (c >> 1);
      // A corner of the cell counts if the place is nearer to it than a cell along both axes.
      if (std::fabs(p.x - x) >= 1.0 || std::fabs(p.y - y) >= 1.0) continue;
      if (x >= grid_.nx || y >= grid_.ny || !allowed(grid_.index(x, y))) return false;
    }
  }
  return true;
}

std::vector<std::size_t> Layer::way(std::size_t from, std::size_t to) const {
  if (straight(from, to)) return {to};
  std::vector<std::size_t> before(grid_.size(), kNoNode);
  std::deque<std::size_t> waiting{from};
  before[from] = from;
  while (!waiting.empty() && before[to] == kNoNode) {
    const std::size_t node = waiting.front();
    waiting.pop_front();
    grid_.each_beside(node, [&](std::size_t next) {
      if (!allowed(next) || before[next] != kNoNode) return;
      before[next] = node;
      waiting.push_back(next);
    });
  }
  if (before[to] == kNoNode) return {};
  std::vector<std::size_t> whole{to};
  while (whole.back() != from) whole.push_back(before[whole.back()]);
  std::ranges::reverse(whole);
  // From bend to bend, each as far as a straight line leads.
  std::vector<std::size_t> out;
  for (std::size_t at = 0; at + 1 < whole.size();) {
    std::size_t next = at + 1;
    while (next + 1 < whole.size() && straight(whole[at], whole[next + 1])) ++next;
    out.push_back(whole[next]);
    at = next;
  }
  return out;
}

}  // namespace cusp::scenarios
