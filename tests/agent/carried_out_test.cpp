// tests/agent/carried_out_test.cpp: a command that comes again is known.
#include "agent/carried_out.hpp"

#include <gtest/gtest.h>

namespace teamsight::agent {
namespace {

bus::Command command_of(std::uint32_t boot, std::uint32_t number) {
  bus::Command command;
  command.id.boot = boot;
  command.command = number;
  return command;
}

TEST(CarriedOut, KnowsWhatANewerCommandHasOvertaken) {
  CarriedOut done;
  done.note(command_of(5, 11));
  done.note(command_of(5, 12));

  EXPECT_TRUE(done.has(command_of(5, 11)));
  EXPECT_TRUE(done.has(command_of(5, 12)));
  EXPECT_FALSE(done.has(command_of(5, 13)));
}

TEST(CarriedOut, TellsStationsApart) {
  CarriedOut done;
  done.note(command_of(5, 11));

  EXPECT_FALSE(done.has(command_of(6, 11)));
}

}  // namespace
}  // namespace teamsight::agent
