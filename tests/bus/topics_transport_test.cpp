// tests/bus/topics_transport_test.cpp: every topic between two participants: values, QoS, sizes.
#include <cstdio>
#include <memory>
#include <type_traits>

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <gtest/gtest.h>

#include "bus/qos.hpp"
#include "bus/topics.hpp"
#include "bus/wire.hpp"
#include "bus/writer.hpp"
#include "tests/bus/samples.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

using testing::full;
using testing::kPatience;
using testing::own_domain;
using testing::take_until;
using testing::wait_until;

using AllMessages = ::testing::Types<RobotState,
                                     Sightings,
                                     VirtualSensors,
                                     Odometry,
                                     WorldModel,
                                     Explanation,
                                     ClockProbe,
                                     ClockEcho,
                                     GameState,
                                     Command,
                                     Diagnostics,
                                     LinePoints,
                                     Thumbnail,
                                     Truth>;

template <class Message>
class EveryTopic : public ::testing::Test {
 protected:
  DomainSettings domain_ = own_domain();
  Participant here_ = Participant::join(domain_);
  Participant there_ = Participant::join(domain_);
};

TYPED_TEST_SUITE(EveryTopic, AllMessages);

TYPED_TEST(EveryTopic, ArrivesUnchanged) {
  Writer<TypeParam> writer(this->here_);
  Reader<TypeParam> reader(this->there_);
  ASSERT_TRUE(wait_until([&] { return writer.live_readers() == 1; }, kPatience));
  std::vector<Sample<TypeParam>> got;

  ASSERT_EQ(writer.write(full<TypeParam>()), WriteStatus::kWritten);
  take_until(
      reader, [&](const auto& s) { got.push_back(s); }, [&] { return !got.empty(); });

  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].message, full<TypeParam>());
  EXPECT_EQ(got[0].presence, Presence::kAlive);
  EXPECT_EQ(reader.live_writers(), 1U);
  EXPECT_EQ(reader.counters().accepted, 1U);
  EXPECT_EQ(writer.counters().written, 1U);
}

TYPED_TEST(EveryTopic, IsNotHeardByItsOwnParticipant) {
  Writer<TypeParam> writer(this->here_);
  Reader<TypeParam> own(this->here_);
  Reader<TypeParam> other(this->there_);
  ASSERT_TRUE(wait_until([&] { return writer.live_readers() == 1; }, kPatience));
  std::size_t heard = 0;

  ASSERT_EQ(writer.write(full<TypeParam>()), WriteStatus::kWritten);
  take_until(
      other, [&](const auto&) { ++heard; }, [&] { return heard > 0; });

  EXPECT_EQ(own.take(host_now(), [](const auto&) {}), 0U);
}

TYPED_TEST(EveryTopic, ArrivesFromAnotherProcess) {
  Reader<TypeParam> reader(this->here_);
  const test::ChildProcess child = testing::start_child("every topic", this->domain_);
  std::vector<Sample<TypeParam>> got;

  take_until(
      reader, [&](const auto& s) { got.push_back(s); }, [&] { return !got.empty(); });

  ASSERT_FALSE(got.empty()) << child.err();
  ASSERT_TRUE(got[0].message);
  TypeParam expected = full<TypeParam>();
  expected.id.sequence = got[0].message->id.sequence;
  EXPECT_EQ(got[0].message, expected);
}

/// An endpoint of another participant, as it was announced on the bus.
struct DeleteEndpoint {
  void operator()(dds_builtintopic_endpoint_t* endpoint) const {
    dds_builtintopic_free_endpoint(endpoint);
  }
};

using Announced = std::unique_ptr<dds_builtintopic_endpoint_t, DeleteEndpoint>;

