#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace fumon {

/// A corner of a person's surface: metres, from the ground between the heels; looking along +y, x
/// to the right.
struct PersonVertex {
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};
    glm::vec3 colour{0.5F};  ///< reflectances
};

inline constexpr double person_height = 1.75;  // metres, of the first

/// What covers a person's head.
enum class Headwear { brimmed_hat, cap, hair, scarf };

/// A person's build, pose and clothes. Lengths in metres, reflectances.
struct PersonFigure {
    double height = person_height;
    double girth = 1.0;      ///< breadth and depth, against the height's usual ones
    double stride = 0.13;    ///< how far each foot stands before or behind the hips
    double leading = 1.0;    ///< 1: the right foot is before the left, -1: behind it
    double elbows = 0.0;     ///< 0 arms that hang … 1 forearms well forward
    double head_turn = 0.0;  ///< degrees anticlockwise
    bool pack = true;
    Headwear headwear = Headwear::brimmed_hat;
    glm::vec3 trousers{0.075F, 0.080F, 0.100F};
    glm::vec3 shirt{0.24F, 0.085F, 0.070F};
    glm::vec3 skin{0.34F, 0.20F, 0.13F};
    glm::vec3 on_head{0.42F, 0.37F, 0.28F};
};

/// The figure of the person of a number. The first is 1.75 m tall, a scale to measure by; others
/// have 1.58 to 1.90 m, and what else they are like from random numbers of their own.
PersonFigure person_figure(std::size_t number);

/// A person on both feet: triangles, three corners each. The same each time.
std::vector<PersonVertex> person_mesh(const PersonFigure& figure);

/// The direction in which the person of a number looks where a scene says none, degrees clockwise
/// from north: the first to the south, others up to 120 degrees away from that.
double person_facing(std::size_t number);

}  // namespace fumon
