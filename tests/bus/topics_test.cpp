// tests/bus/topics_test.cpp: the table of topics and what becomes of a row in the C API.
#include "bus/topics.hpp"

#include <set>

#include <gtest/gtest.h>

#include "bus/qos.hpp"

namespace teamsight::bus {
namespace {

TEST(Topics, HaveDifferentNamesThatCarryTheVersion) {
  std::set<std::string_view> names;
  for (const TopicProfile& row : all_topics()) {
    EXPECT_TRUE(row.topic.starts_with("teamsight/v1/")) << row.topic;
    names.insert(row.topic);
  }
  EXPECT_EQ(names.size(), kTopics);
}

TEST(Topics, AreFoundByTheirMessage) {
  EXPECT_EQ(topic_profile<RobotState>().topic, "teamsight/v1/RobotState");
  EXPECT_EQ(topic_profile<Truth>().topic, "teamsight/v1/Truth");
  EXPECT_EQ(topic_profile<Sightings>().keep_last, 8);
  EXPECT_EQ(topic_profile<GameState>().delivery, Delivery::kEvent);
  EXPECT_EQ(topic_profile<GameState>().keep_last, 1);
  EXPECT_EQ(topic_profile<Command>().keep_last, 16);
}

TEST(Topics, OnlyTheWorldModelHasAnOwner) {
  for (const TopicProfile& row : all_topics()) {
    EXPECT_EQ(row.exclusive, row.topic == "teamsight/v1/WorldModel") << row.topic;
  }
}

TEST(Topics, HaveALeaseExactlyWhereTheyAreWrittenEveryFrame) {
  const std::set<std::string_view> leased{topic_profile<RobotState>().topic,
                                          topic_profile<Sightings>().topic,
                                          topic_profile<VirtualSensors>().topic,
                                          topic_profile<Odometry>().topic,
                                          topic_profile<WorldModel>().topic,
                                          topic_profile<Truth>().topic};
  for (const TopicProfile& row : all_topics()) {
    EXPECT_EQ(row.leased, leased.contains(row.topic));
  }
}

TEST(Qos, OfStateIsBestEffortVolatileByReceptionWithALeaseByTopic) {
  const QosPointer qos = writer_qos(topic_profile<WorldModel>(), 33);
  dds_reliability_kind_t reliability{};
  dds_durability_kind_t durability{};
  dds_destination_order_kind_t order{};
  dds_liveliness_kind_t liveliness{};
  dds_duration_t lease = 0;
  dds_ownership_kind_t ownership{};
  std::int32_t strength = 0;
  bool autodispose = true;

  ASSERT_TRUE(dds_qget_reliability(qos.get(), &reliability, nullptr));
  ASSERT_TRUE(dds_qget_durability(qos.get(), &durability));
  ASSERT_TRUE(dds_qget_destination_order(qos.get(), &order));
  ASSERT_TRUE(dds_qget_liveliness(qos.get(), &liveliness, &lease));
  ASSERT_TRUE(dds_qget_ownership(qos.get(), &ownership));
  ASSERT_TRUE(dds_qget_ownership_strength(qos.get(), &strength));
  ASSERT_TRUE(dds_qget_writer_data_lifecycle(qos.get(), &autodispose));

  EXPECT_EQ(reliability, DDS_RELIABILITY_BEST_EFFORT);
  EXPECT_EQ(durability, DDS_DURABILITY_VOLATILE);
  EXPECT_EQ(order, DDS_DESTINATIONORDER_BY_RECEPTION_TIMESTAMP);
  EXPECT_EQ(liveliness, DDS_LIVELINESS_MANUAL_BY_TOPIC);
  EXPECT_EQ(lease, DDS_MSECS(200));
  EXPECT_EQ(ownership, DDS_OWNERSHIP_EXCLUSIVE);
  EXPECT_EQ(strength, 33);
  EXPECT_FALSE(autodispose);
}

TEST(Qos, OfAnEventIsReliableAndKeptForWhoJoinsLate) {
  const QosPointer qos = writer_qos(topic_profile<Command>(), 0);
  dds_reliability_kind_t reliability{};
  dds_duration_t blocking = 0;
  dds_durability_kind_t durability{};
  dds_history_kind_t history{};
  std::int32_t depth = 0;
  dds_duration_t lifespan = 0;

  ASSERT_TRUE(dds_qget_reliability(qos.get(), &reliability, &blocking));
  ASSERT_TRUE(dds_qget_durability(qos.get(), &durability));
  ASSERT_TRUE(
      dds_qget_durability_service(qos.get(), nullptr, &history, &depth, nullptr, nullptr, nullptr));
  ASSERT_TRUE(dds_qget_lifespan(qos.get(), &lifespan));

  EXPECT_EQ(reliability, DDS_RELIABILITY_RELIABLE);
  EXPECT_EQ(blocking, DDS_MSECS(50));
  EXPECT_EQ(durability, DDS_DURABILITY_TRANSIENT_LOCAL);
  EXPECT_EQ(history, DDS_HISTORY_KEEP_LAST);
  EXPECT_EQ(depth, 16);
  EXPECT_EQ(lifespan, DDS_SECS(5));
}

}  // namespace
}  // namespace teamsight::bus
