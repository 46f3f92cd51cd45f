#include "storage/repositories/session_header.h"

#include <nlohmann/json.hpp>
#include <span>

#include "storage/records/trace_codec.h"

namespace cusp::storage {

namespace {
nlohmann::json known(const std::optional<double>& value) { return value ? nlohmann::json(*value) : nlohmann::json(); }
std::optional<double> known_in(const nlohmann::json& in, const char* key) {
  return in.contains(key) && in.at(key).is_number() ? std::optional<double>(in.at(key).get<double>()) : std::nullopt;
}
}  // namespace

std::string header_to_json(const SessionHeader& h) {
  nlohmann::json out = {
      {"engine_version", h.engine_version},
      {"build", h.build},
      {"device",
       {{"name", h.device.name},
        {"class", h.device.device_class},
        {"position_axes", h.device.position_axes},
        {"rotation_axes", h.device.rotation_axes},
        {"max_force_n", h.device.max_force_n},
        {"max_stiffness_n_per_mm", h.device.max_stiffness_n_per_mm},
        {"has_own_clock", h.device.has_own_clock},
        {"closed_loop", h.device.closed_loop},
        {"damping_ns_per_m", known(h.device.damping_ns_per_m)},
        {"delay_ms", known(h.device.delay_ms)},
        {"encoder_mm", known(h.device.encoder_mm)},
        {"softest_grip_ns_per_m", known(h.device.softest_grip_ns_per_m)}}},
      {"stiffness_share", h.stiffness_share},
      {"calibration", h.calibration},
      {"guard",
       {{"limit_n", h.guard.limit_n},
        {"slew_n_per_ms", h.guard.slew_n_per_ms},
        {"ramp_in_ms", h.guard.ramp_in_ms},
        {"jump_mm", h.guard.jump_mm},
        {"late_ms", h.guard.late_ms},
        {"stale_ms", h.guard.stale_ms},
        {"speed_mm_s", h.guard.speed_mm_s},
        {"passivity_mj", h.guard.passivity_mj},
        {"delay_ms", h.guard.delay_ms},
        {"encoder_mm", h.guard.encoder_mm},
        {"coupling_ns_per_m", h.guard.coupling_ns_per_m},
        {"parts", h.guard.parts}}},
      {"specimen_hash", h.specimen_hash},
      {"specimen_blob", hex(h.specimen_blob)},
      {"scene", h.scene},
  };
  if (h.extra_time_percent > 0) out["extra_time_percent"] = h.extra_time_percent;
  if (h.large_text) out["large_text"] = true;
  if (!h.exercise.empty()) out["exercise"] = h.exercise;
  return out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::optional<SessionHeader> header_from_json(const std::string& text) {
  try {
    using nlohmann::json;
    const json in = json::parse(text);
    SessionHeader h;
    in.at("engine_version").get_to(h.engine_version);
    in.at("build").get_to(h.build);
    const json& device = in.at("device");
    device.at("name").get_to(h.device.name);
    device.at("class").get_to(h.device.device_class);
    device.at("position_axes").get_to(h.device.position_axes);
    device.at("rotation_axes").get_to(h.device.rotation_axes);
    device.at("max_force_n").get_to(h.device.max_force_n);
    device.at("max_stiffness_n_per_mm").get_to(h.device.max_stiffness_n_per_mm);
    device.at("has_own_clock").get_to(h.device.has_own_clock);
    // Written since engine version 3, as is what follows for the guard: the replay of an older session is refused before
    // they matter.
    h.device.closed_loop = device.value("closed_loop", h.device.closed_loop);
    h.device.damping_ns_per_m = known_in(device, "damping_ns_per_m");
    h.device.delay_ms = known_in(device, "delay_ms");
    h.device.encoder_mm = known_in(device, "encoder_mm");
    h.device.softest_grip_ns_per_m = known_in(device, "softest_grip_ns_per_m");
    h.stiffness_share = in.value("stiffness_share", h.stiffness_share);
    in.at("calibration").get_to(h.calibration);
    const json& guard = in.at("guard");
    guard.at("limit_n").get_to(h.guard.limit_n);
    guard.at("slew_n_per_ms").get_to(h.guard.slew_n_per_ms);
    guard.at("ramp_in_ms").get_to(h.guard.ramp_in_ms);
    guard.at("jump_mm").get_to(h.guard.jump_mm);
    guard.at("late_ms").get_to(h.guard.late_ms);
    h.guard.stale_ms = guard.value("stale_ms", h.guard.stale_ms);
    h.guard.speed_mm_s = guard.value("speed_mm_s", h.guard.speed_mm_s);
    h.guard.passivity_mj = guard.value("passivity_mj", h.guard.passivity_mj);
    h.guard.delay_ms = guard.value("delay_ms", h.guard.delay_ms);
    h.guard.encoder_mm = guard.value("encoder_mm", h.guard.encoder_mm);
    h.guard.coupling_ns_per_m = guard.value("coupling_ns_per_m", h.guard.coupling_ns_per_m);
    h.guard.parts = guard.value("parts", h.guard.parts);
    in.at("specimen_hash").get_to(h.specimen_hash);
    const auto blob = hash_from_hex(in.at("specimen_blob").get<std::string>());
    if (!blob) return std::nullopt;
    h.specimen_blob = *blob;
    in.at("scene").get_to(h.scene);
    h.extra_time_percent = in.value("extra_time_percent", h.extra_time_percent);
    h.large_text = in.value("large_text", h.large_text);
    h.exercise = in.value("exercise", h.exercise);
    return h;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::string keep_header(Transaction& transaction, const SessionHeader& header) {
  const std::string json = header_to_json(header);
  const Hash256 hash = blake2b_256(json);
  // The hash names the content: a damaged row is put right, for many sessions share it.
  transaction.run("INSERT INTO blobs (hash, packed) VALUES (?1, ?2) ON CONFLICT (hash) DO UPDATE SET packed = excluded.packed "
                  "WHERE packed <> excluded.packed", hash, pack(std::as_bytes(std::span(json))));
  return hex(hash);
}

Stored<SessionHeader> read_header(Database& db, const std::string& column) {
  std::string json = column;
  if (const auto hash = hash_from_hex(column)) {
    const auto packed = db.first("SELECT packed FROM blobs WHERE hash = ?1", [](Row row) { return row.blob(0); }, *hash);
    if (!packed) return std::unexpected(packed.error());
    if (!*packed) return fail(StorageError::corrupt, "sessions", "header");
    const auto bytes = unpack(**packed);
    if (!bytes || blake2b_256(*bytes) != *hash) return fail(StorageError::corrupt, "sessions", "header");
    json.assign(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  }
  auto header = header_from_json(json);
  if (!header) return fail(StorageError::corrupt, "sessions", "header");
  return std::move(*header);
}

}  // namespace cusp::storage
