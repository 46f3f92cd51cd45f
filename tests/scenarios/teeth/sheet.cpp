/// cusp-teeth-sheet OUT_DIR [--fdi N]... [--seed N] [--voxel-mm X] [--scale PX_PER_MM] [--row N] [--jaw N]: pictures to
/// judge the teeth by. Writes sheet.png (a row a tooth: occlusal, buccal, lingual, mesial, distal, two sections) and
/// occlusal.png; with --row instead row.png, a tooth with carious lesions, neighbours, gingiva and bone; with --jaw jaw.png.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "scenarios/teeth/tables.h"
#include "scenarios/teeth/tooth.h"
#include "tests/modules.h"
#include "tests/scenarios/teeth/jaw.h"
#include "tests/scenarios/teeth/picture.h"

using namespace cusp;
using namespace cusp::test;

namespace {

int refused(const ToothFailure& failure) {
  std::fprintf(stderr, "cusp-teeth-sheet: %s %s\n", failure.where.c_str(), failure.detail.c_str());
  return 1;
}
int written(const Picture& picture, const std::string& path) {
  if (picture.save_png(path)) return 0;
  std::fprintf(stderr, "cusp-teeth-sheet: cannot write %s\n", path.c_str());
  return 1;
}

int draw_row(const std::string& dir, ToothRequest request, double scale) {
  request.neighbours = request.gingiva = request.bone = true;
  request.lesions = {{Lesion::Kind::fissure, "central", 0.9, 1.2, 0.7},
                     {Lesion::Kind::proximal, "mesial", 1.1, 1.0, 0.7},
                     {Lesion::Kind::root, "distal", 1.4, 0.8, 0.6}};
  const auto tooth = grow_tooth(request);
  if (!tooth) return refused(tooth.error());
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const auto nowhere = [](Vec3) { return false; };  // no pulp is followed: the section is plane
  const Picture pictures[] = {view(tooth->volume, -z, y, scale), view(tooth->volume, -y, z, scale),
                              pulp_section(tooth->volume, -y, z, scale, nowhere), pulp_section(tooth->volume, -x, z, scale, nowhere)};
  const int gap = 16;
  int width = gap, height = 0;
  for (const Picture& p : pictures) width += p.width + gap, height = std::max(height, p.height + 2 * gap);
  Picture out(width, height);
  int left = gap;
  for (const Picture& p : pictures) {
    out.put(p, left + p.width / 2, height / 2);
    left += p.width + gap;
  }
  return written(out, dir + "/row.png");
}

int draw_jaw(const std::string& dir, const ToothRequest& request, double scale) {
  const auto jaw = grow_jaw(request);
  if (!jaw) return refused(jaw.error());
  return written(view_of_jaw(*jaw, scale), dir + "/jaw.png");
}

/// Scales in pixels a millimetre.
struct Scales {
  double sheet = 8.0, occlusal = 22.0;
};

/// The cells of one tooth: seven on the sheet, one on the occlusal picture.
struct Cells {
  int left = 0, middle = 0, width = 0;
  int occlusal_x = 0, occlusal_y = 0;
};

void draw_tooth(const VoxelVolume& v, int fdi, const Scales& scales, const Cells& cells, Picture& sheet, Picture& occlusal) {
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const double scale = scales.sheet;
  const bool upper = fdi < 30;
  const Vec3 up = upper ? -z : z;
  occlusal.put(view(v, -z, y, scales.occlusal), cells.occlusal_x, cells.occlusal_y);
  int column = 0;
  const auto put = [&](const Picture& p) { sheet.put(p, cells.left + column++ * cells.width + cells.width / 2, cells.middle); };
  put(view(v, -z, y, scale));
  put(view(v, -y, up, scale));
  put(view(v, y, up, scale));
  put(view(v, -x, up, scale));
  put(view(v, x, up, scale));
  const int number = fdi % 10, mesial = fdi / 10 % 2 == 1 ? 1 : -1;
  const bool molar = number >= 6;
  put(pulp_section(v, -x, up, scale, [&](Vec3 p) { return !molar || p.x * mesial > 0.6 || (upper && p.y < -0.6); }));
  put(pulp_section(v, -y, up, scale, [&](Vec3 p) { return (!molar && number != 4) || p.y > 0.3 || (!upper && p.x * mesial < 0.0); }));
}

int draw_sheet(const std::string& dir, ToothRequest request, const std::vector<int>& fdis, const Scales& scales) {
  const int n = static_cast<int>(fdis.size()), columns = n > 4 ? 4 : n;
  const int cell = static_cast<int>(13.0 * scales.occlusal);
  Picture occlusal(columns * cell, (n + columns - 1) / columns * cell);
  const int row_h = static_cast<int>(29.0 * scales.sheet), col_w = static_cast<int>(13.5 * scales.sheet);
  const int per_row = n > 1 ? 2 : 1, rows = (n + per_row - 1) / per_row;
  Picture sheet(per_row * 7 * col_w, rows * row_h);
  for (int k = 0; k < n; ++k) {
    request.fdi = fdis[static_cast<std::size_t>(k)];
    const auto start = std::chrono::steady_clock::now();
    const auto tooth = grow_tooth(request);
    if (!tooth) {
      std::fprintf(stderr, "cusp-teeth-sheet: %d: %s %s\n", request.fdi, tooth.error().where.c_str(),
                   tooth.error().detail.c_str());
      return 1;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const VoxelVolume& v = tooth->volume;
    const ToothDims &d = tooth->landmarks.dims, a = table_for(request.fdi)->table->dims;
    std::printf("%d  %.2f s  crown %.2f/%.2f root %.2f/%.2f md %.2f/%.2f neck %.2f/%.2f bl %.2f/%.2f neck %.2f/%.2f\n",
                request.fdi, seconds, d.crown_length, a.crown_length, d.root_length, a.root_length, d.mesiodistal,
                a.mesiodistal, d.mesiodistal_neck, a.mesiodistal_neck, d.buccolingual, a.buccolingual,
                d.buccolingual_neck, a.buccolingual_neck);
    // Uppers to the left, lowers to the right, as on the chart.
    const int row = n == 16 ? k % 8 : k / per_row;
    const Cells cells{(n == 16 ? k / 8 : k % per_row) * 7 * col_w, row * row_h + row_h / 2, col_w,
                      (k % columns) * cell + cell / 2, k / columns * cell + cell / 2};
    draw_tooth(v, request.fdi, scales, cells, sheet, occlusal);
  }
  if (!sheet.save_png(dir + "/sheet.png") || !occlusal.save_png(dir + "/occlusal.png")) {
    std::fprintf(stderr, "cusp-teeth-sheet: cannot write into %s\n", dir.c_str());
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: cusp-teeth-sheet OUT_DIR [--fdi N]... [--seed N] [--voxel-mm X] [--scale PX_PER_MM] [--row N] [--jaw N]\n");
    return 2;
  }
  std::vector<int> fdis;
  ToothRequest request;
  Scales scales;
  int row_fdi = 0, jaw_fdi = 0;
  for (int i = 2; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--fdi")) fdis.push_back(std::atoi(argv[i + 1]));
    else if (!std::strcmp(argv[i], "--seed")) request.seed = std::strtoull(argv[i + 1], nullptr, 10);
    else if (!std::strcmp(argv[i], "--voxel-mm")) request.voxel_mm = std::atof(argv[i + 1]);
    else if (!std::strcmp(argv[i], "--scale")) scales.sheet = std::atof(argv[i + 1]), scales.occlusal = 2.75 * scales.sheet;
    else if (!std::strcmp(argv[i], "--row")) row_fdi = std::atoi(argv[i + 1]);
    else if (!std::strcmp(argv[i], "--jaw")) jaw_fdi = std::atoi(argv[i + 1]);
    else return 2;
  }
  if (row_fdi != 0 || jaw_fdi != 0) {
    request.fdi = row_fdi != 0 ? row_fdi : jaw_fdi;
    return row_fdi != 0 ? draw_row(argv[1], request, 2.0 * scales.sheet) : draw_jaw(argv[1], request, 1.5 * scales.sheet);
  }
  if (fdis.empty()) fdis = {11, 12, 13, 14, 15, 16, 17, 18, 31, 32, 33, 34, 35, 36, 37, 38};
  return draw_sheet(argv[1], request, fdis, scales);
}
