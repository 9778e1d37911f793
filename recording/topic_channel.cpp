// recording/topic_channel.cpp: see recording/topic_channel.hpp.
#include "recording/topic_channel.hpp"

#include <set>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include "bus/topics.hpp"
#include "recording/proto_of.hpp"
#include "recording/to_proto.hpp"

namespace teamsight::recording {
namespace {

using google::protobuf::FileDescriptor;
using google::protobuf::FileDescriptorSet;

/// Those it needs come first.
void add_file(const FileDescriptor& file, std::set<std::string>& known, FileDescriptorSet& files) {
  if (!known.insert(file.name()).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) add_file(*file.dependency(i), known, files);
  google::protobuf::FileDescriptorProto& copy = *files.add_file();
  file.CopyTo(&copy);
  file.CopyJsonNameTo(&copy);  // readers of the schema make JSON with these names
}

}  // namespace

Schema schema_of(const google::protobuf::Descriptor& type) {
  FileDescriptorSet files;
  std::set<std::string> known;
  add_file(*type.file(), known, files);
  return {type.full_name(), "protobuf", files.SerializeAsString()};
}

template <class Message>
Channel channel_of() {
  return {std::string(bus::topic_profile<Message>().topic),
          "protobuf",
          schema_of(*ProtoOf<Message>::Type::descriptor())};
}

template <class Message>
std::string payload_of(const Message& message) {
  typename ProtoOf<Message>::Type proto;
  to_proto(message, proto);
  return proto.SerializeAsString();
}

template Channel channel_of<bus::RobotState>();
template Channel channel_of<bus::Sightings>();
template Channel channel_of<bus::VirtualSensors>();
template Channel channel_of<bus::Odometry>();
template Channel channel_of<WorldModel>();
template Channel channel_of<bus::Explanation>();
template Channel channel_of<bus::ClockProbe>();
template Channel channel_of<bus::ClockEcho>();
template Channel channel_of<bus::GameState>();
template Channel channel_of<bus::Command>();
template Channel channel_of<bus::Diagnostics>();
template Channel channel_of<bus::LinePoints>();
template Channel channel_of<bus::Thumbnail>();
template Channel channel_of<bus::Truth>();

template std::string payload_of(const bus::RobotState&);
template std::string payload_of(const bus::Sightings&);
template std::string payload_of(const bus::VirtualSensors&);
template std::string payload_of(const bus::Odometry&);
template std::string payload_of(const WorldModel&);
template std::string payload_of(const bus::Explanation&);
template std::string payload_of(const bus::ClockProbe&);
template std::string payload_of(const bus::ClockEcho&);
template std::string payload_of(const bus::GameState&);
template std::string payload_of(const bus::Command&);
template std::string payload_of(const bus::Diagnostics&);
template std::string payload_of(const bus::LinePoints&);
template std::string payload_of(const bus::Thumbnail&);
template std::string payload_of(const bus::Truth&);

}  // namespace teamsight::recording
