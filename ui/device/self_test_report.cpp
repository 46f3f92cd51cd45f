#include "ui/device/self_test_report.h"

#include <nlohmann/json.hpp>

#include "engine/step/stiffness_rule.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

constexpr double kUsualVoxelMm = 0.1;  // of no matter for a banded scene
constexpr int kReportVersion = 1;

nlohmann::ordered_json number(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

AllowedStiffness allowed_stiffness(const FalconProfile& profile) {
  const StiffnessRule rule = stiffness_rule(limits_of(settings_for(profile)), Method::surface, kUsualVoxelMm);
  return {rule.most_n_per_mm, rule.assumed};
}

QByteArray self_test_report(const ReportedDevice& device, const falcon::SelfTestResult& found, const FalconProfile& profile,
                            const BenchView& bench) {
  nlohmann::ordered_json json;
  json["report"] = "cusp-falcon-self-test";
  json["version"] = kReportVersion;
  json["when_utc"] = device.when.toUTC().toString(Qt::ISODate).toStdString();
  json["station"] = device.station;
  json["device"] = {{"kind", device.kind}, {"name", device.name}, {"firmware_sha256", device.firmware_sha256}};
  const char* names[] = {"x_right", "y_up", "z_to_user"};
  for (std::size_t i = 0; i < found.axes.size(); ++i) {
    const auto& fit = found.axes[i];
    auto& axis = json["axes"][names[i]];
    if (!fit) {
      axis = nullptr;
      continue;
    }
    axis = {{"mass_kg", fit->mass_kg},
            {"damping_ns_per_m", fit->damping_ns_per_m},
            {"damping_error", fit->damping_error},
            {"friction_n", fit->friction_n},
            {"friction_error", fit->friction_error},
            {"weight_n", fit->weight_n},
            {"delay_ms", fit->delay_ms},
            {"delay_error_ms", fit->delay_error_ms},
            {"windows", fit->windows}};
  }
  json["encoders"] = {{"least_counts", found.least_counts}, {"most_counts", found.most_counts}};
  json["readings"] = {{"all", found.readings}, {"missing", found.missing}};
  json["line"] = {{"answers_per_s", bench.answers_per_s},
                  {"late_p50_us", bench.late_p50_us},
                  {"late_p99_us", bench.late_p99_us},
                  {"late_max_us", bench.late_max_us},
                  {"silences", bench.silences},
                  {"lost_answers", bench.lost_answers},
                  {"realtime", bench.grant.realtime()}};
  json["taken_over"] = {{"damping_ns_per_m", number(found.damping_ns_per_m())},
                        {"delay_ms", number(found.delay_ms())},
                        {"friction_n", number(found.friction_n())},
                        {"moving_kg", number(found.moving_kg())},
                        {"encoder_mm", number(found.encoder_mm())}};
  json["station_knows"] = {{"grip_kg", profile.gravity.grip_kg},
                           {"arm_kg_m", profile.gravity.arm_kg_m},
                           {"force_gain", profile.calibration.force_gain},
                           {"scale", profile.scale},
                           {"centre_m", {profile.centre_m.x, profile.centre_m.y, profile.centre_m.z}},
                           {"clutch_button_bit", profile.clutch}};
  json["scenes_may_use_n_per_mm"] = allowed_stiffness(profile).n_per_mm;
  return QByteArray::fromStdString(json.dump(2) + '\n');
}

}  // namespace cusp::ui
