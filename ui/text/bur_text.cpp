#include "ui/text/bur_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "scenarios/burs/bur_catalogue.h"
#include "ui/modules.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct BurWords {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::BurWords)
};

QString use_name(std::string_view use) {
  if (use == "caries") return BurWords::tr("decay");
  if (use == "entry") return BurWords::tr("entry");
  if (use == "undercut") return BurWords::tr("undercuts");
  if (use == "flatten") return BurWords::tr("flat floors");
  if (use == "walls") return BurWords::tr("walls");
  if (use == "bulk") return BurWords::tr("bulk removal");
  if (use == "line_angles") return BurWords::tr("rounded line angles");
  if (use == "crown") return BurWords::tr("crowns");
  if (use == "inlay") return BurWords::tr("inlays");
  if (use == "class_1") return BurWords::tr("class I outlines");
  if (use == "class_2") return BurWords::tr("class II outlines");
  if (use == "class_2_box") return BurWords::tr("class II boxes");
  if (use == "chamfer") return BurWords::tr("chamfers");
  if (use == "shoulder") return BurWords::tr("shoulders");
  if (use == "bevel") return BurWords::tr("bevels");
  if (use == "proximal") return BurWords::tr("between teeth");
  if (use == "occlusal") return BurWords::tr("occlusal surfaces");
  if (use == "lingual") return BurWords::tr("lingual surfaces");
  return QString::fromUtf8(use.data(), static_cast<qsizetype>(use.size()));
}

}  // namespace

QString bur_shape_name(std::string_view shape) {
  if (shape == "round") return BurWords::tr("Round");
  if (shape == "inverted_cone") return BurWords::tr("Inverted cone");
  if (shape == "straight_fissure") return BurWords::tr("Straight fissure");
  if (shape == "cross_cut_fissure") return BurWords::tr("Cross-cut fissure");
  if (shape == "dome_fissure") return BurWords::tr("Dome fissure");
  if (shape == "tapered_fissure") return BurWords::tr("Tapered fissure");
  if (shape == "cross_cut_tapered_fissure") return BurWords::tr("Cross-cut tapered fissure");
  if (shape == "pear") return BurWords::tr("Pear");
  if (shape == "long_pear") return BurWords::tr("Long pear");
  if (shape == "round_end_taper") return BurWords::tr("Round-end taper");
  if (shape == "flat_end_taper") return BurWords::tr("Flat-end taper");
  if (shape == "flame") return BurWords::tr("Flame");
  if (shape == "football") return BurWords::tr("Football");
  return BurWords::tr("Own shape");
}

QString bur_shape_word(std::string_view shape) {
  if (shape == "round") return BurWords::tr("round");
  if (shape == "inverted_cone") return BurWords::tr("inverted cone");
  if (shape == "straight_fissure") return BurWords::tr("straight fissure");
  if (shape == "cross_cut_fissure") return BurWords::tr("cross-cut fissure");
  if (shape == "dome_fissure") return BurWords::tr("dome fissure");
  if (shape == "tapered_fissure") return BurWords::tr("tapered fissure");
  if (shape == "cross_cut_tapered_fissure") return BurWords::tr("cross-cut tapered fissure");
  if (shape == "pear") return BurWords::tr("pear");
  if (shape == "long_pear") return BurWords::tr("long pear");
  if (shape == "round_end_taper") return BurWords::tr("round-end taper");
  if (shape == "flat_end_taper") return BurWords::tr("flat-end taper");
  if (shape == "flame") return BurWords::tr("flame");
  if (shape == "football") return BurWords::tr("football");
  return BurWords::tr("own shape");
}

QString bur_diameter_text(const Bur& bur) { return format({2 * bur.radius_mm, {}, QStringLiteral("mm"), 1}); }

QString bur_text(const Bur& bur) {
  //: Number of a bur, its shape, its diameter.
  return BurWords::tr("%1, %2, %3")
      .arg(QString::fromStdString(bur.name), bur_shape_word(shape_of(bur)), bur_diameter_text(bur));
}

QString bur_uses_text(const Bur& bur) {
  const CatalogueBur* one = catalogue_bur(bur.name);
  if (one == nullptr || one->shape != shape_of(bur)) return {};
  QStringList out;
  for (const std::string& use : one->use) out += use_name(use);
  const QString text = out.join(BurWords::tr(", "));
  return text.isEmpty() ? text : QString(text.at(0).toUpper()) + text.mid(1);
}

}  // namespace cusp::ui
