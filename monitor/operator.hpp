// monitor/operator.hpp: what pages ask for, carried out.
#pragma once

#include <string>

#include "bus/writer.hpp"
#include "monitor/order_desk.hpp"
#include "monitor/referee/referee.hpp"
#include "monitor/station.hpp"
#include "monitor/web_server.hpp"
#include "monitor/what_if.hpp"

namespace teamsight::monitor {

/// Takes the pages' orders from the web server. Use from the loop's thread.
class Operator {
 public:
  /// Whom orders go to; all outlive the operator.
  struct Parts {
    WebServer& server;
    Station& station;
    OrderDesk& desk;
    Referee& referee;
    WhatIf& what_if;
    bus::Writer<bus::Command>& commands;
  };

  explicit Operator(const Parts& parts) : parts_(parts) {}

  /// Reads everything that was said; who is refused is told why.
  void listen(const std::string& token);

  /// Writes again what is not acknowledged yet.
  void repeat();

 private:
  std::string carry_out(const RobotOrder& order);
  std::string carry_out(const RefereeOrder& order);
  std::string carry_out(const BookmarkOrder& order);
  std::string carry_out(const WithoutOrder& order);

  Parts parts_;
};

}  // namespace teamsight::monitor
