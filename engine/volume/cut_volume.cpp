#include "engine/volume/cut_volume.h"

#include <cmath>

#include "engine/volume/cell_cutter.h"

namespace cusp::engine {

namespace {

/// The paper's reading: a voxel is a cube. volume == nullptr: the specimen's voxels; else those that were removed.
void emit_filled(const Specimen& specimen, const Volume* volume, int brick, SolidSink& sink) {
  const Grid& grid = specimen.grid();
  const IVec3 corner = specimen.brick_at(brick) * kBrickEdge;
  const auto taken = [&](IVec3 v) { return specimen.s(v) > 0 && (volume == nullptr || volume->s(v) == 0); };
  for (int o = 0; o < kBrickVoxels; ++o) {
    const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
    if (!taken(v)) continue;
    const Vec3 low = grid.centre_mm(v) - 0.5 * grid.voxel_mm;
    const Vec3 high = low + grid.voxel_mm;
    const Tissue tissue = specimen.tissue(v);
    sink.cell(low, high);
    sink.box(low, high, tissue);
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        IVec3 next = v;
        next[axis] += side == 0 ? -1 : 1;
        const bool face = volume == nullptr ? specimen.s(next) == 0 : volume->s(next) > 0;
        if (!face) continue;
        Vec3 a = low, c = high;
        a[axis] = c[axis] = side == 0 ? low[axis] : high[axis];
        Vec3 b = a, d = a;
        const int u = (axis + 1) % 3, w = (axis + 2) % 3;
        b[u] = high[u];
        d[w] = high[w];
        const double mm2 = 0.5 * grid.voxel_mm * grid.voxel_mm;
        sink.face({a, b, c}, mm2, tissue);
        sink.face({a, c, d}, mm2, tissue);
      }
  }
}

template <class Visit>
void each_cell(const Specimen& specimen, int brick, Visit&& visit) {
  const IVec3 at = specimen.brick_at(brick);
  const IVec3 low = at * kBrickEdge - IVec3(at.x == 0, at.y == 0, at.z == 0);
  const IVec3 high = at * kBrickEdge + kBrickEdge;
  for (int z = low.z; z < high.z; ++z)
    for (int y = low.y; y < high.y; ++y)
      for (int x = low.x; x < high.x; ++x) visit(IVec3(x, y, z));
}

/// True if a brick that this one's cells read passes the test.
template <class Test>
bool any_of_eight(const Specimen& specimen, int brick, Test&& test) {
  const IVec3 at = specimen.brick_at(brick);
  for (int i = 0; i < 8; ++i) {
    const int b = specimen.brick_index(at + IVec3(i & 1, i >> 1 & 1, i >> 2));
    if (b >= 0 && test(b)) return true;
  }
  return false;
}

class Adder final : public SolidSink {
 public:
  explicit Adder(SolidMeasure& sum) : sum_(sum) {}
  void cell(Vec3, Vec3) override {}
  void box(Vec3 low, Vec3 high, Tissue tissue) override {
    const Vec3 d = high - low;
    sum_.mm3[index_of(tissue)] += d.x * d.y * d.z;
  }
  void tetrahedron(const std::array<Vec3, 4>&, double mm3, Tissue tissue) override { sum_.mm3[index_of(tissue)] += mm3; }
  void face(const std::array<Vec3, 3>&, double mm2, Tissue) override { sum_.area_mm2 += mm2; }

 private:
  SolidMeasure& sum_;
};

int brick_total(const Specimen& specimen) {
  const IVec3 n = specimen.brick_count();
  return n.x * n.y * n.z;
}

}  // namespace

void emit_specimen(const Specimen& specimen, int brick, SolidSink& sink) {
  if (!any_of_eight(specimen, brick, [&](int b) { return !specimen.uniform(b) || specimen.s_in(b, 0) != 0; })) return;
  if (specimen.reading() == Reading::filled) {
    emit_filled(specimen, nullptr, brick, sink);
    return;
  }
  cell_cutter::CellCutter cutter(specimen, nullptr, sink);
  each_cell(specimen, brick, [&](IVec3 cell) { cutter.cell(cell); });
}

void emit_removed(const Volume& volume, int brick, SolidSink& sink) {
  const Specimen& specimen = volume.specimen();
  if (!any_of_eight(specimen, brick, [&](int b) { return volume.has_cut(b); })) return;
  if (specimen.reading() == Reading::filled) {
    if (volume.has_cut(brick)) emit_filled(specimen, &volume, brick, sink);
    return;
  }
  cell_cutter::CellCutter cutter(specimen, &volume, sink);
  each_cell(specimen, brick, [&](IVec3 cell) { cutter.cell(cell); });
}

double SolidMeasure::total_mm3() const noexcept {
  double sum = 0;
  for (const double v : mm3) sum += v;
  return sum;
}

SolidMeasure specimen_solid(const Specimen& specimen) {
  SolidMeasure sum;
  Adder adder(sum);
  for (int b = 0; b < brick_total(specimen); ++b) emit_specimen(specimen, b, adder);
  return sum;
}

SolidMeasure removed_solid(const Volume& volume) {
  SolidMeasure sum;
  Adder adder(sum);
  for (int b = 0; b < brick_total(volume.specimen()); ++b) emit_removed(volume, b, adder);
  return sum;
}

}  // namespace cusp::engine
