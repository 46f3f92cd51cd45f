#include "ui/text/bur_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "scenarios/burs/bur_catalogue.h"
#include "ui/modules.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct BurText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::BurText)
};

QString use_name(std::string_view use) {
  if (use == "caries") return BurText::tr("carious lesion");
  if (use == "entry") return BurText::tr("entry");
  if (use == "undercut") return BurText::tr("undercuts");
  if (use == "flatten") return BurText::tr("flat floors");
  if (use == "walls") return BurText::tr("walls");
  if (use == "bulk") return BurText::tr("bulk removal");
  if (use == "line_angles") return BurText::tr("rounded line angles");
  if (use == "crown") return BurText::tr("crowns");
  if (use == "inlay") return BurText::tr("inlays");
  if (use == "class_1") return BurText::tr("class I outlines");
  if (use == "class_2") return BurText::tr("class II outlines");
  if (use == "class_2_box") return BurText::tr("class II boxes");
  if (use == "chamfer") return BurText::tr("chamfers");
  if (use == "shoulder") return BurText::tr("shoulders");
  if (use == "bevel") return BurText::tr("bevels");
  if (use == "proximal") return BurText::tr("between teeth");
  if (use == "occlusal") return BurText::tr("occlusal surfaces");
  if (use == "lingual") return BurText::tr("lingual surfaces");
  return QString::fromUtf8(use.data(), static_cast<qsizetype>(use.size()));
}

}  // namespace

QString bur_shape_name(std::string_view shape) {
  if (shape == "round") return BurText::tr("Round");
  if (shape == "inverted_cone") return BurText::tr("Inverted cone");
  if (shape == "straight_fissure") return BurText::tr("Straight fissure");
  if (shape == "cross_cut_fissure") return BurText::tr("Cross-cut fissure");
  if (shape == "dome_fissure") return BurText::tr("Dome fissure");
  if (shape == "tapered_fissure") return BurText::tr("Tapered fissure");
  if (shape == "cross_cut_tapered_fissure") return BurText::tr("Cross-cut tapered fissure");
  if (shape == "pear") return BurText::tr("Pear");
  if (shape == "long_pear") return BurText::tr("Long pear");
  if (shape == "round_end_taper") return BurText::tr("Round-end taper");
  if (shape == "flat_end_taper") return BurText::tr("Flat-end taper");
  if (shape == "flame") return BurText::tr("Flame");
  if (shape == "football") return BurText::tr("Football");
  return BurText::tr("Own shape");
}

QString bur_shape_word(std::string_view shape) {
  if (shape == "round") return BurText::tr("round");
  if (shape == "inverted_cone") return BurText::tr("inverted cone");
  if (shape == "straight_fissure") return BurText::tr("straight fissure");
  if (shape == "cross_cut_fissure") return BurText::tr("cross-cut fissure");
  if (shape == "dome_fissure") return BurText::tr("dome fissure");
  if (shape == "tapered_fissure") return BurText::tr("tapered fissure");
  if (shape == "cross_cut_tapered_fissure") return BurText::tr("cross-cut tapered fissure");
  if (shape == "pear") return BurText::tr("pear");
  if (shape == "long_pear") return BurText::tr("long pear");
  if (shape == "round_end_taper") return BurText::tr("round-end taper");
  if (shape == "flat_end_taper") return BurText::tr("flat-end taper");
  if (shape == "flame") return BurText::tr("flame");
  if (shape == "football") return BurText::tr("football");
  return BurText::tr("own shape");
}

QString bur_diameter_text(const Bur& bur) { return format({2 * bur.radius_mm, {}, QStringLiteral("mm"), 1}); }

QString bur_text(const Bur& bur) {
  //: Number of a bur, its shape, its diameter.
  return BurText::tr("%1, %2, %3")
      .arg(QString::fromStdString(bur.name), bur_shape_word(shape_of(bur)), bur_diameter_text(bur));
}

QString bur_uses_text(const Bur& bur) {
  const CatalogueBur* one = catalogue_bur(bur.name);
  if (one == nullptr || one->shape != shape_of(bur)) return {};
  QStringList out;
  for (const std::string& use : one->use) out += use_name(use);
  const QString text = out.join(BurText::tr(", "));
  return text.isEmpty() ? text : QString(text.at(0).toUpper()) + text.mid(1);
}

}  // namespace cusp::ui
