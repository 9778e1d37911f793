// bus/qos.cpp: the settings; each surprise behind them is named beside it.
#include "bus/qos.hpp"

namespace teamsight::bus {
namespace {

// More than there are robots or processes: a babbler with ever new keys cannot fill the memory.
constexpr std::int32_t kMaxInstances = 256;

QosPointer common_qos(const TopicProfile& profile, Duration lease) {
  QosPointer qos(dds_create_qos());
  const bool event = profile.delivery == Delivery::kEvent;
  dds_qset_reliability(qos.get(),
                       event ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       kMaxBlocking.count());
  dds_qset_durability(qos.get(), event ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, profile.keep_last);
  // By source, one step back of a sender's wall clock silences it for good.
  dds_qset_destination_order(qos.get(), DDS_DESTINATIONORDER_BY_RECEPTION_TIMESTAMP);
  dds_qset_ownership(qos.get(), profile.exclusive ? DDS_OWNERSHIP_EXCLUSIVE : DDS_OWNERSHIP_SHARED);
  // By topic and by hand: writing is the sign of life. The automatic kind is given by the library's
  // own threads, so a process that hangs would own its topic for ever.
  if (profile.leased) {
    dds_qset_liveliness(qos.get(), DDS_LIVELINESS_MANUAL_BY_TOPIC, lease.count());
  } else {
    dds_qset_liveliness(qos.get(), DDS_LIVELINESS_AUTOMATIC, DDS_INFINITY);
  }
  dds_qset_ignorelocal(qos.get(), DDS_IGNORELOCAL_PARTICIPANT);
  return qos;
}

}  // namespace

QosPointer reader_qos(const TopicProfile& profile, const Surroundings& around) {
  QosPointer qos = common_qos(profile, around.lease);
  if (!around.partition.empty()) dds_qset_partition1(qos.get(), "*");
  dds_qset_resource_limits(qos.get(), DDS_LENGTH_UNLIMITED, kMaxInstances, DDS_LENGTH_UNLIMITED);
  return qos;
}

QosPointer writer_qos(const TopicProfile& profile,
                      std::int32_t ownership_strength,
                      const Surroundings& around) {
  QosPointer qos = common_qos(profile, around.lease);
  if (!around.partition.empty()) dds_qset_partition1(qos.get(), around.partition.c_str());
  // Who leaves is silent, not disposed: its last value stays what it was.
  dds_qset_writer_data_lifecycle(qos.get(), false);
  if (profile.exclusive) dds_qset_ownership_strength(qos.get(), ownership_strength);
  if (profile.lifespan > Duration{0}) dds_qset_lifespan(qos.get(), profile.lifespan.count());
  if (profile.delivery == Delivery::kEvent) {
    // What a late joiner gets is this depth, not that of the history.
    dds_qset_durability_service(qos.get(),
                                0,
                                DDS_HISTORY_KEEP_LAST,
                                profile.keep_last,
                                DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED);
  }
  return qos;
}

}  // namespace teamsight::bus
