#include "scenarios/operators/region_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/operators/layer.h"

namespace cusp::scenarios {

namespace {

constexpr double kGridRadii = 0.3;         // nodes of a layer
constexpr double kMostGridMm = 0.15;
constexpr double kRidgeMm = 0.012;         // that are left on a wall; the edge is followed so many times a layer
constexpr int kMostEdges = 4;
constexpr double kFloorRowRadii = 0.35;    // rows along the floor
constexpr double kRaiseMm = 5e-4;          // a lowest pose is found as exactly
constexpr double kLevelMm = 0.003;         // lowest poses within this are one level floor
constexpr double kLeastFloorMm2 = 0.05;
constexpr double kSetDownMm = 0.1;         // free way above the place where the bur begins to turn
constexpr double kNone = std::numeric_limits<double>::infinity();

/// Strokes, in as few straight lines as they are.
class Path {
 public:
  Path(Plan& plan, double above) : plan_(plan), above_(above) {}
  bool empty() const noexcept { return plan_.strokes.empty(); }
  Vec3 here() const noexcept { return plan_.strokes.back().to_mm; }
  void cut(Vec3 to) { add({to, true}); }
  /// Up, over, and down to just above `to`; then on by cutting.
  void enter(Vec3 to, double free_mm) {
    lift();
    if (empty()) plan_.start_mm = Vec3(to.x, to.y, above_);
    add({{to.x, to.y, above_}, false});
    add({{to.x, to.y, std::min(above_, to.z + free_mm)}, false});
    cut(to);
  }
  void lift() {
    if (!empty() && here().z < above_) add({{here().x, here().y, above_}, false});
  }

 private:
  void add(const Stroke& stroke) {
    std::vector<Stroke>& strokes = plan_.strokes;
    const Vec3 to = stroke.to_mm;
    if (!strokes.empty() && glm::length(to - strokes.back().to_mm) < 1e-9) return;
    if (strokes.size() > 1 && strokes.back().cut == stroke.cut) {
      const Vec3 a = strokes.back().to_mm - strokes[strokes.size() - 2].to_mm, b = to - strokes.back().to_mm;
      if (glm::dot(a, b) > 0.0 && glm::length(glm::cross(a, b)) < 1e-6 * glm::length(a) * glm::length(b)) {
        strokes.back().to_mm = to;
        return;
      }
    }
    strokes.push_back(stroke);
  }
  Plan& plan_;
  double above_;
};

class RegionPlanner {
 public:
  RegionPlanner(const Poses& poses, double above, const RegionPlanStyle& style, PlanCancel cancel)
      : specimen_(poses.specimen()), poses_(poses), style_(style), cancel_(cancel), path_(plan_, above) {
    plan_.axis = poses.axis();
  }

  Plan make() {
    lay_grid();
    find_tissue();
    if (!(top_ > -kNone)) return plan_;
    work_layers();
    keep_needed();
    work_floors();
    path_.lift();
    return is_cancelled(cancel_) ? Plan{} : plan_;
  }

 private:
  void lay_grid();
  void find_tissue();
  std::vector<char> worth_at(double z) const;
  void work_layers();
  void work_floors();
  enum class Pass : std::uint8_t { edge, rows_and_edge };
  void work(const Layer& layer, Pass pass);
  void finish_row(int j);
  void follow(const Layer& layer, const PoseLine& line, double free_mm);
  void find_lowest(std::size_t node, double blocked_z, double free_z);
  std::vector<double> level_floors() const;
  void step_to(std::size_t node);
  void keep_needed();