void expect_row(const dds_builtintopic_endpoint_t& endpoint, const TopicProfile& row) {
  dds_reliability_kind_t reliability{};
  dds_durability_kind_t durability{};
  dds_liveliness_kind_t liveliness{};
  dds_duration_t lease = 0;
  dds_ownership_kind_t ownership{};
  dds_destination_order_kind_t order{};
  dds_qget_reliability(endpoint.qos, &reliability, nullptr);
  dds_qget_durability(endpoint.qos, &durability);
  dds_qget_liveliness(endpoint.qos, &liveliness, &lease);
  dds_qget_ownership(endpoint.qos, &ownership);
  dds_qget_destination_order(endpoint.qos, &order);

  const bool event = row.delivery == Delivery::kEvent;
  const bool leased = row.leased;
  EXPECT_EQ(endpoint.topic_name, row.topic);
  EXPECT_EQ(reliability, event ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT);
  EXPECT_EQ(durability, event ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  EXPECT_EQ(liveliness, leased ? DDS_LIVELINESS_MANUAL_BY_TOPIC : DDS_LIVELINESS_AUTOMATIC);
  EXPECT_EQ(lease, leased ? kDefaultLease.count() : DDS_INFINITY);
  EXPECT_EQ(ownership, row.exclusive ? DDS_OWNERSHIP_EXCLUSIVE : DDS_OWNERSHIP_SHARED);
  EXPECT_EQ(order, DDS_DESTINATIONORDER_BY_RECEPTION_TIMESTAMP);
}

TYPED_TEST(EveryTopic, IsWrittenByAnotherProcessWithTheQosOfItsRow) {
  const TopicProfile& row = topic_profile<TypeParam>();
  const Entity topic(dds_create_topic(this->here_.handle(),
                                      &topic_descriptor<TypeParam>(),
                                      std::string(row.topic).c_str(),
                                      nullptr,
                                      nullptr));
  const QosPointer qos = reader_qos(row);
  const Entity reader(dds_create_reader(this->here_.handle(), topic.handle(), qos.get(), nullptr));
  const test::ChildProcess child = testing::start_child("every topic", this->domain_);
  dds_instance_handle_t writer = 0;
  ASSERT_TRUE(wait_until(
      [&] { return dds_get_matched_publications(reader.handle(), &writer, 1) == 1; }, kPatience));

  const Announced announced(dds_get_matched_publication_data(reader.handle(), writer));

  ASSERT_TRUE(announced);
  expect_row(*announced, row);
  dds_duration_t lifespan = 0;
  dds_qget_lifespan(announced->qos, &lifespan);
  EXPECT_EQ(lifespan, row.lifespan > Duration{0} ? row.lifespan.count() : DDS_INFINITY);
}

TYPED_TEST(EveryTopic, IsReadWithTheQosOfItsRow) {
  const TopicProfile& row = topic_profile<TypeParam>();
  const Reader<TypeParam> reader(this->there_);
  const Entity topic(dds_create_topic(this->here_.handle(),
                                      &topic_descriptor<TypeParam>(),
                                      std::string(row.topic).c_str(),
                                      nullptr,
                                      nullptr));
  const QosPointer qos = writer_qos(row, 1);
  const Entity writer(dds_create_writer(this->here_.handle(), topic.handle(), qos.get(), nullptr));
  dds_instance_handle_t matched = 0;
  ASSERT_TRUE(wait_until(
      [&] { return dds_get_matched_subscriptions(writer.handle(), &matched, 1) == 1; }, kPatience));

  const Announced announced(dds_get_matched_subscription_data(writer.handle(), matched));

  ASSERT_TRUE(announced);
  expect_row(*announced, row);
}

/// How many bytes a message takes on the wire: the library's own encoding, with its header.
template <class Message>
std::size_t encoded_size(const Participant& from, const Participant& to) {
  const TopicProfile& row = topic_profile<Message>();
  const Entity topic(dds_create_topic(
      to.handle(), &topic_descriptor<Message>(), std::string(row.topic).c_str(), nullptr, nullptr));
  const QosPointer qos = reader_qos(row);
  const Entity reader(dds_create_reader(to.handle(), topic.handle(), qos.get(), nullptr));
  Writer<Message> writer(from);
  (void)wait_until([&] { return writer.live_readers() == 1; }, kPatience);
  writer.write(full<Message>());
  ddsi_serdata* data = nullptr;
  dds_sample_info_t info;
  (void)wait_until(
      [&] { return dds_takecdr(reader.handle(), &data, 1, &info, DDS_ANY_STATE) == 1; }, kPatience);
  if (data == nullptr) return 0;
  const std::size_t size = ddsi_serdata_size(data);
  ddsi_serdata_unref(data);
  return size;
}

// RTPS header 20, timestamp 12, data submessage 24: in front of each sample's encoding.
constexpr std::size_t kRtpsOverhead = 56;
constexpr std::size_t kOneDatagram = 1300;

TYPED_TEST(EveryTopic, FitsOneDatagramAtItsBounds) {
  const std::size_t size = encoded_size<TypeParam>(this->here_, this->there_) + kRtpsOverhead;
  this->RecordProperty("datagram_bytes", static_cast<int>(size));
  std::printf("%s: %zu bytes\n", std::string(topic_profile<TypeParam>().topic).c_str(), size);

  ASSERT_GT(size, kRtpsOverhead);
  if constexpr (std::is_same_v<TypeParam, Thumbnail>) {
    EXPECT_GT(size, kOneDatagram);  // the one that is cut into many: rare, and only while asked for
  } else {
    EXPECT_LE(size, kOneDatagram);
  }
}

}  // namespace
}  // namespace teamsight::bus
