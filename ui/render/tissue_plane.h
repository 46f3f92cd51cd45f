/// The tissues in a section's plane, with borders that run between the voxels. Thread: the volume's owner.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/volume/specimen.h"
#include "ui/modules.h"
#include "ui/render/colours.h"
#include "ui/render/section.h"

namespace cusp::ui {

class TissuePlane {
 public:
  /// Reads the specimen once a voxel, over all of the picture.
  TissuePlane(const Specimen& specimen, const SectionSettings& settings);

  /// Colour of the tissue at a pixel; where several meet, the one with most of the neighbourhood.
  Colour at(int x_px, int y_px, const std::array<Colour, kTissueCodes>& colours) const;

 private:
  static constexpr int kTaps = 6;      // of the neighbourhood, along an axis
  static constexpr int kMargin = kTaps / 2;
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(x) + static_cast<std::size_t>(columns_) * static_cast<std::size_t>(y); }
  Tissue only_about(int x, int y) const;

  double px_per_sample_ = 1.0;
  int columns_ = 0, rows_ = 0;
  std::vector<Tissue> tissue_;  // [y][x], kMargin samples beyond the picture
  std::vector<Tissue> alone_;   // [y][x] the tissue that fills the neighbourhood of the cell above and right; empty: several
};

}  // namespace cusp::ui
