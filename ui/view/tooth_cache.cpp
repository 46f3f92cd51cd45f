#include "ui/view/tooth_cache.h"

#include <chrono>
#include <thread>
#include <utility>

#include "scenarios/format/content_hash.h"
#include "scenarios/operators/fast_cut.h"
#include "ui/render/mesh_blob.h"
#include "ui/render/target_look.h"
#include "ui/session/plan_blob.h"

namespace cusp::ui {
namespace {

constexpr std::chrono::milliseconds kLook{50};

std::unexpected<SessionFailure> cancelled() {
  return session_fail(SessionError::specimen, ImportFailure{ImportError::cancelled, "tooth", {}});
}

bool is_set(const std::atomic<bool>* stop) { return stop != nullptr && stop->load(); }

std::string_view mesh_name(Guidance guidance) { return guidance == Guidance::full ? "mesh" : "mesh without deviation"; }

/// Only what is generated is the same for equal scenarios: a file may have changed.
bool may_be_kept(const ToothWish& wish) { return wish.specimen == nullptr && !wish.scenario.specimen.generator.empty(); }

/// Of all that a ReadyTooth is made of.
Hash256 key_of(const ToothWish& wish) {
  Blake2b out;
  out.add_hash(SpecimenFiles::key(mesh_name(wish.guidance), wish.scenario)).add_text(content_hash(wish.scenario).hex());
  return out.finish();
}

}  // namespace

std::optional<Plan> ToothCache::reference_path(const ToothWish& wish, const Specimen& specimen, const std::atomic<bool>* stop) const {
  const bool kept = may_be_kept(wish) && SpecimenFiles::keeps(wish.scenario.specimen);
  // The burs count too.
  const Hash256 key = SpecimenFiles::key("reference path " + content_hash(wish.scenario).hex(), wish.scenario);
  if (kept) {
    const auto bytes = files_.files().read(key);
    auto plan = bytes ? plan_from_bytes(*bytes, wish.scenario.instruments.size()) : std::nullopt;
    if (plan) return plan;
  }
  auto plan = plan_by_name("reference", wish.scenario, specimen, stop);
  if (!plan || plan->strokes.empty()) return std::nullopt;
  if (kept) files_.files().keep(key, plan_bytes(*plan));
  return plan;
}

WholeMesh ToothCache::mesh(const ToothWish& wish, const Specimen& specimen, const Volume& whole) const {
  const bool kept = may_be_kept(wish) && SpecimenFiles::keeps(wish.scenario.specimen);
  const Hash256 key = SpecimenFiles::key(mesh_name(wish.guidance), wish.scenario);
  const IVec3 n = specimen.brick_count();
  if (kept) {
    const auto bytes = files_.files().read(key);
    auto mesh = bytes ? mesh_from_bytes(*bytes, static_cast<std::size_t>(n.x * n.y * n.z)) : std::nullopt;
    if (mesh) return std::move(*mesh);
  }
  FeedSettings settings = TargetLook(wish.scenario.target, wish.scenario.leeway, whole.specimen_ptr()).feed();
  if (wish.guidance != Guidance::full) settings.deviation = {};
  WholeMesh built = PatchFeed::build_mesh(whole, settings);
  if (kept) files_.files().keep(key, mesh_bytes(built));
  return built;
}

Outcome<std::shared_ptr<const ReadyTooth>> ToothCache::make(const ToothWish& wish, const std::atomic<bool>* stop,
                                                            const Progress& progress) const {
  const auto report = [&](ToothPart part, double share) {
    if (progress) progress(part, share);
  };
  auto out = std::make_shared<ReadyTooth>();
  const SpecimenSource& source = wish.scenario.specimen;
  // Beside the specimen: a jaw's other teeth take as long as its own.
  std::jthread scenery([&] { out->scenery = scenery_of(source, stop, [&] { return files_.scenery(source, stop); }); });
  auto specimen = wish.specimen ? Outcome<std::shared_ptr<const Specimen>>(wish.specimen)
                                : files_.specimen(wish.scenario, wish.folder, stop, [&](double share) { report(ToothPart::specimen, share); });
  if (!specimen) return std::unexpected(specimen.error());
  out->specimen = *specimen;
  report(ToothPart::mesh, 0);
  std::jthread reference([&] { out->reference = std::make_shared<const Reference>(wish.scenario, out->specimen); });
  if (!is_set(stop)) out->mesh = mesh(wish, *out->specimen, Volume(out->specimen));
  reference.join();
  report(ToothPart::scenery, 0);
  scenery.join();
  if (is_set(stop)) return cancelled();
  return out;
}

Outcome<std::shared_ptr<const ReadyTooth>> ToothCache::tooth(const ToothWish& wish, const std::atomic<bool>* stop,
                                                             const Progress& progress) {
  if (!may_be_kept(wish)) return make(wish, stop, progress);
  const Hash256 key = key_of(wish);
  std::unique_lock lock(mutex_);
  for (;;) {
    if (last_key_ == key) return last_;
    const auto other = making_.find(key);
    if (other == making_.end()) break;
    if (is_set(stop)) return cancelled();
    const Done done = other->second;
    lock.unlock();
    if (progress) progress(done.part, done.share);
    lock.lock();
    if (making_.contains(key)) changed_.wait_for(lock, kLook);
  }
  making_[key] = {};
  lock.unlock();
  auto made = make(wish, stop, [&](ToothPart part, double share) {
    if (progress) progress(part, share);
    const std::lock_guard guard(mutex_);
    making_[key] = {part, share};
  });
  lock.lock();
  making_.erase(key);
  if (made) {
    last_key_ = key;
    last_ = *made;
  }
  changed_.notify_all();
  return made;
}

}  // namespace cusp::ui
