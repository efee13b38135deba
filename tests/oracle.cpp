#include "oracle.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "exact_line.h"

namespace gnomon::oracle {

namespace {

/// How much larger t's relative error can be than that of the ray and the sphere. With n the normal, delta t (n . dir)
/// = delta r + n . delta f - t n . delta dir, where delta dir, of a unit vector, is across dir.
double condition(const Line& line, const Sphere& sphere, const Vec3& normal, double t, const Interval& cosine) {
    const Vec3 dir = nearest(line.dir);
    const Vector f = Vector(sphere.center) - line.origin;
    const double moved = sphere.radius + nearest(root(dot(f, f))) + t * length(cross(normal, dir));
    return moved / (t * std::fabs(nearest(cosine, 1)));
}

Hit hit_at(const Line& line, int64_t id, const Sphere& sphere, const Interval& t) {
    const Vector normal = (line.origin + line.dir * t - Vector(sphere.center)) * (1 / Interval(sphere.radius));
    Hit hit{id, nearest(t), nearest(normal), 0};
    hit.condition = condition(line, sphere, hit.normal, hit.t, dot(normal, line.dir));
    return hit;
}

bool same_place(const Sphere& a, const Sphere& b) {
    return a.center.x == b.center.x && a.center.y == b.center.y && a.center.z == b.center.z && a.radius == b.radius;
}
auto place(const Sphere& s) { return std::make_tuple(s.center.x, s.center.y, s.center.z, s.radius); }

}  // namespace

/// One ray's way through a scene, at some number of digits.
struct Oracle::Look {
    const Oracle& oracle;
    Line line;

    struct Candidate {
        const Kept* kept;
        Interval t;
    };

    Pixel pixel() const {
        Pixel pixel{
            {}, std::vector<bool>(oracle.scene_.lights.size()), std::vector<Rgb>(oracle.scene_.lights.size()), {}};
        const std::optional<Candidate> first = closest();
        if (!first) return pixel;
        pixel.hit = hit_at(line, first->kept->id, first->kept->sphere, first->t);
        for (size_t i = 0; i < pixel.lit.size(); ++i) {
            const Interval share = arriving(*first, oracle.scene_.lights[i]);
            pixel.lit[i] = sign(share) > 0;
            pixel.reflected[i] = reflected(share, first->kept->sphere.albedo, oracle.scene_.lights[i]);
            const Rgb &sum = pixel.radiance, &term = pixel.reflected[i];
            pixel.radiance = {sum.r + term.r, sum.g + term.g, sum.b + term.b};
        }
        return pixel;
    }

    /// Whichever ends first is no later than any: of those that do not begin after that, the lowest id.
    std::optional<Candidate> closest() const {
        const Sight sight(line);
        std::vector<Candidate> met;
        for (const Kept& kept : oracle.spheres_) {
            if (!sight.may_meet(kept.sphere, Hit::infinity)) continue;
            if (const auto t = first_root(Quadratic(line, kept.sphere))) met.push_back({&kept, *t});
        }
        if (met.empty()) return {};
        const auto ends_first = std::min_element(
            met.begin(), met.end(), [](const Candidate& a, const Candidate& b) { return upper(a.t) < upper(b.t); });
        return *std::find_if(met.begin(), met.end(),
                             [&](const Candidate& c) { return &c == &*ends_first || sign(c.t - ends_first->t) <= 0; });
    }

    /// n . l, or n . l / (4 pi d^2): the share of a light's irradiance or power that arrives.
    Interval arriving(const Candidate& at, const Light& light) const {
        const Vector place = line.origin + line.dir * at.t;
        const auto* point = std::get_if<PointLight>(&light);
        const Vector way =
            point ? Vector(point->position) - place : Vector(std::get<DirectionalLight>(light).direction_to_light);
        const Interval facing = dot(place - Vector(at.kept->sphere.center), way);
        if (sign(facing) <= 0) return 0;
        const Interval squared = dot(way, way), distance = root(squared);
        if (in_between({place, way * (1 / distance)}, at, point, distance)) return 0;
        const Interval cosine = facing / (distance * at.kept->sphere.radius);
        return point ? cosine / (4 * pi() * squared) : cosine;
    }

    bool in_between(const Line& to_light, const Candidate& at, const PointLight* point,
                    const Interval& distance) const {
        const Sight sight(to_light);
        const double reach = point ? nearest(distance) : Hit::infinity;
        return std::any_of(oracle.spheres_.begin(), oracle.spheres_.end(), [&](const Kept& kept) {
            if (&kept == at.kept || !sight.may_meet(kept.sphere, reach)) return false;
            return point ? blocks(to_light, kept.sphere, Vector(point->position), distance)
                         : blocks(to_light, kept.sphere);
        });
    }

    /// Lambert's law.
    static Rgb reflected(const Interval& share, const Rgb& albedo, const Light& light) {
        const auto* point = std::get_if<PointLight>(&light);
        const Rgb& phi = point ? point->power : std::get<DirectionalLight>(light).irradiance;
        const auto channel = [&](double rho, double flux) { return nearest(share * rho * flux / pi()); };
        return {channel(albedo.r, phi.r), channel(albedo.g, phi.g), channel(albedo.b, phi.b)};
    }
};

Position position(const Ray& ray, const Sphere& sphere) {
    return decided([&] {
        const Quadratic q(line_of(ray), sphere);
        return Position{sign(q.discriminant), sign(q.power)};
    });
}

Hit meet(const Ray& ray, const Sphere& sphere) {
    return decided([&] {
        const Line line = line_of(ray);
        const auto t = first_root(Quadratic(line, sphere));
        return t ? hit_at(line, 0, sphere, *t) : Hit{};
    });
}

Oracle::Oracle(const Scene& scene) : scene_(scene) {
    for_each_sphere(scene, [&](int64_t id, const Sphere& sphere) { spheres_.push_back({id, sphere}); });
    std::stable_sort(spheres_.begin(), spheres_.end(),
                     [](const Kept& a, const Kept& b) { return place(a.sphere) < place(b.sphere); });
    spheres_.erase(std::unique(spheres_.begin(), spheres_.end(),
                               [](const Kept& a, const Kept& b) { return same_place(a.sphere, b.sphere); }),
                   spheres_.end());
    std::sort(spheres_.begin(), spheres_.end(), [](const Kept& a, const Kept& b) { return a.id < b.id; });
}

Pixel Oracle::look(int i, int j) const {
    return decided([&] { return Look{*this, line_of(scene_, i, j)}.pixel(); });
}
Pixel Oracle::look(const Ray& ray) const {
    return decided([&] { return Look{*this, line_of(ray)}.pixel(); });
}

}  // namespace gnomon::oracle
