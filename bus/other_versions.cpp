// bus/other_versions.cpp: see bus/other_versions.hpp.
#include "bus/other_versions.hpp"

#include <array>

#include <dds/dds.h>

#include "bus/entity.hpp"
#include "bus/participant_impl.hpp"

namespace teamsight::bus {
namespace {

// A team has about a hundred writers; of more the first are enough.
constexpr std::size_t kMostWriters = 256;

}  // namespace

struct OtherVersions::Impl final : Endpoint {
  explicit Impl(const Participant& participant) : membership(participant.shared(), *this) {
    enter();
  }

  void leave() noexcept override { reader = Entity(); }

  void enter() override {
    reader = Entity(check(dds_create_reader(membership.participant().entity.handle(),
                                            DDS_BUILTIN_TOPIC_DCPSPUBLICATION,
                                            nullptr,
                                            nullptr),
                          "dds_create_reader"));
  }

  Membership membership;
  Entity reader;
};

OtherVersions::OtherVersions(const Participant& participant)
    : impl_(std::make_unique<Impl>(participant)) {}

OtherVersions::~OtherVersions() = default;

std::set<std::string> OtherVersions::present() const {
  std::set<std::string> versions;
  std::array<void*, kMostWriters> samples{};  // all null: the library lends its own
  std::array<dds_sample_info_t, kMostWriters> infos{};
  const dds_entity_t reader = impl_->reader.handle();
  const auto count = dds_read(reader, samples.data(), infos.data(), kMostWriters, kMostWriters);
  for (std::size_t i = 0; count > 0 && i < static_cast<std::size_t>(count); ++i) {
    if (!infos.at(i).valid_data || infos.at(i).instance_state != DDS_IST_ALIVE) continue;
    const auto* writer = static_cast<const dds_builtintopic_endpoint_t*>(samples.at(i));
    versions.insert(version_of(writer->topic_name));
  }
  if (count > 0) dds_return_loan(reader, samples.data(), count);
  versions.erase("");
  versions.erase(kWireVersion);
  return versions;
}

std::string version_of(const std::string& topic) {
  constexpr std::string_view kOurs = "teamsight/";
  const auto end = topic.find('/', kOurs.size());
  if (!topic.starts_with(kOurs) || end == std::string::npos) return {};
  return topic.substr(kOurs.size(), end - kOurs.size());
}

}  // namespace teamsight::bus
