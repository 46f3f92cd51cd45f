// cusp-exercise-pictures SCENARIO FOLDER: an exercise as its author should see it: the target on the tooth, and what the
// reference operator and the novice leave, each from above and in two sections. Writes STATE.png, STATE-md.png (mesiodistal
// section), STATE-bl.png (buccolingual one) and exercise.json (points, what lost some). SCENARIO: a file, or the id of a
// built-in exercise. exercise_sheet.py lays them out.

#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/operators/fast_cut.h"
#include "tests/modules.h"
#include "tests/ui/render/exercise_file.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/target_look.h"
#include "ui/render/tooth_picture.h"
#include "ui/session/scene_builder.h"

using namespace cusp;
using namespace cusp::test;

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSidePx = 480;         // drawn at twice that
constexpr double kSectionMm = 13.0;  // a molar's crown with the contacts
constexpr double kAroundMm = 2.6;    // of the crown about the target, as on the exercise's card

/// The middle of the target's lowest floor.
Vec3 lowest_place(const TargetShape& shape) {
  constexpr double kStep = 0.1, kSame = 0.06, kBelow = 6.0;
  double lowest = shape.top_mm();
  Vec3 sum(0.0);
  int count = 0;
  for (double x = shape.low().x; x <= shape.high().x; x += kStep)
    for (double y = shape.low().y; y <= shape.high().y; y += kStep)
      for (double z = shape.top_mm() - kBelow; z < shape.top_mm(); z += kStep / 2) {
        if (shape.distance_mm({x, y, z}) > 0.0) continue;
        if (z < lowest - kSame) sum = Vec3(0.0), count = 0, lowest = z;
        if (z < lowest + kSame) sum += Vec3(x, y, z), ++count;
        break;
      }
  return count == 0 ? Vec3(0.5 * (shape.low() + shape.high()), shape.top_mm()) : sum / static_cast<double>(count);
}

class Painter {
 public:
  Painter(const Scenario& scenario, const Volume& uncut, std::filesystem::path folder)
      : look_(scenario.target, scenario.leeway, uncut.specimen_ptr()), folder_(std::move(folder)), scenery_(scenery_of(scenario.specimen)),
        lines_(look_.lines(uncut)), place_(lowest_place(look_.shape())) {}

  bool draw(const Volume& volume, const std::string& state) const {
    const Vec3 middle(0.5 * (look_.shape().low() + look_.shape().high()), place_.z + 2.0);
    const SectionPlane mesiodistal{{middle.x, place_.y, middle.z}, Vec3(1, 0, 0), Vec3(0, 0, 1)};
    const SectionPlane buccolingual{{place_.x, middle.y, middle.z}, Vec3(0, 1, 0), Vec3(0, 0, 1)};
    return from_above(volume, state) && section(volume, mesiodistal, state + "-md") && section(volume, buccolingual, state + "-bl");
  }

 private:
  std::string file(const std::string& name) const { return (folder_ / (name + ".png")).string(); }

  bool from_above(const Volume& volume, const std::string& name) const {
    const auto context = EglContext::create(2 * kSidePx, 2 * kSidePx);
    const auto picture = context ? ToothPicture::create() : nullptr;
    if (!picture) return false;
    PatchFeed feed(look_.feed());
    feed.build_all(volume);
    for (const BakedPatch& patch : feed.take(~std::size_t{0}).patches) picture->put(patch);
    picture->set_scenery(scenery_.get());
    picture->set_lines(lines_);
    const TargetShape& shape = look_.shape();
    Scene3d scene;
    scene.camera = Camera::about(Vec3(0.5 * (shape.low() + shape.high()), shape.top_mm() - 0.8),
                                 std::max(0.5 * glm::length(shape.high() - shape.low()) + kAroundMm, 4.6));
    scene.camera.set_preset(PresetView::occlusal);
    scene.line_scale = 3.0f;
    picture->draw(scene, context->width(), context->height());
    return write_png(file(name), context->width(), context->height(), context->read_rgba());
  }

  bool section(const Volume& volume, const SectionPlane& plane, const std::string& name) const {
    SectionSettings settings;
    settings.plane = plane;
    settings.width = settings.height = 2 * kSidePx;
    settings.mm_per_px = kSectionMm / settings.width;
    settings.scenery = scenery_;
    look_.put_into(settings);
    const SectionImage image = draw_section(volume, settings);
    std::vector<std::uint8_t> rgba(image.rgba.size() * 4);
    std::memcpy(rgba.data(), image.rgba.data(), rgba.size());
    return write_png(file(name), image.width, image.height, rgba);
  }

  TargetLook look_;
  std::filesystem::path folder_;
  std::shared_ptr<const SceneryLook> scenery_;
  std::vector<OverlayLine> lines_;
  Vec3 place_;
};

Json json_of(const Grade& grade) {
  Json lost = Json::array();
  for (const CriterionGrade& c : grade.criteria)
    if (c.points < c.points_max - 0.05) lost.push_back({{"metric", c.id}, {"value", c.measure.value}, {"points", c.points}, {"of", c.points_max}});
  return {{"score", grade.score}, {"passed", grade.passed}, {"critical", grade.critical}, {"lost", lost}};
}

int failed(const char* what, const std::string& where) {
  std::fprintf(stderr, "cusp-exercise-pictures: %s %s\n", what, where.c_str());
  return 1;
}

int draw_exercise(const Scenario& scenario, const std::filesystem::path& folder) {
  const auto specimen = build_specimen(scenario, {});
  if (!specimen) return failed("no specimen", scenario.key);
  std::filesystem::create_directories(folder);
  const Volume uncut(*specimen);
  const Painter painter(scenario, uncut, folder);
  if (!painter.draw(uncut, "target")) return failed("cannot draw", folder.string());
  Json out = {{"key", scenario.key}, {"title", scenario.title.at("en")}, {"expected_time_s", scenario.expected_time_s}};
  if (scenario.level) out["level"] = kLevelKeys[static_cast<std::size_t>(*scenario.level)];
  const Reference against(scenario, *specimen);
  for (const char* name : {"reference", "novice"}) {
    const auto plan = plan_by_name(name, scenario, **specimen);
    Volume volume(*specimen);
    if (!plan || !cut_along(*plan, scenario, volume)) return failed("no cut by", name);
    if (!painter.draw(volume, name)) return failed("cannot draw", folder.string());
    out[name] = json_of(grade(scenario, measure(against, volume, Process::lasting(1.0, 0.0))));
    out[name]["bur"] = scenario.instruments[plan->bur].name;
  }
  std::ofstream(folder / "exercise.json") << out.dump(1) << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return failed("SCENARIO FOLDER", ""), 2;
  const auto scenario = scenario_of(argv[1]);
  return scenario ? draw_exercise(*scenario, argv[2]) : failed("no such exercise:", argv[1]);
}
