// bench/camera_play/camera_eyes.hpp: a made-up game seen through rendered cameras.
#pragma once

#include <cstdint>
#include <memory>

#include "bench/play/eyes.hpp"
#include "bench/play/scenario.hpp"
#include "geometry/field_model.hpp"
#include "sim/render/renderer.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::camera_play {

/// What the robots see with.
struct CameraSetup {
  vision::CameraParameters camera;  ///< as their camera files say
  FieldModel field;                 ///< as large as play::play_field()
  /// How carefully it is drawn; body: that of the league's robots if there is none.
  sim::PictureParameters picture;
};

/// Whether that fault can be made with that camera. A bumped mirror needs one of known shape.
[[nodiscard]] bool can_have(play::Fault fault, const vision::CameraParameters& camera);

/// Each robot's frame is rendered as its own eye sees the moment, and goes through the same
/// perception and localisation as in teamsight-agent; only threads and topics are missing. Searches
/// of the whole field answer before the next frame. Wheels count with the simulator's errors.
///
/// The eyes differ from the camera file by what a calibration leaves, each robot's in its own way.
/// Everybody is told where it stands, as roughly as a person can, and looks around for half a
/// second before the first moment. Nobody hears what the team says of its half.
///
/// - kMirrored: it was told the mirror image.
/// - kKidnapped: it looked around elsewhere and was carried to its place with its eyes covered.
/// - kBiased: its mirror was bumped, by three degrees, after the calibration.
class CameraEyes final : public play::Eyes {
 public:
  /// @pre the scenario's faults begin with the play, and this camera can have them
  CameraEyes(const CameraSetup& setup, const play::Scenario& scenario, std::uint64_t seed);
  ~CameraEyes() override;
  CameraEyes(const CameraEyes&) = delete;
  CameraEyes& operator=(const CameraEyes&) = delete;
  CameraEyes(CameraEyes&&) = delete;
  CameraEyes& operator=(CameraEyes&&) = delete;

  void set_fault(std::size_t robot, play::Fault fault, const play::Moment& moment) override;
  void begin(const play::Moment& first) override;
  void step(const play::Moment& moment) override;
  [[nodiscard]] play::Frame look(std::size_t robot,
                                 const play::Moment& moment,
                                 double since) override;

 private:
  struct Team;
  std::unique_ptr<Team> team_;
};

}  // namespace teamsight::camera_play
