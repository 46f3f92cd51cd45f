/// The whole 3D view: background, tooth, target lines, cutaway and bur, drawn into the framebuffer that is bound in
/// the current OpenGL 3.3 core context. No window, no Qt. Thread: the one that holds the context; needs it current from
/// create() to destruction.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/tool/bur.h"
#include "ui/modules.h"
#include "ui/render/camera.h"
#include "ui/render/colours.h"
#include "ui/render/mouth_mirror.h"
#include "ui/render/overlay_line.h"
#include "ui/render/patch_store.h"
#include "ui/render/scenery_look.h"
#include "ui/render/section.h"
#include "ui/render/surface_marks.h"

namespace cusp::ui {

enum class Colouring : std::uint8_t {
  tissue,     // as a tooth looks; a cut beyond the leeway is hatched
  deviation,  // difference map of the report
};

/// From which side the handpiece reaches the tooth, as the viewer sees it.
enum class HandSide : std::uint8_t { right, left };

struct BurPose {
  Bur bur;
  Vec3 pivot_mm{0.0};
  Vec3 axis{0.0, 0.0, 1.0};  // unit, from ball to shank
  bool turning = false;
};

/// Everything that a frame shows besides the mesh. Equal scenes give equal pictures.
struct Scene3d {
  Camera camera;
  Colour background_middle = colour_of(0xCDD4DC), background_edge = colour_of(0xAFB8C3);  // the theme's "view"
  Colouring colouring = Colouring::tissue;
  bool show_target = true;                // tint of the uncut remainder, the lines, hatching of the over-cut
  std::optional<BurPose> bur;
  bool show_handpiece = false;            // above the bur; left out of a cutaway, and where a mirror is held, which it would hide
  HandSide hand = HandSide::right;        // that holds the handpiece
  std::optional<SectionPlane> cutaway;    // what lies on the plane's front side is taken away
  std::optional<MouthMirror> mirror;      // reflects all of it but itself; left out of a cutaway
  float line_scale = 1.0f;                // device pixels a pixel, for the widths of lines
};

struct DrawStats {
  std::size_t triangles = 0, bricks = 0;
};

class ToothPicture {
 public:
  /// nullptr when the context is not able (older than 3.3 core); `why` names what failed.
  static std::unique_ptr<ToothPicture> create(std::string* why = nullptr);
  ~ToothPicture();

  /// Uploads a patch, replacing that of the same brick.
  void put(const BakedPatch& patch);
  void clear();
  /// What stands about the specimen; null: nothing.
  void set_scenery(const SceneryLook* scenery);
  /// Lines at the surface (target, leeway, handles' guides).
  void set_lines(const std::vector<OverlayLine>& lines);
  /// What a measure is about, over the tooth; left out of a cutaway.
  void set_marks(const SurfaceMarks& marks);
  /// Picture that closes the cutaway; drawn on its plane.
  void set_section(const SectionImage& image);

  /// Fills the viewport (0, 0, width, height) of the bound framebuffer.
  DrawStats draw(const Scene3d& scene, int width_px, int height_px);

 private:
  ToothPicture();
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
