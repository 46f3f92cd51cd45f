/// cusp-teeth-table [--voxel-mm X] [--fdi N]...: every tooth of both sides, measured on its voxels, as a table.
/// Exit 1 if one misses the limits of print_row(). Two minutes at 0.1 mm. With --jaw N instead: how long a
/// whole jaw about that tooth takes to open, and how much memory.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/teeth/tables.h"
#include "scenarios/teeth/tooth.h"
#include "tests/modules.h"
#include "tests/scenarios/teeth/jaw.h"
#include "tests/scenarios/teeth/measure.h"

using namespace cusp;
using namespace cusp::test;

namespace {

double worst_share(const ToothDims& got, const ToothDims& want) {
  const auto off = [](double g, double w) { return std::fabs(g / w - 1.0); };
  return std::max({off(got.crown_length, want.crown_length), off(got.root_length, want.root_length),
                   off(got.mesiodistal, want.mesiodistal), off(got.buccolingual, want.buccolingual)});
}

/// A full jaw as an exercise opens it: the drillable tooth and its neighbours as voxels in bricks, the rest as surfaces.
int measure_jaw(const ToothRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  auto jaw = grow_jaw(request);
  if (!jaw) return 1;
  std::size_t meshes = 0;
  for (const JawSurface& s : jaw->scenery) meshes += s.mesh.bytes();
  const auto specimen = Specimen::build(jaw->tooth.volume, Reading::banded);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::ifstream status("/proc/self/status");
  long peak_kb = 0;
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") status >> peak_kb;
  }
  std::printf("jaw of %zu teeth about %d: %.1f s (%.1f s of CPU), at most %ld MB; kept: %.0f MB of bricks, %.0f MB of surfaces\n",
              jaw->scenery.size() + jaw->tooth.neighbours.size() + 1, request.fdi, seconds,
              static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, peak_kb / 1024, static_cast<double>(specimen->bytes()) / 1e6,
              static_cast<double>(meshes) / 1e6);
  return peak_kb < 600 * 1024 ? 0 : 1;
}

/// Prints the row of one tooth. False: it could not be grown, or misses a limit.
bool print_row(ToothRequest request, int fdi) {
  request.fdi = fdi;
  const std::clock_t start = std::clock();
  const auto tooth = grow_tooth(request);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!tooth) {
    std::fprintf(stderr, "cusp-teeth-table: %d: %s\n", fdi, tooth.error().where.c_str());
    return false;
  }
  const TableChoice choice = *table_for(fdi);
  const ToothTable& t = *choice.table;
  const VoxelVolume& v = tooth->volume;
  const ToothLandmarks& l = tooth->landmarks;
  const ToothDims d = measured_dims(v, t.cej_m, t.cej_d, choice.mirrored ? Quadrant::mirrored : Quadrant::as_tabled);
  const double off = worst_share(d, t.dims);
  const int number = fdi % 10;
  // A shoulder of an incisal edge is no cusp; a premolar's lower cusp and the distal one of a lower molar are low.
  const int cusps = number <= 3 ? 1 : peaks(v, 0.1);
  double thin = 9.0, thick = 0.0;
  for (const SurfacePlace& tip : l.cusp_tips) {
    const double e = thickness_below(v, tip.at_mm, Tissue::enamel);
    thin = std::min(thin, e);
    thick = std::max(thick, e);
  }
  double pit = 9.0;  // thinnest enamel under a fissure
  for (const SurfaceLine& line : l.fissures) {
    for (const Vec3& at : line.points_mm) pit = std::min(pit, thickness_below(v, at, Tissue::enamel));
  }
  const double cover = pulp_cover_mm(v, -0.7 * t.dims.root_length, 1.2);
  const Components p = components_of_tissues(v);
  double heights = 0.0;
  if (number == 6 || number == 7) {
    heights = furthest_from_quoted(pulp_heights(v, l.cusp_tips.front().at_mm), fdi < 30 ? kUpperMolars : kLowerMolars);
  }
  const auto contact_off = [](Vec3 at, Vec2 want) { return glm::length(Vec2(at.y, at.z) - want); };
  const double contacts = std::max(contact_off(l.mesial_contact, t.contact_m), contact_off(l.distal_contact, t.contact_d));
  std::printf("| %d | %.2f | %.2f | %.2f | %.2f | %.1f %% | %d | %.1f to %.1f | ", fdi, d.crown_length, d.root_length,
              d.mesiodistal, d.buccolingual, 100.0 * off, cusps, thin, thick);
  if (number > 3) std::printf("%.2f", pit);
  std::printf(" | %.2f | ", cover);
  if (heights > 0.0) std::printf("%.1f σ", heights);
  std::printf(" | %s | %.2f | %.1f |\n", p.all_one() ? "one each" : "several", contacts, seconds);
  std::fflush(stdout);
  const bool good = off < 0.02 && cusps == static_cast<int>(t.cusps.size()) && thin >= 1.4 && thick <= 2.7 &&
                    (number <= 3 || (pit >= 0.2 && pit <= 0.6)) && cover >= 0.4 && heights <= 1.0 && p.all_one() && contacts <= 0.5;
  if (!good) std::fprintf(stderr, "cusp-teeth-table: %d misses its limits\n", fdi);
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<int> fdis;
  ToothRequest request;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--voxel-mm")) request.voxel_mm = std::atof(argv[i + 1]);
    else if (!std::strcmp(argv[i], "--fdi")) fdis.push_back(std::atoi(argv[i + 1]));
    else if (!std::strcmp(argv[i], "--jaw")) {
      request.fdi = std::atoi(argv[i + 1]);
      return measure_jaw(request);
    } else {
      return 2;
    }
  }
  if (fdis.empty()) {
    for (const int quadrant : {1, 2, 3, 4}) {
      for (int n = 1; n <= 8; ++n) fdis.push_back(10 * quadrant + n);
    }
  }
  std::printf("| FDI | crown | root | MD | BL | furthest off | cusps | enamel at tips | under fissures | pulp cover | pulp heights | components | contacts off | CPU s |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  int missed = 0;
  for (const int fdi : fdis) missed += print_row(request, fdi) ? 0 : 1;
  return missed == 0 ? 0 : 1;
}
