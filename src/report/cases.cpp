#include "cases.h"

#include <algorithm>
#include <functional>

#include "draws.h"
#include "exact.h"
#include "rounding.h"

namespace gnomon::report {

namespace {

Float3 rounded(const Vec3& v) { return {round_to_float(v.x), round_to_float(v.y), round_to_float(v.z)}; }

RootSphere sphere_at(const Vec3& center, double radius) {
    const Float3 f = rounded(center);
    const float r = round_to_float(radius);
    return {f, r, exact_power(f, r)};
}

Vec3 center_of(const RootSphere& s) { return {s.center.x, s.center.y, s.center.z}; }

/// A ray that passes the centre at this distance, on a random side.
Vec3 aimed(const RootSphere& sphere, double impact, Draws& draws) {
    const Vec3 center = center_of(sphere), axis = normalize(center);
    const double sine = std::min(1.0, impact / length(center));
    return axis * std::sqrt((1 - sine) * (1 + sine)) + draws.across(axis) * sine;
}

/// How spheres are drawn, and rays for each.
struct Recipe {
    const char *name, *about;
    std::function<RootSphere(Draws&)> sphere;
    std::function<Vec3(const RootSphere&, Draws&)> dir;
};

/// Evenly over a disc of 1.1 radii: one ray in six misses.
Vec3 over_the_disc(const RootSphere& sphere, Draws& draws) {
    return aimed(sphere, 1.1 * sphere.radius * std::sqrt(draws.uniform(0, 1)), draws);
}

/// A unit sphere whose centre is so many radii away.
std::function<RootSphere(Draws&)> unit_sphere(double low, double high) {
    return [=](Draws& draws) { return sphere_at(draws.direction() * draws.scale(low, high), 1); };
}

/// The eye stands 1.7 above a ground, as a person does; what is underfoot may be in any direction.
Recipe ground(const char* name, const char* about, double radius) {
    constexpr double height = 1.7;
    const auto sphere = [=](Draws& draws) { return sphere_at(draws.direction() * (radius + height), radius); };
    // To a point of the ground between 1 m and the horizon, sqrt(2 h R) away; one in eight up to as much above the
    // horizon as the horizon lies below eye level.
    const auto dir = [=](const RootSphere& s, Draws& draws) {
        const Vec3 down = normalize(center_of(s)), ahead = draws.across(down);
        const double dip = std::acos(radius / (radius + height));
        if (draws.uniform(0, 1) < 0.125) {
            const double above = draws.uniform(-dip, 0);
            return ahead * std::cos(above) - down * std::sin(above);
        }
        const double angle = draws.scale(1, std::sqrt(2 * height * radius)) / radius;
        const double below = height + 2 * radius * std::sin(angle / 2) * std::sin(angle / 2);
        return normalize(ahead * (radius * std::sin(angle)) + down * below);
    };
    return {name, about, sphere, dir};
}

Vec3 grazing(const RootSphere& sphere, Draws& draws) {
    return aimed(sphere, sphere.radius * (1 + draws.sign() * draws.scale(1e-7, 1e-1)), draws);
}

/// Inward from outside, any way from inside.
Vec3 from_the_surface(const RootSphere& sphere, Draws& draws) {
    const Vec3 dir = draws.direction();
    return sphere.power > 0 && dot(dir, center_of(sphere)) < 0 ? dir * -1 : dir;
}

std::vector<Recipe> recipes() {
    const auto at_the_surface = [](Draws& draws) {
        return sphere_at(draws.direction() * (1 + draws.sign() * draws.scale(1e-6, 1e-1)), 1);
    };
    const auto of_a_scene = [](Draws& draws) {
        return sphere_at(draws.direction() * draws.uniform(25, 200), draws.scale(0.1, 20));
    };
    return {{"near", "unit spheres, 1.05 to 10 radii away", unit_sphere(1.05, 10), over_the_disc},
            {"far", "unit spheres, 10^4 radii away", unit_sphere(0.9e4, 1.1e4), over_the_disc},
            {"farthest", "unit spheres, 10^7 radii away", unit_sphere(0.9e7, 1.1e7), over_the_disc},
            {"scene", "radii 0.1 to 20, 25 to 200 away", of_a_scene, over_the_disc},
            ground("ground 1e3", "a ground of radius 10^3 from 1.7 above it, down to the horizon and beyond", 1e3),
            ground("ground 1e5", "the same with a radius of 10^5", 1e5),
            ground("ground 1e6", "the same with a radius of 10^6", 1e6),
            {"grazing", "impact 1 +- 10^-7 to 10^-1 radii, 1.5 to 1000 radii away", unit_sphere(1.5, 1000), grazing},
            {"surface", "from 10^-6 to 10^-1 radii outside and inside the surface", at_the_surface, from_the_surface}};
}

/// In order of impact: neighbours in a block are neighbours in a picture too, and only few of them graze where others
/// do not.
void add_block(RootCase& to, const RootSphere& sphere, Draws& draws, const Recipe& recipe) {
    std::vector<Vec3> dirs;
    for (int i = 0; i < BLOCK_RAYS; ++i) dirs.push_back(recipe.dir(sphere, draws));
    const Vec3 center = center_of(sphere);
    std::sort(dirs.begin(), dirs.end(), [&](const Vec3& a, const Vec3& b) { return dot(a, center) > dot(b, center); });
    to.spheres.push_back(sphere);
    for (const Vec3& dir : dirs) to.dirs.push_back(rounded(dir));
}

}  // namespace

std::vector<RootCase> root_cases(int64_t rays) {
    std::vector<RootCase> cases;
    for (const Recipe& recipe : recipes()) {
        RootCase made{recipe.name, recipe.about, {}, {}};
        Draws draws(cases.size());
        for (int64_t i = 0; i < rays; i += BLOCK_RAYS) add_block(made, recipe.sphere(draws), draws, recipe);
        cases.push_back(std::move(made));
    }
    return cases;
}

RootCase grid_case(const Grid& grid) {
    RootCase made{"grid", "unit spheres over distance and impact", {}, {}};
    Draws draws(1000);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns * grid.blocks; ++column) {
            const double decade = grid.decades / grid.columns, low = decade * (column / grid.blocks);
            const double height = grid.impacts / grid.rows, impact = height * row;
            // No line passes a centre farther off than it is away.
            const double least = std::max(low, std::log10(1.001 * (impact + height)));
            const RootSphere sphere =
                sphere_at(draws.direction() * std::pow(10, draws.uniform(least, std::max(least, low + decade))), 1);
            const auto dir = [&](const RootSphere& s, Draws& d) {
                return aimed(s, d.uniform(impact, impact + height), d);
            };
            add_block(made, sphere, draws, {"", "", {}, dir});
        }
    return made;
}

}  // namespace gnomon::report
