#include "ui/app/burr_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "scenarios/burrs/burr_catalogue.h"
#include "ui/widgets/format.h"

namespace cusp {
namespace {

struct BurrWords {
  Q_DECLARE_TR_FUNCTIONS(cusp::BurrWords)
};

QString use_name(std::string_view use) {
  if (use == "caries") return BurrWords::tr("decay");
  if (use == "entry") return BurrWords::tr("entry");
  if (use == "undercut") return BurrWords::tr("undercuts");
  if (use == "flatten") return BurrWords::tr("flat floors");
  if (use == "walls") return BurrWords::tr("walls");
  if (use == "bulk") return BurrWords::tr("bulk removal");
  if (use == "line_angles") return BurrWords::tr("rounded line angles");
  if (use == "crown") return BurrWords::tr("crowns");
  if (use == "inlay") return BurrWords::tr("inlays");
  if (use == "class_1") return BurrWords::tr("class I outlines");
  if (use == "class_2") return BurrWords::tr("class II outlines");
  if (use == "class_2_box") return BurrWords::tr("class II boxes");
  if (use == "chamfer") return BurrWords::tr("chamfers");
  if (use == "shoulder") return BurrWords::tr("shoulders");
  if (use == "bevel") return BurrWords::tr("bevels");
  if (use == "proximal") return BurrWords::tr("between teeth");
  if (use == "occlusal") return BurrWords::tr("occlusal surfaces");
  if (use == "lingual") return BurrWords::tr("lingual surfaces");
  return QString::fromUtf8(use.data(), static_cast<qsizetype>(use.size()));
}

}  // namespace

QString burr_shape_name(std::string_view shape) {
  if (shape == "round") return BurrWords::tr("Round");
  if (shape == "inverted_cone") return BurrWords::tr("Inverted cone");
  if (shape == "straight_fissure") return BurrWords::tr("Straight fissure");
  if (shape == "cross_cut_fissure") return BurrWords::tr("Cross-cut fissure");
  if (shape == "dome_fissure") return BurrWords::tr("Dome fissure");
  if (shape == "tapered_fissure") return BurrWords::tr("Tapered fissure");
  if (shape == "cross_cut_tapered_fissure") return BurrWords::tr("Cross-cut tapered fissure");
  if (shape == "pear") return BurrWords::tr("Pear");
  if (shape == "long_pear") return BurrWords::tr("Long pear");
  if (shape == "round_end_taper") return BurrWords::tr("Round-end taper");
  if (shape == "flat_end_taper") return BurrWords::tr("Flat-end taper");
  if (shape == "flame") return BurrWords::tr("Flame");
  if (shape == "football") return BurrWords::tr("Football");
  return BurrWords::tr("Own shape");
}

QString burr_shape_word(std::string_view shape) {
  if (shape == "round") return BurrWords::tr("round");
  if (shape == "inverted_cone") return BurrWords::tr("inverted cone");
  if (shape == "straight_fissure") return BurrWords::tr("straight fissure");
  if (shape == "cross_cut_fissure") return BurrWords::tr("cross-cut fissure");
  if (shape == "dome_fissure") return BurrWords::tr("dome fissure");
  if (shape == "tapered_fissure") return BurrWords::tr("tapered fissure");
  if (shape == "cross_cut_tapered_fissure") return BurrWords::tr("cross-cut tapered fissure");
  if (shape == "pear") return BurrWords::tr("pear");
  if (shape == "long_pear") return BurrWords::tr("long pear");
  if (shape == "round_end_taper") return BurrWords::tr("round-end taper");
  if (shape == "flat_end_taper") return BurrWords::tr("flat-end taper");
  if (shape == "flame") return BurrWords::tr("flame");
  if (shape == "football") return BurrWords::tr("football");
  return BurrWords::tr("own shape");
}

QString burr_diameter_text(const Burr& burr) { return format({2 * burr.radius_mm, {}, QStringLiteral("mm"), 1}); }

QString burr_text(const Burr& burr) {
  //: Number of a burr, its shape, its diameter.
  return BurrWords::tr("%1, %2, %3")
      .arg(QString::fromStdString(burr.name), burr_shape_word(shape_of(burr)), burr_diameter_text(burr));
}

QString burr_uses_text(const Burr& burr) {
  const CatalogueBurr* one = catalogue_burr(burr.name);
  if (one == nullptr || one->shape != shape_of(burr)) return {};
  QStringList out;
  for (const std::string& use : one->use) out += use_name(use);
  const QString text = out.join(BurrWords::tr(", "));
  return text.isEmpty() ? text : QString(text.at(0).toUpper()) + text.mid(1);
}

}  // namespace cusp
