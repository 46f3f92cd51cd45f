#include "ui/editor/landmark_names.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <string_view>

namespace cusp::ui {
namespace {

/// Holds the translations of this file.
struct LandmarkText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::LandmarkText)
};

QString kind_name(MarkKind kind) {
  switch (kind) {
    case MarkKind::long_axis: return LandmarkText::tr("Long axis");
    case MarkKind::mesial_axis: return LandmarkText::tr("Mesial direction");
    case MarkKind::cusp_tip: return LandmarkText::tr("Cusp tip");
    case MarkKind::pit: return LandmarkText::tr("Pit");
    case MarkKind::fissure: return LandmarkText::tr("Fissure");
    case MarkKind::marginal_ridge: return LandmarkText::tr("Marginal ridge");
    case MarkKind::contact: return LandmarkText::tr("Contact");
    case MarkKind::contour: return LandmarkText::tr("Contour");
    case MarkKind::cej: break;
  }
  return LandmarkText::tr("Cemento-enamel junction");
}

constexpr std::string_view kSupplementary = "supplementary";  // numbered or with a side: "supplementary 2"
constexpr std::string_view kMarginal = " marginal";

/// What the tables of teeth call a place. Abbreviations of cusps ("MB") are the same in every language.
struct Named {
  std::string_view key;
  const char* name;
};
constexpr Named kNames[] = {
    {"cusp", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "the only one")},
    {"incisal", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "incisal")},
    {"central", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "central")},
    {"mesial", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "mesial")},
    {"distal", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "distal")},
    {"buccal", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "buccal")},
    {"lingual", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "lingual")},
    {"central mesial", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "central mesial")},
    {"central distal", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "central distal")},
    {"mesiobuccal", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "mesiobuccal")},
    {"distobuccal", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "distobuccal")},
    {"mesiolingual", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "mesiolingual")},
    {"distolingual", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "distolingual")},
    {"mesiobuccal triangular", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "mesiobuccal triangular")},
    {"distobuccal triangular", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "distobuccal triangular")},
    {"mesiolingual triangular", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "mesiolingual triangular")},
    {"distolingual triangular", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "distolingual triangular")},
    {"mesial marginal", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "mesial marginal")},
    {"distal oblique", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "distal oblique")},
    {kSupplementary, QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "supplementary")},
    {"transverse of oblique ridge", QT_TRANSLATE_NOOP("cusp::ui::LandmarkText", "transverse of the oblique ridge")},
};

QString name_of(std::string_view key) {
  const auto* known = std::ranges::find(kNames, key, &Named::key);
  return known != std::end(kNames) ? LandmarkText::tr(known->name) : QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

QString own_name(const Landmark& mark) {
  std::string_view key = mark.name;
  // "mesial marginal" of a marginal ridge: its kind says the rest.
  if (mark.kind == MarkKind::marginal_ridge && key.ends_with(kMarginal)) key.remove_suffix(kMarginal.size());
  if (!key.starts_with(kSupplementary)) return name_of(key);
  key.remove_prefix(kSupplementary.size());
  return name_of(kSupplementary) + QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

}  // namespace

QString landmark_name(const Landmark& mark) {
  //: %1: a kind of landmark ("Cusp tip"), %2: which one ("MB")
  return mark.name.empty() ? kind_name(mark.kind) : LandmarkText::tr("%1, %2").arg(kind_name(mark.kind), own_name(mark));
}

QString landmark_point_name(const Landmark& mark, std::size_t point) {
  if (point_count(mark.kind).most == 1) return {};
  if (mark.kind == MarkKind::long_axis) return point == 0 ? LandmarkText::tr("Apical end") : LandmarkText::tr("Occlusal end");
  if (mark.kind == MarkKind::mesial_axis) return point == 0 ? LandmarkText::tr("Distal end") : LandmarkText::tr("Mesial end");
  return LandmarkText::tr("Point %1").arg(point + 1);
}

QString mark_state_name(MarkState state) { return state == MarkState::proposed ? LandmarkText::tr("proposed") : LandmarkText::tr("set"); }

QString mark_state_icon(MarkState state) { return state == MarkState::proposed ? u"circle"_qs : u"dot"_qs; }

Message describe(ProposeError error) {
  const QString none = LandmarkText::tr("No landmark can be proposed.");
  switch (error) {
    case ProposeError::unknown_fdi: return {none, LandmarkText::tr("No tooth has that number.")};
    case ProposeError::no_tooth: break;
  }
  return {none, LandmarkText::tr("This volume holds no hard tissue of a tooth.")};
}

Message describe_lack(const SpecimenLandmarks& proposed) {
  if (proposed.marks.empty()) {
    return {LandmarkText::tr("No landmark can be proposed."),
            LandmarkText::tr("Nothing in this volume has the form of a tooth whose crown lies up.")};
  }
  if (proposed.find(MarkKind::mesial_axis) != nullptr) return {};
  return {LandmarkText::tr("The crown is unlike that of tooth %1.").arg(proposed.fdi),
          LandmarkText::tr("What goes by that likeness is left out. Check the number, and that the crown lies up in the file.")};
}

}  // namespace cusp::ui
