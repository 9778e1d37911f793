// tools/detection_score.hpp: what was detected against what a person labelled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace teamsight::tools {

/// A ball a person marked; px.
struct LabelledBall {
  double u{0.0};
  double v{0.0};
  double radius{0.0};
  /// Counted when missed: certain and on the field. The others neither help nor harm.
  bool counts{true};
};

/// A robot's or person's contact with the floor, nearest to the image centre; px.
struct LabelledFoot {
  double u{0.0};
  double v{0.0};
  bool counts{true};  ///< certain, not touching the own robot, and not a person
};

struct ImageLabels {
  std::string image;  ///< path below the data folder
  std::vector<LabelledBall> balls;
  std::vector<LabelledFoot> robots;
  std::vector<LabelledFoot> people;
};

/// Reads the hand labels (labels.json of the data folder).
///
/// @throws std::runtime_error naming the file and what is wrong
[[nodiscard]] std::vector<ImageLabels> read_labels(const std::string& path);

/// A place in the image, and whether it lies on the carpet; px.
struct Detection {
  double u{0.0};
  double v{0.0};
  bool on_carpet{true};
};

/// What the labels say of something that was taken for a ball or a robot.
enum class Verdict : std::uint8_t {
  kRight,    ///< nearest to a label, and near enough
  kExcused,  ///< near something that neither helps nor harms
  kWrong,
};

/// Of each labelled ball, or robot, whether a detection is near enough, as in the verdicts;
/// counting or not. A detection is for one label alone.
[[nodiscard]] std::vector<bool> balls_found(const ImageLabels& labels,
                                            const std::vector<Detection>& balls);
[[nodiscard]] std::vector<bool> robots_found(const ImageLabels& labels,
                                             const std::vector<Detection>& obstacles);

/// In the order of `balls`: near enough is within the larger of a ball's radius and 4 px; excused
/// is what is as near to a ball that does not count, or to one that another detection has taken.
[[nodiscard]] std::vector<Verdict> judge_balls(const ImageLabels& labels,
                                               const std::vector<Detection>& balls);

/// In the order of `obstacles`: near enough is within 15 px of a robot's foot; excused is what is
/// within 40 px of a person, or of a robot that does not count.
[[nodiscard]] std::vector<Verdict> judge_robots(const ImageLabels& labels,
                                                const std::vector<Detection>& obstacles);

/// Counts over images.
struct Tally {
  std::size_t labelled{0};  ///< that count
  std::size_t found{0};     ///< of those
  std::size_t right{0};     ///< detections on any label, counting or not
  std::size_t wrong{0};     ///< detections on the carpet on no label
  std::size_t outside{0};   ///< detections off the carpet, where labels are not complete
  std::vector<double> errors_px;

  Tally& operator+=(const Tally& other);

  /// Of what counts; nothing labelled: 1.
  [[nodiscard]] double recall() const;
  /// Counting labels found over those and the false alarms on the carpet.
  [[nodiscard]] double precision() const;
};

/// A ball is found by the nearest detection within the larger of its radius and 4 px.
[[nodiscard]] Tally score_balls(const ImageLabels& labels, const std::vector<Detection>& balls);

/// A robot is found by the nearest detection within 15 px of its foot. Detections within 40 px of a
/// person, or of a robot that does not count, are neither right nor wrong.
[[nodiscard]] Tally score_robots(const ImageLabels& labels,
                                 const std::vector<Detection>& obstacles);

/// A person is found by the nearest obstacle within 40 px that is no labelled robot's: people have
/// two feet and one label. Told as a robot or as legs, both count: it is in the way. Legs within 40
/// px of a robot or of a person are neither right nor wrong.
[[nodiscard]] Tally score_people(const ImageLabels& labels,
                                 const std::vector<Detection>& robots,
                                 const std::vector<Detection>& legs);

/// Of each labelled person, whether an obstacle is near enough, as there.
[[nodiscard]] std::vector<bool> people_found(const ImageLabels& labels,
                                             const std::vector<Detection>& robots,
                                             const std::vector<Detection>& legs);

/// Wilson's interval for `hits` of `trials`, 95 %.
struct Interval {
  double low{0.0};
  double high{1.0};
};

[[nodiscard]] Interval wilson(std::size_t hits, std::size_t trials);

}  // namespace teamsight::tools
