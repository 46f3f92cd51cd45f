#include "ui/text/metric_names.h"

#include <array>

#include "scenarios/format/region.h"
#include "ui/modules.h"
#include "ui/text/text.h"

namespace cusp::ui {

namespace {

struct Named {
  std::string_view key;
  const char* name;
};

constexpr std::array kNames = {
    Named{"surface_rms", QT_TRANSLATE_NOOP("cusp::ui::Text", "Distance from the target, root mean square")},
    Named{"surface_p95", QT_TRANSLATE_NOOP("cusp::ui::Text", "Distance from the target, of 95 % of it")},
    Named{"surface_greatest", QT_TRANSLATE_NOOP("cusp::ui::Text", "Distance from the target, greatest")},
    Named{"gingival_above_cej", QT_TRANSLATE_NOOP("cusp::ui::Text", "Gingival floor above the cemento-enamel junction")},
    Named{"box_height", QT_TRANSLATE_NOOP("cusp::ui::Text", "Box height, pulpal to gingival floor")},
    Named{"axial_past_junction_least", QT_TRANSLATE_NOOP("cusp::ui::Text", "Axial wall in dentine, least")},
    Named{"axial_past_junction_mean", QT_TRANSLATE_NOOP("cusp::ui::Text", "Axial wall in dentine, mean")},
    Named{"axial_past_junction_most", QT_TRANSLATE_NOOP("cusp::ui::Text", "Axial wall in dentine, greatest")},
    Named{"cavosurface_angle", QT_TRANSLATE_NOOP("cusp::ui::Text", "Cavosurface angle, mean")},
    Named{"cavosurface_off", QT_TRANSLATE_NOOP("cusp::ui::Text", "Margin below 80° or above 110°")},
    Named{"unsupported_enamel", QT_TRANSLATE_NOOP("cusp::ui::Text", "Unsupported enamel")},
    Named{"contact_broken", QT_TRANSLATE_NOOP("cusp::ui::Text", "Contact open")},
    Named{"clearance_buccal_gingival", QT_TRANSLATE_NOOP("cusp::ui::Text", "Clearance, buccal, gingival third")},
    Named{"clearance_buccal_middle", QT_TRANSLATE_NOOP("cusp::ui::Text", "Clearance, buccal, middle third")},
    Named{"clearance_buccal_occlusal", QT_TRANSLATE_NOOP("cusp::ui::Text", "Clearance, buccal, occlusal third")},
    Named{"clearance_lingual_gingival", QT_TRANSLATE_NOOP("cusp::ui::Text", "Clearance, lingual, gingival third")},
    Named{"clearance_lingual_middle", QT_TRANSLATE_NOOP("cusp::ui::Text", "Clearance, lingual, middle third")},
    Named{"clearance_lingual_occlusal", QT_TRANSLATE_NOOP("cusp::ui::Text", "Clearance, lingual, occlusal third")},
    Named{"clearance_gingival", QT_TRANSLATE_NOOP("cusp::ui::Text", "Clearance, gingival")},
    Named{"gingival_floor_mesiodistal", QT_TRANSLATE_NOOP("cusp::ui::Text", "Gingival floor, mesiodistal depth")},
    Named{"caries_left_periphery", QT_TRANSLATE_NOOP("cusp::ui::Text", "Caries left at the periphery")},
    Named{"caries_left_pulp", QT_TRANSLATE_NOOP("cusp::ui::Text", "Soft caries left over the pulp")},
    Named{"caries_left_pulp_firm", QT_TRANSLATE_NOOP("cusp::ui::Text", "Firm caries left over the pulp")},
    Named{"caries_left_enamel", QT_TRANSLATE_NOOP("cusp::ui::Text", "Carious enamel left")},
    Named{"sound_lost", QT_TRANSLATE_NOOP("cusp::ui::Text", "Sound tissue lost")},
};

}  // namespace

QString face_name(std::string_view key) {
  if (key == "pulpal_floor") return Text::tr("pulpal floor");
  if (key == "mesial_wall") return Text::tr("mesial wall");
  if (key == "distal_wall") return Text::tr("distal wall");
  if (key == "buccal_wall") return Text::tr("buccal wall");
  if (key == "lingual_wall") return Text::tr("lingual wall");
  if (key == "gingival_floor") return Text::tr("gingival floor");
  if (key == "axial_wall") return Text::tr("axial wall");
  return Text::tr("other walls");
}

QString group_metric_name(const std::string& metric) {
  for (const Named& one : kNames)
    if (one.key == metric) return Text::tr(one.name);
  for (const std::string_view face : kFaceKeys) {
    if (metric == "overcut_leeway_" + std::string(face)) return Text::tr("Over-cut within tolerance, %1").arg(face_name(face));
    if (metric == "overcut_beyond_" + std::string(face)) return Text::tr("Over-cut, %1").arg(face_name(face));
  }
  constexpr std::string_view kWithin = "surface_within_";
  if (metric.starts_with(kWithin)) return Text::tr("Target within %1 µm of the cut").arg(text(metric.substr(kWithin.size())));
  return {};
}

QString group_advice(const std::string& m, OffBy off) {
  const bool too_little = off == OffBy::too_little;
  if (m.starts_with("overcut_"))
    return m.ends_with("floor") ? Text::tr("Lift off and read the depth before you go deeper.")
                                : Text::tr("Keep the bur’s edge inside the target line; push less near the walls.");
  if (m.starts_with("surface_")) return Text::tr("Look at the section and even out where the cut leaves the target.");
  if (m.starts_with("cavosurface_")) return Text::tr("Hold the bur at right angles to the tooth’s surface along the margin.");
  if (m == "unsupported_enamel") return Text::tr("Let every wall end on dentine: take away enamel that has none beneath it.");
  if (m == "contact_broken")
    return too_little ? Text::tr("Open the box until nothing touches the neighbour.")
                      : Text::tr("End the box short of the neighbour: the contact stays closed.");
  if (m == "clearance_gingival")
    return too_little ? Text::tr("Lower the gingival floor until its margin stands clear of the neighbour.")
                      : Text::tr("Keep the gingival floor higher: its margin lies far from the neighbour.");
  if (m.starts_with("clearance_"))
    return too_little ? Text::tr("Widen the box until the margin stands far enough from the neighbour.")
                      : Text::tr("Keep the box narrow: the margin lies far from the neighbour.");
  if (m.starts_with("axial_past_junction_"))
    return too_little ? Text::tr("Carry the axial wall into dentine, along the outer contour.")
                      : Text::tr("Stop the axial wall just inside the dentine.");
  if (m == "gingival_above_cej" || m == "box_height" || m == "gingival_floor_mesiodistal")
    return Text::tr("Compare the box with the bur’s length and width before you deepen it.");
  if (m == "caries_left_periphery") return Text::tr("Clear the caries along the dentino-enamel junction until it is hard.");
  if (m == "caries_left_pulp_firm" && too_little) return {};
  if (m.starts_with("caries_left_")) return Text::tr("Remove what is still carious there.");
  if (m == "sound_lost") return Text::tr("Keep to the lesion and its access.");
  return {};
}

}  // namespace cusp::ui
