#include "oracle.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "look.h"

namespace gnomon::oracle {

namespace {

/// How much larger t's relative error can be than that of the ray and the sphere. With n the normal, delta t (n . dir)
/// = delta r + n . delta f - t n . delta dir, where delta dir, of a unit vector, is across dir.
double condition(const Line<Interval>& line, const Sphere& sphere, const Vec3& normal, double t,
                 const Interval& cosine) {
    const Vec3 dir = nearest(line.dir);
    const Vector<Interval> f = Vector<Interval>(sphere.center) - line.origin;
    const double moved = sphere.radius + nearest(root(dot(f, f))) + t * length(cross(normal, dir));
    return moved / (t * std::fabs(nearest(cosine, 1)));
}

Hit hit_at(const Line<Interval>& line, int64_t id, const Sphere& sphere, const Interval& t) {
    const Vector<Interval> out = line.origin + line.dir * t - Vector<Interval>(sphere.center);
    const Vector<Interval> normal = out * Interval(1 / Interval(sphere.radius));
    Hit hit{id, nearest(t), nearest(normal), 0};
    hit.condition = condition(line, sphere, hit.normal, hit.t, dot(normal, line.dir));
    return hit;
}

bool same_place(const Sphere& a, const Sphere& b) {
    return a.center.x == b.center.x && a.center.y == b.center.y && a.center.z == b.center.z && a.radius == b.radius;
}
auto place(const Sphere& s) { return std::make_tuple(s.center.x, s.center.y, s.center.z, s.radius); }

}  // namespace

/// A look with many digits, and the numbers that it comes to.
class Oracle::Numbers {
  public:
    Numbers(const Oracle& oracle, Line<Interval> line)
        : lights_(oracle.scene_.lights), look_(oracle.spheres_, std::move(line)) {}

    Pixel pixel() const {
        Pixel pixel{{}, std::vector<bool>(lights_.size()), std::vector<Rgb>(lights_.size()), {}};
        const auto first = look_.closest();
        if (!first) return pixel;
        pixel.hit = hit_at(look_.line(), first->kept->id, first->kept->sphere, first->t);
        for (size_t i = 0; i < pixel.lit.size(); ++i) {
            const Interval share = arriving(*first, lights_[i]);
            pixel.lit[i] = sign(share) > 0;
            pixel.reflected[i] = reflected(share, first->kept->sphere.albedo, lights_[i]);
            const Rgb &sum = pixel.radiance, &term = pixel.reflected[i];
            pixel.radiance = {sum.r + term.r, sum.g + term.g, sum.b + term.b};
        }
        return pixel;
    }

  private:
    /// n . l, or n . l / (4 pi d^2): the share of a light's irradiance or power that arrives.
    Interval arriving(const Meeting<Interval>& at, const Light& light) const {
        const Way<Interval> way = look_.way_to(light, at);
        if (sign(way.facing) <= 0 || look_.in_between(way, at)) return 0;
        const Interval squared = dot(way.way, way.way);
        const Interval cosine = way.facing / (root(squared) * at.kept->sphere.radius);
        return way.point ? cosine / (4 * pi() * squared) : cosine;
    }

    /// Lambert's law.
    static Rgb reflected(const Interval& share, const Rgb& albedo, const Light& light) {
        const auto* point = std::get_if<PointLight>(&light);
        const Rgb& phi = point ? point->power : std::get<DirectionalLight>(light).irradiance;
        const auto channel = [&](double rho, double flux) { return nearest(share * rho * flux / pi()); };
        return {channel(albedo.r, phi.r), channel(albedo.g, phi.g), channel(albedo.b, phi.b)};
    }

    const std::vector<Light>& lights_;
    Look<Interval> look_;
};

Position position(const Ray& ray, const Sphere& sphere) {
    return decided([&] {
        const Quadratic q(line_of(ray), sphere);
        return Position{sign(q.discriminant), sign(q.power)};
    });
}

Hit meet(const Ray& ray, const Sphere& sphere) {
    return decided([&] {
        const Line<Interval> line = line_of(ray);
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
    return decided([&] { return Numbers(*this, pinhole_of(scene_).line(i, j)).pixel(); });
}
Pixel Oracle::look(const Ray& ray) const {
    return decided([&] { return Numbers(*this, line_of(ray)).pixel(); });
}

Decisions Oracle::decide(int i, int j) const {
    return decided([&] { return decisions(Look(spheres_, pinhole_of(scene_).line(i, j)), scene_.lights); });
}

}  // namespace gnomon::oracle
