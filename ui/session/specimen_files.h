/// Specimens and sceneries that are grown once and then read: files (grown_files.h) under what generates them and the build of the
/// program, so that what is read equals what is grown, bit for bit. Immutable; any thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "scenarios/format/scenario.h"
#include "scenarios/teeth/tooth.h"
#include "ui/session/grown_files.h"
#include "ui/session/scene_builder.h"

namespace cusp::ui {

class SpecimenFiles {
 public:
  /// About a hundred teeth with neighbours and gums.
  static constexpr std::uint64_t kMostBytes = std::uint64_t{512} << 20;

  /// `folder`: of the user's cache; empty keeps nothing.
  explicit SpecimenFiles(std::filesystem::path folder, std::uint64_t most_bytes = kMostBytes)
      : files_(std::move(folder), most_bytes) {}

  /// As build_specimen(). `progress`: rising shares in [0, 1] while a tooth grows, on the calling thread.
  Outcome<std::shared_ptr<const Specimen>> specimen(const Scenario& scenario, const std::filesystem::path& folder,
                                                    const std::atomic<bool>* stop = nullptr, const ToothProgress& progress = {}) const;
  /// As make_scenery().
  Result<std::vector<JawSurface>, ImportFailure> scenery(const SpecimenSource& source, ToothCancel cancel = nullptr) const;

  /// Whether what comes of this source is kept: teeth, which take seconds to grow.
  static bool keeps(const SpecimenSource& source);
  /// Of `what` that this build of the program computes from specimen, target and leeway of a scenario.
  static Hash256 key(std::string_view what, const Scenario& scenario);
  const GrownFiles& files() const noexcept { return files_; }

 private:
  GrownFiles files_;
};

}  // namespace cusp::ui
