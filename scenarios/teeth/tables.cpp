#include "scenarios/teeth/tables.h"

#include <nlohmann/json.hpp>

#include "scenarios/teeth/teeth_json.h"

namespace cusp::scenarios {
namespace {

using Json = nlohmann::json;

Vec2 pair(const Json& j) { return {j.at(0).get<double>(), j.at(1).get<double>()}; }
Vec3 triple(const Json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

std::vector<Vec2> pairs(const Json& j) {
  std::vector<Vec2> out;
  for (const Json& p : j) out.push_back(pair(p));
  if (out.empty()) throw Json::other_error::create(600, "a line needs a point", nullptr);
  return out;
}
std::vector<Vec3> triples(const Json& j) {
  std::vector<Vec3> out;
  for (const Json& p : j) out.push_back(triple(p));
  if (out.empty()) throw Json::other_error::create(600, "a line needs a point", nullptr);
  return out;
}
std::vector<Knot> knots(const Json& j) {
  std::vector<Knot> out;
  for (const Vec2 p : pairs(j)) out.push_back({p.x, p.y});
  return out;
}

LoftTable loft(const Json& j) {
  LoftTable t;
  t.name = j.at("n");
  t.path = triples(j.at("p"));
  t.rx = j.at("rx").get<std::vector<double>>();
  t.ry = j.at("ry").get<std::vector<double>>();
  if (t.rx.size() != t.path.size() || t.ry.size() != t.path.size()) {
    throw Json::other_error::create(600, "radii and points differ in number: " + t.name, nullptr);
  }
  t.exponent = j.value("e", 2.0);
  t.cap_mm = j.value("cap", 0.0);
  t.top_cap_mm = j.value("capt", 0.0);
  t.rotation_deg = j.value("rot", 0.0);
  return t;
}

WallTable wall(const Json& j) {
  WallTable w;
  w.m = knots(j.at("M"));
  w.d = knots(j.at("D"));
  w.b = knots(j.at("B"));
  w.l = knots(j.at("L"));
  w.cy = knots(j.at("cy"));
  for (std::size_t q = 0; q < 4; ++q) w.exponent[q] = knots(j.at("n").at(q));
  w.taper = knots(j.at("taper"));
  if (j.contains("shear")) w.shear = knots(j.at("shear"));
  w.cap_mm = j.value("cap", 0.0);
  return w;
}

FaceTable face(const Json& j) {
  FaceTable f;
  f.name = j.at("n");
  const std::string side = j.at("f");
  if (side == "M") f.side = FaceTable::Side::mesial;
  else if (side == "D") f.side = FaceTable::Side::distal;
  else if (side == "B") f.side = FaceTable::Side::buccal;
  else if (side == "L") f.side = FaceTable::Side::lingual;
  else throw Json::other_error::create(600, "unknown side: " + side, nullptr);
  f.path = pairs(j.at("p"));
  f.outward_mm = j.at("a");
  f.width_mm = j.at("w");
  f.power = j.value("pw", 2.0);
  return f;
}

ToothTable tooth(const Json& j) {
  ToothTable t;
  t.id = j.at("id");
  t.fdi = j.at("fdi");
  const Json& d = j.at("dims");
  t.dims = {d.at("crown_len"), d.at("root_len"), d.at("md"), d.at("md_cervix"), d.at("bl"), d.at("bl_cervix")};
  t.cej_m = d.at("cej_m");
  t.cej_d = d.at("cej_d");
  t.cej_b = d.at("cej_b");
  t.cej_l = d.at("cej_l");
  t.contact_m = pair(j.at("contacts").at("m"));
  t.contact_d = pair(j.at("contacts").at("d"));
  t.wall = wall(j.at("wall"));
  t.edge_mm = j.at("edge");
  t.ridge_blend_mm = j.value("ridge_blend", 0.3);
  t.floor_z = j.value("floor", -100.0);
  for (const Json& c : j.at("cusps")) t.cusps.push_back({c.at("n"), {c.at("x"), c.at("y"), c.at("z")}, c.at("t")});
  for (const Json& r : j.at("ridges")) {
    const bool one = r.contains("k");
    t.ridges.push_back({r.at("n"), triples(r.at("p")), r.at(one ? "k" : "k_in"), r.at(one ? "k" : "k_out"), r.at("r")});
  }
  if (j.contains("grooves")) {
    for (const Json& g : j.at("grooves")) t.grooves.push_back({g.at("n"), pairs(g.at("p")), g.at("d"), g.at("w")});
  }
  if (j.contains("pits")) {
    for (const Json& p : j.at("pits")) t.pits.push_back({p.at("n"), pair(p.at("at")), p.at("d"), p.at("w")});
  }
  for (const Json& f : j.at("faces")) t.faces.push_back(face(f));
  if (j.contains("roots")) {
    for (const Json& r : j.at("roots")) t.roots.push_back(loft(r));
  }
  const Json& e = j.at("enamel");
  t.enamel = {e.at("B"), e.at("L"), e.at("M"), e.at("D"), e.at("basin"), e.at("fissure_min"), e.at("tau")};
  const Json& pulp = j.at("pulp");
  if (pulp.contains("chamber")) t.chambers.push_back(loft(pulp.at("chamber")));
  for (const Json& c : pulp.at("canals")) t.canals.push_back(loft(c));
  for (const Json& h : pulp.at("horns")) t.horns.push_back({triple(h.at("a")), triple(h.at("b")), h.at("ra"), h.at("rb")});
  const Json& c = j.at("calibration");
  t.x_crown = c.at("x_crown");
  t.x_neck = c.at("x_cervix");
  t.y_crown = c.at("y_crown");
  t.y_neck = c.at("y_cervix");
  t.z_crown = c.at("z_crown");
  t.z_root = c.at("z_root");
  return t;
}

}  // namespace

Result<std::vector<ToothTable>, ToothFailure> read_tooth_tables(std::string_view json_text) {
  std::vector<ToothTable> out;
  std::string where = "teeth.json";
  try {
    const Json j = Json::parse(json_text);
    if (j.at("format") != "cusp-teeth-1") return fail(ToothError::bad_tables, "format");
    for (const Json& t : j.at("teeth")) {
      where = t.at("id").get<std::string>();
      out.push_back(tooth(t));
    }
  } catch (const Json::exception& e) {
    return fail(ToothError::bad_tables, where, e.what());
  }
  if (out.empty()) return fail(ToothError::bad_tables, "teeth");
  return out;
}

Result<TableChoice, ToothFailure> table_for(int fdi) {
  static const Result<std::vector<ToothTable>, ToothFailure> tables = read_tooth_tables(kTeethJson);
  if (!tables) return std::unexpected(tables.error());
  const int quadrant = fdi / 10, number = fdi % 10;
  if (fdi < 11 || quadrant > 4 || number < 1 || number > 8) {
    return fail(ToothError::unknown_fdi, std::to_string(fdi));
  }
  const int key = (quadrant <= 2 ? 10 : 40) + number;
  for (const ToothTable& t : *tables) {
    if (t.fdi == key) return TableChoice{&t, quadrant == 2 || quadrant == 4};
  }
  return fail(ToothError::bad_tables, std::to_string(key));
}

}  // namespace cusp::scenarios
