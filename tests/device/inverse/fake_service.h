/// The maker's service in miniature: a WebSocket on loopback that reports its devices first and then answers each
/// message with one report, as public clients have it. A test chooses its faults (Way).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::test {

/// The wireless handle: its orientation and its pressed buttons.
struct FakeHandle {
  Quat orientation{1, 0, 0, 0};
  bool a = false, b = false, c = false;
};

class FakeService {
 public:
  enum class Way : int { answers, silent, garbage, binary, huge, hangs_up, no_device, not_a_websocket };

  FakeService();
  ~FakeService();
  FakeService(const FakeService&) = delete;
  FakeService& operator=(const FakeService&) = delete;

  std::uint16_t port() const noexcept { return port_; }
  void set_way(Way way) noexcept { way_ = static_cast<int>(way); }
  /// Position of the cursor.
  void set_hand(Vec3 position_m) noexcept;
  /// nullopt: there is no handle.
  void set_handle(const std::optional<FakeHandle>& handle) noexcept;

  std::uint64_t messages() const noexcept { return messages_; }
  std::uint64_t connections() const noexcept { return connections_; }
  /// Of the newest message that could be read.
  Vec3 force_n() const;
  double most_force_n() const;

 private:
  struct Inner;
  enum class Message : std::uint8_t { first, later };
  std::string report(Message which) const;
  void hear(const std::string& text);

  std::uint16_t port_ = 0;
  std::atomic<int> way_{0};
  std::atomic<std::uint64_t> messages_{0}, connections_{0};
  mutable std::mutex mutex_;
  Vec3 hand_{0.0, 0.0, 0.1}, force_{0.0};
  double most_force_ = 0;
  std::optional<FakeHandle> handle_;
  std::unique_ptr<Inner> inner_;
};

/// A port that listens and takes nobody: its queue of connections is full.
class FullPort {
 public:
  FullPort();
  ~FullPort();
  std::uint16_t port() const noexcept { return port_; }

 private:
  struct Inner;
  std::uint16_t port_ = 0;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::test
