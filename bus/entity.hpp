// bus/entity.hpp: owners for what the DDS C API hands out. For bus/ only.
#pragma once

#include <memory>
#include <utility>

#include <dds/dds.h>

namespace teamsight::bus {

/// Turns a negative return code into a BusError that names the call; returns the code otherwise.
std::int32_t check(std::int32_t code, const char* call);

/// Owns one DDS entity and deletes it. 0 = none.
class Entity {
 public:
  Entity() = default;

  explicit Entity(dds_entity_t handle) noexcept : handle_(handle) {}

  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}

  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }

  Entity(const Entity&) = delete;
  Entity& operator=(const Entity&) = delete;

  ~Entity() {
    if (handle_ > 0) dds_delete(handle_);
  }

  [[nodiscard]] dds_entity_t handle() const noexcept { return handle_; }

 private:
  dds_entity_t handle_{0};
};

struct DeleteQos {
  void operator()(dds_qos_t* qos) const noexcept { dds_delete_qos(qos); }
};

struct DeleteListener {
  void operator()(dds_listener_t* listener) const noexcept { dds_delete_listener(listener); }
};

struct FreeEndpoint {
  void operator()(dds_builtintopic_endpoint_t* endpoint) const noexcept {
    dds_builtintopic_free_endpoint(endpoint);
  }
};

using QosPointer = std::unique_ptr<dds_qos_t, DeleteQos>;
using ListenerPointer = std::unique_ptr<dds_listener_t, DeleteListener>;
using EndpointPointer = std::unique_ptr<dds_builtintopic_endpoint_t, FreeEndpoint>;

}  // namespace teamsight::bus
