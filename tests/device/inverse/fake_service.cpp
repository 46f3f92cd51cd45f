#include "tests/device/inverse/fake_service.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>
#include <thread>

namespace cusp::test {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;

struct FullPort::Inner {
  asio::io_context context{1};
  tcp::acceptor acceptor{context};
  std::vector<tcp::socket> waiting;
};

FullPort::FullPort() : inner_(std::make_unique<Inner>()) {
  const tcp::endpoint any(asio::ip::address_v4::loopback(), 0);
  inner_->acceptor.open(any.protocol());
  inner_->acceptor.bind(any);
  inner_->acceptor.listen(0);
  const tcp::endpoint here = inner_->acceptor.local_endpoint();
  port_ = here.port();
  inner_->waiting.reserve(4);
  for (int i = 0; i < 4; ++i) inner_->waiting.emplace_back(inner_->context).async_connect(here, [](error_code) {});
}

FullPort::~FullPort() = default;

struct FakeService::Inner {
  struct Line : std::enable_shared_from_this<Line> {
    Line(FakeService& s, tcp::socket socket) : service(s), stream(std::move(socket)) {}
    FakeService& service;
    websocket::stream<tcp::socket> stream;
    boost::beast::flat_buffer in;
    std::string out;

    void start() {
      stream.async_accept([self = shared_from_this()](error_code error) {
        if (error) return;
        ++self->service.connections_;
        self->send(self->service.report(Message::first));
      });
    }
    void send(std::string text) {
      out = std::move(text);
      const Way way = static_cast<Way>(service.way_.load());
      if (way == Way::silent) return listen();
      if (way == Way::garbage) out = out.substr(0, out.size() / 2);
      if (way == Way::huge) out.insert(1, std::string(200'000, ' '));
      if (way == Way::hangs_up) {
        error_code ignored;
        stream.next_layer().close(ignored);
        return;
      }
      stream.binary(way == Way::binary);
      if (way == Way::binary) out = std::string("\x00\xff\x01", 3);
      stream.async_write(asio::buffer(out), [self = shared_from_this()](error_code error, std::size_t) {
        if (!error) self->listen();
      });
    }
    void listen() {
      stream.async_read(in, [self = shared_from_this()](error_code error, std::size_t) {
        if (error) return;
        self->service.hear(boost::beast::buffers_to_string(self->in.data()));
        self->in.consume(self->in.size());
        self->send(self->service.report(Message::later));
      });
    }
  };

  explicit Inner(FakeService& s)
      : service(s), acceptor(context, tcp::endpoint(asio::ip::address_v4::loopback(), 0)) {}
  void accept() {
    acceptor.async_accept([this](error_code error, tcp::socket socket) {
      if (error) return;
      if (static_cast<Way>(service.way_.load()) == Way::not_a_websocket) {
        asio::write(socket, asio::buffer(std::string("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n")), error);
      } else {
        std::make_shared<Line>(service, std::move(socket))->start();
      }
      accept();
    });
  }

  FakeService& service;
  asio::io_context context{1};
  tcp::acceptor acceptor;
  std::thread thread;
};

FakeService::FakeService() : inner_(std::make_unique<Inner>(*this)) {
  port_ = inner_->acceptor.local_endpoint().port();
  inner_->accept();
  inner_->thread = std::thread([inner = inner_.get()] { inner->context.run(); });
}

FakeService::~FakeService() {
  inner_->context.stop();
  inner_->thread.join();
}

void FakeService::set_hand(Vec3 position_m) noexcept {
  const std::lock_guard lock(mutex_);
  hand_ = position_m;
}

void FakeService::set_handle(const std::optional<FakeHandle>& handle) noexcept {
  const std::lock_guard lock(mutex_);
  handle_ = handle;
}

Vec3 FakeService::force_n() const {
  const std::lock_guard lock(mutex_);
  return force_;
}

double FakeService::most_force_n() const {
  const std::lock_guard lock(mutex_);
  return most_force_;
}

std::string FakeService::report(Message which) const {
  const std::lock_guard lock(mutex_);
  nlohmann::json out;
  out["inverse3"] = nlohmann::json::array();
  if (static_cast<Way>(way_.load()) != Way::no_device) {
    nlohmann::json device;
    device["device_id"] = "049D";
    if (which == Message::first) device["config"] = {{"type", "inverse3"}, {"handedness", "right"}};
    device["state"]["cursor_position"] = {{"x", hand_.x}, {"y", hand_.y}, {"z", hand_.z}};
    device["state"]["cursor_velocity"] = {{"x", 0}, {"y", 0}, {"z", 0}};
    out["inverse3"].push_back(std::move(device));
  }
  out["wireless_verse_grip"] = nlohmann::json::array();
  if (handle_) {
    nlohmann::json handle;
    handle["device_id"] = "61573";
    const Quat& q = handle_->orientation;
    handle["state"]["orientation"] = {{"x", q.x}, {"y", q.y}, {"z", q.z}, {"w", q.w}};
    handle["state"]["buttons"] = {{"a", handle_->a}, {"b", handle_->b}, {"c", handle_->c}};
    out["wireless_verse_grip"].push_back(std::move(handle));
  }
  return out.dump();
}

void FakeService::hear(const std::string& text) {
  ++messages_;
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return;
  const auto& values = json["inverse3"][0]["commands"]["set_cursor_force"]["values"];
  const std::lock_guard lock(mutex_);
  force_ = {values["x"].get<double>(), values["y"].get<double>(), values["z"].get<double>()};
  most_force_ = std::max(most_force_, glm::length(force_));
}

}  // namespace cusp::test
