#include "ui/editor/specimen_grower.h"

#include <QPointer>
#include <QThreadPool>
#include <algorithm>

#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/teeth/tooth.h"
#include "scenarios/tissues/tissue_facts.h"
#include "ui/editor/landmark_snap.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

constexpr double kPreviewMm = 0.25, kPreviewedBelowMm = 0.2;  // at most an eighth of the voxels

using Grown = Result<std::shared_ptr<const GrownSpecimen>, ImportFailure>;

/// Voxels of a tissue that touch another one.
std::vector<Vec3> rim_of(const VoxelVolume& volume, Tissue tissue) {
  const IVec3 n = volume.grid.size;
  const auto at = [n](int x, int y, int z) {
    return static_cast<std::size_t>(x) + static_cast<std::size_t>(n.x) * (static_cast<std::size_t>(y) + static_cast<std::size_t>(n.y) * static_cast<std::size_t>(z));
  };
  const auto is = [&](int x, int y, int z) {
    return volume.grid.contains({x, y, z}) && volume.tissue[at(x, y, z)] == tissue && volume.s[at(x, y, z)] >= kHalf;
  };
  std::vector<Vec3> out;
  for (int z = 0; z < n.z; ++z) {
    for (int y = 0; y < n.y; ++y) {
      for (int x = 0; x < n.x; ++x) {
        if (!is(x, y, z)) continue;
        if (is(x - 1, y, z) && is(x + 1, y, z) && is(x, y - 1, z) && is(x, y + 1, z) && is(x, y, z - 1) && is(x, y, z + 1)) continue;
        out.push_back(volume.grid.centre_mm({x, y, z}));
      }
    }
  }
  return out;
}

Grown grow_now(const SpecimenSource& source, Method method, const std::string& folder, const std::atomic<bool>& cancel,
               const ToothProgress& progress) {
  auto out = std::make_shared<GrownSpecimen>();
  out->source = source;
  VoxelVolume volume;
  if (source.generator == "tooth") {
    auto tooth = grow_tooth(tooth_request(source), &cancel, progress);
    if (!tooth) {
      if (tooth.error().code == ToothError::cancelled) return fail(ImportError::cancelled, source.generator);
      // ImportError carries the message for a specimen that cannot be made.
      auto refused = make_specimen(source, folder);
      if (!refused) return std::unexpected(refused.error());
      volume = std::move(*refused);
    } else {
      out->central_mm = tooth->landmarks.central;
      out->landmarks = marks_of(tooth->landmarks);
      volume = std::move(tooth->volume);
    }
  } else {
    auto made = make_specimen(source, folder);
    if (!made) return std::unexpected(made.error());
    volume = std::move(*made);
  }
  out->facts = facts_of(volume);
  out->pulp_mm = rim_of(volume, Tissue::pulp);
  // As build_specimen() of ui/session reads it for this method.
  out->whole = std::make_shared<Volume>(Specimen::build(volume, reading_of(method)));
  return std::shared_ptr<const GrownSpecimen>(std::move(out));
}

}  // namespace

SpecimenGrower::SpecimenGrower(QObject* parent) : QObject(parent) {}

SpecimenGrower::~SpecimenGrower() { cancel(); }

void SpecimenGrower::cancel() {
  if (job_) job_->cancel.store(true);
  job_.reset();
}

void SpecimenGrower::grow(const SpecimenSource& source, Method method, const std::string& folder) {
  cancel();
  job_ = std::make_shared<Job>();
  QThreadPool::globalInstance()->start([job = job_, source, method, folder, self = QPointer<SpecimenGrower>(this)] {
    const auto post = [&](auto answer) {
      QMetaObject::invokeMethod(
          qApp,
          [self, job, answer] {
            if (self && self->job_ == job) answer(*self);
          },
          Qt::QueuedConnection);
    };
    if (source.generator == "tooth" && source.voxel_mm < kPreviewedBelowMm) {
      SpecimenSource coarse = source;
      coarse.voxel_mm = kPreviewMm;
      if (const auto seen = grow_now(coarse, method, folder, job->cancel, {})) {
        post([seen](SpecimenGrower& grower) { Q_EMIT grower.previewed(*seen); });
      }
    }
    const auto made = grow_now(source, method, folder, job->cancel, [&](double share) {
      post([share](SpecimenGrower& grower) { Q_EMIT grower.progressed(share); });
    });
    post([made](SpecimenGrower& grower) {
      grower.job_.reset();
      if (made) {
        Q_EMIT grower.grown(*made);
      } else {
        Q_EMIT grower.failed(made.error());
      }
    });
  });
}

std::vector<ScenarioTissue> usual_tissues(const std::string& generator) {
  for (const std::string_view key : builtin_scenarios()) {
    const auto scenario = load_builtin(key);
    if (!scenario || scenario->specimen.generator != generator) continue;
    // The paper's block has the paper's figures; other specimens have the usual ones.
    if (generator == "paper-block") return scenario->tissues;
    std::vector<Tissue> there;
    for (const ScenarioTissue& t : scenario->tissues) there.push_back(t.tissue);
    return usual_tissues(there);
  }
  return {};
}

std::vector<ScenarioTissue> usual_tissues(const std::vector<Tissue>& tissues) {
  std::vector<ScenarioTissue> out;
  for (const Tissue tissue : tissues) {
    const TissueFacts& facts = tissue_facts(tissue);
    out.push_back({tissue, facts.stiffness_n_per_mm.value, facts.speed_mm_s.value});
  }
  return out;
}

std::optional<double> height_at(const Specimen& specimen, double x_mm, double y_mm) {
  const Grid& grid = specimen.grid();
  const double h = grid.voxel_mm;
  const Vec3 first = grid.centre_mm(IVec3(0));
  const IVec3 at(static_cast<int>(std::lround((x_mm - first.x) / h)), static_cast<int>(std::lround((y_mm - first.y) / h)), 0);
  for (int z = grid.size.z - 1; z >= 0; --z) {
    const IVec3 v(at.x, at.y, z);
    if (!grid.contains(v)) return std::nullopt;
    if (specimen.s(v) >= kHalf) return grid.centre_mm(v).z + h / 2;
  }
  return std::nullopt;
}

}  // namespace cusp::ui
