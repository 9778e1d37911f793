// fusion/aside.cpp: see fusion/aside.hpp.
#include "fusion/aside.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "fusion/track.hpp"

namespace teamsight::fusion {
namespace {

std::size_t index_of(RobotId robot) {
  return static_cast<std::size_t>(robot) - 1U;
}

double squared_distance(const Eigen::Vector2d& gap, const Eigen::Matrix2d& cov) {
  return gap.dot(cov.inverse() * gap);
}

double density_of(const Eigen::Vector2d& gap, const Eigen::Matrix2d& cov) {
  return tail_density(squared_distance(gap, cov), cov.inverse());
}

}  // namespace

/// Goes on to `exposure`: evidence fades, and a bias may have become another.
void AsideBook::turn_page(Page& page, HostTime exposure, const TrustParameters& parameters) {
  const double most_var = parameters.sigma_bias * parameters.sigma_bias;
  if (page.time == kNever) {
    page.time = exposure;
    page.cov = most_var * Eigen::Matrix2d::Identity();
    return;
  }
  const double dt = std::max(0.0, to_seconds(exposure - page.time));
  const double keep = std::exp(-dt / to_seconds(parameters.memory));
  page.time = std::max(page.time, exposure);
  page.cov = keep * keep * page.cov + (1.0 - keep * keep) * most_var * Eigen::Matrix2d::Identity();
  page.watched *= keep;
  for (double& own : page.own) own *= keep;
}

/// What one sighting says of one of its robots, which stands aside by `sighting.gap` if it does.
void AsideBook::weigh(Page& page,
                      double& evidence,
                      const MateSighting& sighting,
                      double share,
                      const Parameters& parameters) const {
  const TrustParameters& trust = parameters.trust;
  turn_page(page, sighting.exposure, trust);
  const double other = parameters.teammate.other_density;
  const Eigen::Vector2d surprise = sighting.gap - page.mean;
  const Eigen::Matrix2d cov_aside = page.cov + sighting.cov;
  const double aside = density_of(surprise, cov_aside);
  const double odds = std::log((aside + other) / (density_of(sighting.gap, sighting.cov) + other));
  evidence =
      std::clamp(evidence + share * std::clamp(odds, -trust.most_against, trust.most_against),
                 -trust.contradiction,
                 trust.contradiction);
  const double wider =
      tail_factor(squared_distance(surprise, cov_aside), 2) * (1.0 + other / aside);
  const Eigen::Matrix2d noise = wider / share * sighting.cov;
  const Eigen::Matrix2d gain = page.cov * (page.cov + noise).inverse();
  page.mean += gain * surprise;
  const Eigen::Matrix2d left = page.cov - gain * page.cov;
  page.cov = 0.5 * (left + left.transpose());
}

void AsideBook::take(const MateSighting& sighting, const Parameters& parameters) {
  const std::size_t observer = index_of(sighting.observer);
  const std::size_t watched = index_of(sighting.watched);
  HostTime& looked = looked_[observer][watched];
  // What errs in one frame errs in the next.
  const double since = to_seconds(sighting.exposure - looked) / to_seconds(parameters.trust.period);
  const double share = std::clamp(since, 0.0, 1.0);
  if (share <= 0.0) return;
  looked = sighting.exposure;
  Page& page = pages_[observer];
  Page& other = pages_[watched];
  // Who is known to stand aside explains it; nobody else is to be suspected of it.
  const bool is_explained = page.is_aside != other.is_aside;
  if (!is_explained || page.is_aside) weigh(page, page.own[watched], sighting, share, parameters);
  if (is_explained && page.is_aside) return;
  MateSighting turned = sighting;
  turned.gap = -sighting.gap;
  weigh(other, other.watched, turned, share, parameters);
}

void AsideBook::forget(RobotId robot) {
  pages_[index_of(robot)] = Page{};
  for (Page& page : pages_) page.own[index_of(robot)] = 0.0;
}

double AsideBook::log_odds(const Page& page, const TrustParameters& parameters) const {
  double sum = page.watched - parameters.in_place;
  for (const double own : page.own)
    sum += std::clamp(own, -parameters.contradiction, parameters.agreement);
  return sum;
}

/// Whether it stands aside by more than nobody cares for, beyond doubt; once found, by half of
/// that.
bool AsideBook::is_far(const Page& page, const TrustParameters& parameters) {
  constexpr double kSure = 3.0;  // standard deviations
  const double least = (page.is_aside ? 0.5 : 1.0) * parameters.least_bias;
  const double sigma = (page.is_aside ? 0.0 : kSure) * std::sqrt(0.5 * page.cov.trace());
  return page.mean.norm() >= std::max(least, sigma);
}

void AsideBook::judge(HostTime exposure, const TrustParameters& parameters) {
  std::array<double, kMaxRobotId> odds{};
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    if (pages_[i].time == kNever) continue;
    turn_page(pages_[i], exposure, parameters);
    odds[i] = log_odds(pages_[i], parameters);
  }
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    Page& page = pages_[i];
    if (page.time == kNever) continue;
    double next = 0.0;
    for (std::size_t j = 0; j < pages_.size(); ++j) {
      if (j != i && !pages_[j].is_aside) next = std::max(next, odds[j]);
    }
    page.is_aside = is_far(page, parameters) &&
                    odds[i] - next >= (page.is_aside ? 0.0 : parameters.bias_margin);
  }
}

bool AsideBook::is_aside(RobotId robot) const {
  return pages_[index_of(robot)].is_aside;
}

}  // namespace teamsight::fusion