  const Specimen& specimen_;
  const Poses& poses_;
  RegionPlanStyle style_;
  PlanCancel cancel_;
  Plan plan_;
  Path path_;
  PlanGrid grid_;
  std::vector<double> tissue_top_;                 // of the target below a node; -kNone without any
  std::vector<double> worth_top_;                  // highest of those within the bur's radius
  std::vector<double> lowest_;                     // pose that the bur reaches from above; kNone: none, or not needed
  std::vector<char> open_;
  double top_ = -kNone;
  std::size_t at_ = 0;                             // node beside the bur
  std::vector<int> area_;                          // of the layer in work
};

void RegionPlanner::lay_grid() {
  const Vec2 low = glm::max(poses_.low(), Vec2(specimen_.grid().origin_mm.x, specimen_.grid().origin_mm.y));
  const Vec3 far = specimen_.grid().centre_mm(specimen_.grid().size - 1);
  const Vec2 high = glm::min(poses_.high(), Vec2(far.x, far.y));
  grid_.step_mm = std::min(kMostGridMm, kGridRadii * poses_.radius_mm());
  grid_.low = low - grid_.step_mm;
  grid_.nx = std::max(0, static_cast<int>(std::ceil((high.x - low.x) / grid_.step_mm))) + 3;
  grid_.ny = std::max(0, static_cast<int>(std::ceil((high.y - low.y) / grid_.step_mm))) + 3;
}

void RegionPlanner::find_tissue() {
  const Grid& voxels = specimen_.grid();
  tissue_top_.assign(grid_.size(), -kNone);
  lowest_.assign(grid_.size(), kNone);
  open_.assign(grid_.size(), 1);
  for (std::size_t node = 0; node < grid_.size(); ++node) {
    const Vec2 p = grid_.at(node);
    IVec3 v(glm::floor((Vec3(p, poses_.floor_mm()) - voxels.origin_mm) / voxels.voxel_mm + 0.5));
    for (v.z = std::max(v.z, 0); v.z < voxels.size.z; ++v.z) {
      const double z = voxels.centre_mm(v).z;
      if (specimen_.s(v) < kHalf || poses_.target_mm({p.x, p.y, z}) > 0.0) continue;
      tissue_top_[node] = z;  // of a voxel's centre: a bur that stands on the surface has nothing to do
    }
    top_ = std::max(top_, tissue_top_[node] + 0.5 * voxels.voxel_mm);
  }
  const int reach = static_cast<int>(std::ceil(poses_.spread_mm() / grid_.step_mm));
  worth_top_ = tissue_top_;
  for (std::size_t node = 0; node < grid_.size(); ++node)
    for (int dj = -reach; dj <= reach; ++dj)
      for (int di = -reach; di <= reach; ++di) {
        const int i = grid_.column(node) + di, j = grid_.row(node) + dj;
        if (i >= 0 && j >= 0 && i < grid_.nx && j < grid_.ny && di * di + dj * dj <= reach * reach)
          worth_top_[node] = std::max(worth_top_[node], tissue_top_[grid_.index(i, j)]);
      }
}

std::vector<char> RegionPlanner::worth_at(double z) const {
  std::vector<char> out(grid_.size());
  for (std::size_t node = 0; node < out.size(); ++node) out[node] = worth_top_[node] > z + poses_.low_mm();
  return out;
}

void RegionPlanner::work_layers() {
  const double height = style_.layer_radii * poses_.radius_mm();
  int edges = 1;
  while (edges < kMostEdges && poses_.ridge_mm(height / edges) > kRidgeMm) ++edges;
  const double bottom = poses_.floor_mm() + poses_.low_mm() - poses_.radius_mm();
  const double first = top_ - poses_.low_mm();
  for (int k = 1; first - height * (k - 1) / edges > bottom && !is_cancelled(cancel_); ++k) {
    const double z = first - height * k / edges;
    const std::vector<char> before = open_;
    const Layer layer(poses_, grid_, z, open_, worth_at(z));
    for (std::size_t node = 0; node < grid_.size(); ++node)
      if (before[node] && !open_[node]) find_lowest(node, z, z + height / edges);
    if (!layer.idle()) work(layer, k % edges == 0 ? Pass::rows_and_edge : Pass::edge);
  }
}

/// Between a height that the bur cannot pass and one above that it did.
void RegionPlanner::find_lowest(std::size_t node, double blocked_z, double free_z) {
  const Vec2 p = grid_.at(node);
  for (double z = blocked_z; z <= free_z + kLevelMm;) {
    const double out = poses_.out_mm({p.x, p.y, z});
    if (out <= 0.0) {
      lowest_[node] = z;
      return;
    }
    z += std::max(out, kRaiseMm);
  }
}

void RegionPlanner::work(const Layer& layer, Pass pass) {
  area_ = layer.areas();
  const int every = std::max(1, static_cast<int>(style_.row_radii * poses_.radius_mm() / grid_.step_mm));
  std::vector<PoseLine> lines;
  if (pass == Pass::rows_and_edge) lines = layer.rows(every);
  const std::size_t first_edge = lines.size();
  for (PoseLine& edge : layer.edges()) lines.push_back(std::move(edge));
  std::vector<char> done(lines.size(), 0);
  const double free = style_.layer_radii * poses_.radius_mm() + kSetDownMm;
  // The nearest line of the area in work, its rows before its edges.
  for (int area = 0;;) {
    std::size_t best = lines.size();
    double least = kNone;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (done[i] || (area != 0 && area_[lines[i].first_node] != area)) continue;
      const Vec2 here = path_.empty() ? Vec2(0.0) : Vec2(path_.here().x, path_.here().y);
      const double away = std::min(glm::length(lines[i].points.front() - here), glm::length(lines[i].points.back() - here)) +
                          (i >= first_edge ? 1e3 : 0.0);
      if (away < least) {
        least = away;
        best = i;
      }
    }
    if (best == lines.size()) {
      if (area == 0) break;
      area = 0;
      continue;
    }
    done[best] = 1;
    if (area == 0) at_ = ~std::size_t{0};  // another area is entered from above
    area = area_[lines[best].first_node];
    follow(layer, lines[best], free);
  }
  at_ = ~std::size_t{0};
}

/// Goes to the line's nearer end, and along it.
void RegionPlanner::follow(const Layer& layer, const PoseLine& line, double free_mm) {
  PoseLine way = line;
  const double z = layer.z_mm();
  if (!path_.empty()) {
    const Vec2 here(path_.here().x, path_.here().y);
    if (glm::length(way.points.back() - here) < glm::length(way.points.front() - here)) {
      std::ranges::reverse(way.points);
      std::swap(way.first_node, way.last_node);
    }
  }
  if (at_ >= grid_.size()) {
    // Down where the bur comes from above; if nowhere, the area is out of reach.
    std::size_t entry = grid_.size();
    double least = kNone;
    for (std::size_t node = 0; node < grid_.size(); ++node) {
      if (area_[node] != area_[way.first_node] || !open_[node]) continue;
      const double away = glm::length(grid_.at(node) - way.points.front());
      if (away < least) {
        least = away;
        entry = node;
      }
    }
    if (entry == grid_.size()) return;
    path_.enter(Vec3(grid_.at(entry), z), free_mm);
    at_ = entry;
  }
  if (at_ != way.first_node) {
    path_.cut(Vec3(grid_.at(at_), z));
    for (const std::size_t bend : layer.way(at_, way.first_node)) path_.cut(Vec3(grid_.at(bend), z));
  }
  for (const Vec2& p : way.points) path_.cut(Vec3(p, z));
  at_ = way.last_node;
}

std::vector<double> RegionPlanner::level_floors() const {
  std::vector<double> all;
  for (const double z : lowest_)
    if (z < kNone) all.push_back(z);
  std::ranges::sort(all);
  std::vector<double> out;
  const double least = kLeastFloorMm2 / (grid_.step_mm * grid_.step_mm);
  for (std::size_t first = 0; first < all.size();) {
    std::size_t last = first;
    while (last < all.size() && all[last] - all[first] <= kLevelMm) ++last;
    if (static_cast<double>(last - first) >= least) {
      out.push_back(all[last - 1]);
      first = last;
    } else {
      ++first;
    }
  }
  std::ranges::reverse(out);
  return out;
}

void RegionPlanner::work_floors() {
  for (const double z : level_floors()) {
    if (is_cancelled(cancel_)) return;
    std::vector<char> open(grid_.size(), 1), worth = worth_at(z);
    const Layer layer(poses_, grid_, z, open, std::move(worth));
    for (std::size_t node = 0; node < grid_.size(); ++node) open_[node] = lowest_[node] <= z + kLevelMm;
    if (!layer.idle()) work(layer, Pass::edge);
  }
  path_.lift();
  at_ = grid_.size();
  const int every = std::max(1, static_cast<int>(kFloorRowRadii * poses_.radius_mm() / grid_.step_mm));
  for (int j = 0; j < grid_.ny; j += every) finish_row(j);
}

/// From one node's lowest pose to a neighbour's: over the higher of the two where the way is steep.
void RegionPlanner::step_to(std::size_t node) {
  const Vec3 to(grid_.at(node), lowest_[node]), here = path_.here();
  if (std::fabs(to.z - here.z) > 0.5 * grid_.step_mm) {
    const double high = std::max(to.z, here.z);
    path_.cut({here.x, here.y, high});
    path_.cut({to.x, to.y, high});
  }
  path_.cut(to);
  at_ = node;
}

void RegionPlanner::finish_row(int j) {
  const auto reached = [&](int i) {
    const std::size_t node = grid_.index(i, j);
    return lowest_[node] < kNone;
  };
  // To and fro.
  const bool forth = at_ >= grid_.size() || grid_.column(at_) < grid_.nx / 2;
  for (int k = 0; k < grid_.nx; ++k) {
    const int i = forth ? k : grid_.nx - 1 - k;
    if (!reached(i)) continue;
    const std::size_t node = grid_.index(i, j);
    const bool beside = at_ < grid_.size() && std::abs(grid_.column(at_) - i) <= 1 && std::abs(grid_.row(at_) - j) <= 1;
    if (beside) {
      step_to(node);
      continue;
    }
    path_.enter(Vec3(grid_.at(node), lowest_[node]), style_.layer_radii * poses_.radius_mm() + kSetDownMm);
    at_ = node;
  }
}

/// The bur's underside over all lowest poses: which of them shape the floor. One that rests on the edge of the cavity, or on a
/// wall above deeper ones, shapes nothing.
void RegionPlanner::keep_needed() {
  const double step = grid_.step_mm;
  const int reach = static_cast<int>(std::ceil(poses_.spread_mm() / step)), side = 2 * reach + 1;
  std::vector<double> under(static_cast<std::size_t>(side * side));
  for (int k = 0; k < side * side; ++k) {
    const Vec2 off(k % side - reach, k / side - reach);
    // Beside the last pose of a row the bur goes on for half a step on average.
    under[static_cast<std::size_t>(k)] = poses_.underside_mm(off, std::max(0.0, step * (glm::length(off) - 0.5)));
  }
  std::vector<char> needed(grid_.size(), 0);
  for (std::size_t node = 0; node < grid_.size(); ++node) {
    if (!(tissue_top_[node] > -kNone)) continue;
    double cut = kNone;
    std::size_t by = node;
    for (int k = 0; k < side * side; ++k) {
      const int i = grid_.column(node) + k % side - reach, j = grid_.row(node) + k / side - reach;
      if (i < 0 || j < 0 || i >= grid_.nx || j >= grid_.ny) continue;
      const double low = lowest_[grid_.index(i, j)] + under[static_cast<std::size_t>(k)];
      if (low < cut - kLevelMm || (low <= cut && grid_.index(i, j) == node)) {
        cut = low;
        by = grid_.index(i, j);
      }
    }
    if (cut < tissue_top_[node]) needed[by] = 1;
  }
  for (std::size_t node = 0; node < grid_.size(); ++node)
    if (!needed[node]) lowest_[node] = kNone;
}

}  // namespace

Plan plan_region(const Poses& poses, double above_mm, const RegionPlanStyle& style, PlanCancel cancel) {
  return RegionPlanner(poses, above_mm, style, cancel).make();
}

}  // namespace cusp::scenarios
