#include "scenarios/teeth/tooth_body.h"

#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

ToothBody::ToothBody(const ToothShape& shape, const ToothPlace& place, ToothMaterial material,
                     std::vector<PlacedLesion> lesions)
    : shape_(&shape), place_(place), material_(material), lesions_(std::move(lesions)) {
  low_ = Vec3(1e9);
  high_ = Vec3(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = place_.from_tooth({corner & 1 ? shape.high().x : shape.low().x, corner & 2 ? shape.high().y : shape.low().y,
                                      corner & 4 ? shape.high().z : shape.low().z});
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
}

Tissue ToothBody::worn(Tissue natural) const noexcept {
  switch (material_) {
    case ToothMaterial::natural: return natural;
    case ToothMaterial::typodont: return Tissue::plastic;
    case ToothMaterial::neighbour: return natural == Tissue::enamel ? kNeighbourEnamel : kNeighbourDentine;
  }
  return natural;
}

Tissue ToothBody::inside(Vec3 p, double outside_mm) const noexcept {
  if (material_ == ToothMaterial::typodont) return Tissue::plastic;
  const Vec3 q = place_.to_tooth(p);
  const double dentine = shape_->dentine(q, outside_mm);
  Tissue sound;
  if (dentine < 0.0) {
    sound = shape_->pulp(q) < 0.0 ? Tissue::pulp : Tissue::dentine;
  } else {
    sound = shape_->above_cej(q) > 0.0 ? Tissue::enamel : Tissue::cementum;
  }
  for (const PlacedLesion& lesion : lesions_) {
    const Tissue carious = lesion.carious(sound, q, outside_mm, dentine);
    if (carious != sound) return carious;
  }
  return worn(sound);
}

Tissue ToothBody::skin(Vec3 p) const noexcept {
  const Vec3 q = place_.to_tooth(p);
  const Tissue sound = shape_->above_cej(q) > 0.0 ? Tissue::enamel : Tissue::cementum;
  for (const PlacedLesion& lesion : lesions_) {
    const Tissue carious = lesion.carious(sound, q, 0.0, 1.0);
    if (carious != sound) return carious;
  }
  return worn(sound);
}

Tissue ToothBody::whole(Vec3 p, double far) const noexcept {
  const Vec3 q = place_.to_tooth(p);
  for (const PlacedLesion& lesion : lesions_) {
    if (glm::length(q - lesion.site_mm()) < lesion.reach_mm() + far) return Tissue::empty;
  }
  const double value = shape_->outside(q), dentine = shape_->dentine(q, value), pulp = shape_->pulp(q);
  if (pulp < -far) return worn(Tissue::pulp);
  if (dentine < -far && pulp > far) return worn(Tissue::dentine);
  if (dentine > far && shape_->above_cej(q) > far) return worn(Tissue::enamel);
  return Tissue::empty;
}

}  // namespace cusp::scenarios
