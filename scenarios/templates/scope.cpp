#include "scenarios/templates/scope.h"

#include <algorithm>
#include <optional>

namespace cusp::scenarios {

namespace {

bool is_molar(int fdi) noexcept { return fdi % 10 >= 6; }

/// The pit of that side; of a tooth without one (a third molar) the end of its central groove there.
std::optional<Vec3> side_pit(const ToothLandmarks& landmarks, std::string_view name, double side) {
  for (const SurfacePlace& one : landmarks.pits)
    if (one.name == name) return one.at_mm;
  std::optional<Vec3> end;
  for (const SurfaceLine& fissure : landmarks.fissures) {
    if (!fissure.name.starts_with("central")) continue;
    for (const Vec3& p : fissure.points_mm)
      if (!end || side * p.x > side * end->x) end = p;
  }
  return end;
}

/// No landmark lies at the frame's origin, within the root: there it is not marked.
std::optional<Vec3> marked(Vec3 p) noexcept { return p == Vec3(0.0) ? std::nullopt : std::optional(p); }

void add(Scope& scope, const std::string& name, Vec3 p) {
  scope[name + ".x"] = p.x;
  scope[name + ".y"] = p.y;
  scope[name + ".z"] = p.z;
}

}  // namespace

ToothLandmarks mesial_forward(ToothLandmarks landmarks, int fdi) {
  if (mesial_x(fdi) > 0) return landmarks;
  const auto turn = [](Vec3& p) { p.x = -p.x; };
  for (auto* places : {&landmarks.cusp_tips, &landmarks.pits})
    for (SurfacePlace& one : *places) turn(one.at_mm);
  for (auto* lines : {&landmarks.fissures, &landmarks.marginal_ridges})
    for (SurfaceLine& line : *lines)
      for (Vec3& p : line.points_mm) turn(p);
  for (Vec3& p : landmarks.cej) turn(p);
  for (Vec3* p : {&landmarks.mesial_contact, &landmarks.distal_contact, &landmarks.central}) turn(*p);
  return landmarks;
}

Scope scope_of(const ToothLandmarks& landmarks, int fdi) {
  Scope out;
  out["molar"] = is_molar(fdi) ? 1.0 : 0.0;
  out["upper"] = fdi < 30 ? 1.0 : 0.0;
  out["beside.distal"] = fdi % 10 < 8 ? 1.0 : 0.0;
  if (landmarks.dims.buccolingual > 0.0) out["bl"] = landmarks.dims.buccolingual;
  if (landmarks.dims.mesiodistal > 0.0) out["md"] = landmarks.dims.mesiodistal;
  const auto place = [&out](const std::string& name, const std::optional<Vec3>& p) {
    if (p) add(out, name, *p);
  };
  place("central", marked(landmarks.central));
  place("contact.mesial", marked(landmarks.mesial_contact));
  place("contact.distal", marked(landmarks.distal_contact));
  place("pit.mesial", side_pit(landmarks, "mesial", 1.0));
  place("pit.distal", side_pit(landmarks, "distal", -1.0));
  if (!landmarks.pits.empty())
    out["fossa.z"] = std::ranges::min(landmarks.pits, {}, [](const SurfacePlace& one) { return one.at_mm.z; }).at_mm.z;
  if (landmarks.cej.empty()) return out;
  const auto [back, front] = std::ranges::minmax_element(landmarks.cej, {}, [](const Vec3& p) { return p.x; });
  out["cej.distal.z"] = back->z;
  out["cej.mesial.z"] = front->z;
  return out;
}

bool is_of_tooth(std::string_view name) noexcept {
  if (name == "bl" || name == "md") return true;
  constexpr std::string_view kPlaces[] = {"central.", "contact.", "pit.", "fossa.", "cej."};
  return std::ranges::any_of(kPlaces, [name](std::string_view start) { return name.starts_with(start); });
}

void mirror_x(Region& region) {
  region.from_mm.x = -region.from_mm.x;
  region.to_mm.x = -region.to_mm.x;
  region.x_axis = {region.x_axis.x, -region.x_axis.y, -region.x_axis.z};  // turned back, so that y stays y
  region.z_axis.x = -region.z_axis.x;
  for (auto& path : region.outline.paths)
    for (Vec3& p : path) p.x = -p.x;
  std::swap(region.outline.taper_deg[0], region.outline.taper_deg[1]);
  const auto low = region.faces.extract("x_low"), high = region.faces.extract("x_high");
  if (!low.empty()) region.faces["x_high"] = low.mapped();
  if (!high.empty()) region.faces["x_low"] = high.mapped();
  for (Region& part : region.parts) mirror_x(part);
}

}  // namespace cusp::scenarios
