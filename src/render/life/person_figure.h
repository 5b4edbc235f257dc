#pragma once

#include <cstddef>
#include <glm/glm.hpp>

namespace fumon {

inline constexpr double person_height = 1.75;  // metres, of the first

/// What covers a person's head.
enum class Headwear { brimmed_hat, cap, hair, scarf };

/// A person's build, pose and clothes. Lengths in metres, reflectances.
struct PersonFigure {
    double height = person_height;
    double girth = 1.0;      ///< breadth and depth, against the height's usual ones
    double stride = 0.16;    ///< how far each foot stands before or behind the hips
    double leading = 1.0;    ///< 1: the right foot is before the left, -1: behind it
    double elbows = 0.0;     ///< 0 arms that hang … 1 forearms well forward
    double head_turn = 0.0;  ///< degrees anticlockwise
    double weight = 0.0;     ///< 0: on both legs; 1: on the right one, -1: on the left
    double lean = 0.02;      ///< how far the shoulders are before the hips
    double hem = 0.84;       ///< how high the shirt ends above the ground
    double folds = 0.0;      ///< radians, of the folds of clothes
    bool has_long_hair = false;
    bool has_short_sleeves = false;
    bool pack = true;
    Headwear headwear = Headwear::brimmed_hat;
    glm::vec3 trousers{0.075F, 0.080F, 0.100F};
    glm::vec3 shirt{0.24F, 0.085F, 0.070F};
    glm::vec3 skin{0.34F, 0.20F, 0.13F};
    glm::vec3 on_head{0.42F, 0.37F, 0.28F};
    glm::vec3 hair{0.070F, 0.042F, 0.024F};
    glm::vec3 pack_colour{0.060F, 0.090F, 0.055F};
};

/// The figure of the person of a number. The first is 1.75 m tall, a scale to measure by; others
/// have 1.58 to 1.90 m, and what else they are like from random numbers of their own.
PersonFigure person_figure(std::size_t number);

/// The direction in which the person of a number looks where a scene says none, degrees clockwise
/// from north: the first to the south, others up to 120 degrees away from that.
double person_facing(std::size_t number);

}  // namespace fumon
