// monitor/operator.hpp: what pages ask for, carried out.
#pragma once

#include <string>

#include "bus/writer.hpp"
#include "monitor/order_desk.hpp"
#include "monitor/referee/referee.hpp"
#include "monitor/station.hpp"
#include "monitor/web_server.hpp"

namespace teamsight::monitor {

/// Takes the pages' orders from the web server. Use from the loop's thread.
class Operator {
 public:
  Operator(WebServer& server,
           Station& station,
           OrderDesk& desk,
           Referee& referee,
           bus::Writer<bus::Command>& commands)
      : server_(&server),
        station_(&station),
        desk_(&desk),
        referee_(&referee),
        commands_(&commands) {}

  /// Reads everything that was said; who is refused is told why.
  void listen(const std::string& token);

  /// Writes again what is not acknowledged yet.
  void repeat();

 private:
  std::string carry_out(const RobotOrder& order);
  std::string carry_out(const RefereeOrder& order);
  std::string carry_out(const BookmarkOrder& order);

  WebServer* server_;
  Station* station_;
  OrderDesk* desk_;
  Referee* referee_;
  bus::Writer<bus::Command>* commands_;
};

}  // namespace teamsight::monitor
