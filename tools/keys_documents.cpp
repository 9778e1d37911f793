// tools/keys_documents.cpp: see keys_documents.hpp. The format is that of DDS Security 1.1,
// chapter 9.4.
#include "tools/keys_documents.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "bus/topics.hpp"

namespace teamsight::tools {
namespace {

// Said by the coach station only. Everything else is said by robots.
constexpr std::array<std::string_view, 2> kOrders{"teamsight/v1/GameState", "teamsight/v1/Command"};
// Said by both.
constexpr std::array<std::string_view, 3> kByAll{
    "teamsight/v1/Diagnostics", "teamsight/v1/ClockProbe", "teamsight/v1/ClockEcho"};

constexpr const char* kDomains =
    "<domains><id_range><min>0</min><max>230</max></id_range></domains>";

bool may_write(Speaker speaker, std::string_view topic) {
  if (std::ranges::find(kByAll, topic) != kByAll.end()) return true;
  const bool is_order = std::ranges::find(kOrders, topic) != kOrders.end();
  return is_order == (speaker.robot == kNobody);
}

}  // namespace

std::string name_of(Speaker speaker) {
  return speaker.robot == kNobody ? "coach" : "robot" + std::to_string(speaker.robot);
}

std::string governance_document() {
  return std::string(R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="https://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_governance.xsd">
  <domain_access_rules>
    <domain_rule>
      )") +
         kDomains + R"(
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>NONE</discovery_protection_kind>
      <liveliness_protection_kind>NONE</liveliness_protection_kind>
      <rtps_protection_kind>SIGN</rtps_protection_kind>
      <topic_access_rules>
        <topic_rule>
          <topic_expression>*</topic_expression>
          <enable_discovery_protection>false</enable_discovery_protection>
          <enable_liveliness_protection>false</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>NONE</metadata_protection_kind>
          <data_protection_kind>NONE</data_protection_kind>
        </topic_rule>
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
)";
}

std::string permissions_document(Speaker speaker,
                                 const std::string& subject,
                                 const std::string& not_before,
                                 const std::string& not_after) {
  std::string topics;
  for (const bus::TopicProfile& row : bus::all_topics()) {
    if (!may_write(speaker, row.topic)) continue;
    topics += "            <topic>" + std::string(row.topic) + "</topic>\n";
  }
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="https://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_permissions.xsd">
  <permissions>
    <grant name=")" +
         name_of(speaker) + R"(">
      <subject_name>)" +
         subject + R"(</subject_name>
      <validity>
        <not_before>)" +
         not_before + R"(</not_before>
        <not_after>)" +
         not_after + R"(</not_after>
      </validity>
      <allow_rule>
        )" +
         kDomains +
         R"(
        <publish>
          <topics>
)" + topics +
         R"(          </topics>
          <partitions>
            <partition>)" +
         name_of(speaker) + R"(</partition>
          </partitions>
        </publish>
        <subscribe>
          <topics>
            <topic>*</topic>
          </topics>
          <partitions>
            <partition>*</partition>
          </partitions>
        </subscribe>
      </allow_rule>
      <default>DENY</default>
    </grant>
  </permissions>
</dds>
)";
}

}  // namespace teamsight::tools
