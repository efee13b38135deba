#include "exact.h"

#include <boost/multiprecision/mpfi.hpp>
#include <cmath>
#include <limits>
#include <optional>

namespace gnomon::exact {

namespace {

using Interval =
    boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<0>, boost::multiprecision::et_off>;

/// More bits are needed.
struct Unsettled {};

/// The sign of what an interval holds. On the last attempt what may be 0 is 0.
int sign(const Interval& x, bool last) {
    if (lower(x) > 0) return 1;
    if (upper(x) < 0) return -1;
    if (!last && !(lower(x) == 0 && upper(x) == 0)) throw Unsettled{};
    return 0;
}

struct Vector {
    Interval x, y, z;

    Vector(Interval x_, Interval y_, Interval z_) : x(std::move(x_)), y(std::move(y_)), z(std::move(z_)) {}
    explicit Vector(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
};
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(const Vector& a, const Interval& s) { return {a.x * s, a.y * s, a.z * s}; }
Interval dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Interval square(const Interval& x) { return x * x; }
Vector unit(const Vector& a) { return a * (Interval(1) / sqrt(square(a.x) + square(a.y) + square(a.z))); }
Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double middle(const Interval& x) { return static_cast<double>(median(x)); }
Vec3 middle(const Vector& v) { return {middle(v.x), middle(v.y), middle(v.z)}; }

bool same(const Sphere& a, const Sphere& b) {
    return a.radius == b.radius && a.center.x == b.center.x && a.center.y == b.center.y && a.center.z == b.center.z;
}

struct Hit {
    int32_t id;
    Interval t;
};

}  // namespace

namespace {

/// One pixel at one precision.
class Attempt {
  public:
    Attempt(const Scene& scene, const std::vector<Sphere>& spheres, bool shadows, bool last)
        : scene_(scene), spheres_(spheres), shadows_(shadows), last_(last) {}

    Pixel look(const Vector& dir, const std::vector<int32_t>& candidates) const {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Pixel pixel{-1, infinity, {infinity, infinity, infinity}, {0, 0, 0}};
        const std::optional<Hit> hit = closest_hit(dir, candidates);
        if (!hit) return pixel;
        const Sphere& sphere = spheres_[static_cast<size_t>(hit->id)];
        const Vector position = Vector(scene_.camera.eye) + dir * hit->t;
        const Vector normal = (position - Vector(sphere.center)) * (Interval(1) / Interval(sphere.radius));
        pixel.id = hit->id;
        pixel.t = middle(hit->t);
        pixel.normal = middle(normal);
        for (const Light& light : scene_.lights)
            std::visit([&](const auto& l) { add(l, *hit, position, normal, pixel.radiance); }, light);
        return pixel;
    }

  private:
    int sign_of(const Interval& x) const { return sign(x, last_); }
    /// Of what is not below 0.
    Interval root(const Interval& x) const { return lower(x) < 0 && sign_of(x) == 0 ? Interval(0) : sqrt(x); }

    /// The smallest root > 0 of |t dir - f| = r.
    std::optional<Interval> meet(const Vector& dir, const Sphere& s) const {
        const Vector f = Vector(s.center) - Vector(scene_.camera.eye);
        const Interval b = dot(f, dir), power = dot(f, f) - square(Interval(s.radius)), d = square(b) - power;
        const int side = sign_of(power);
        if (side < 0) return b + root(d);
        if (sign_of(d) < 0 || sign_of(b) <= 0) return std::nullopt;
        return side == 0 ? Interval(2 * b) : Interval(b - root(d));
    }
    std::optional<Hit> closest_hit(const Vector& dir, const std::vector<int32_t>& candidates) const {
        std::optional<Hit> best;
        for (const int32_t id : candidates) {
            const std::optional<Interval> t = meet(dir, spheres_[static_cast<size_t>(id)]);
            // In the order of ids: of equal distances the first stays.
            if (t && (!best || is_nearer(*t, id, *best))) best = Hit{id, *t};
        }
        return best;
    }
    bool is_nearer(const Interval& t, int32_t id, const Hit& than) const {
        if (same(spheres_[static_cast<size_t>(id)], spheres_[static_cast<size_t>(than.id)])) return false;
        return sign_of(t - than.t) < 0;
    }

    void add(const DirectionalLight& light, const Hit& hit, const Vector& position, const Vector& normal,
             Rgb& sum) const {
        const Vector l = unit(Vector(light.direction_to_light));
        const Interval cosine = dot(normal, l);
        if (sign_of(cosine) <= 0) return;
        const auto stands_between = [&](const Sphere& s) {
            const Vector g = Vector(s.center) - position;
            const Interval ahead = dot(g, l), power = dot(g, g) - square(Interval(s.radius));
            if (sign_of(square(ahead) - power) < 0) return false;
            return sign_of(power) < 0 || sign_of(ahead) > 0;
        };
        if (!is_shadowed(hit, position, l, stands_between)) shade(hit, light.irradiance, cosine, sum);
    }
    void add(const PointLight& light, const Hit& hit, const Vector& position, const Vector& normal, Rgb& sum) const {
        const Vector way = Vector(light.position) - position;
        const Interval squared = dot(way, way);
        if (sign_of(squared) <= 0) return;
        const Interval distance = sqrt(squared);
        const Vector l = way * (Interval(1) / distance);
        const Interval cosine = dot(normal, l);
        if (sign_of(cosine) <= 0) return;
        const auto stands_between = [&](const Sphere& s) {
            const Vector g = Vector(s.center) - position;
            const Interval ahead = dot(g, l), d = square(ahead) - dot(g, g) + square(Interval(s.radius));
            if (sign_of(d) < 0) return false;
            const Interval half = root(d), near = ahead - half, far = ahead + half;
            const auto inside = [&](const Interval& t) { return sign_of(t) > 0 && sign_of(distance - t) > 0; };
            return inside(near) || inside(far);
        };
        if (!is_shadowed(hit, position, l, stands_between))
            shade(hit, light.power, cosine / squared / (atan(Interval(1)) * 16), sum);
    }

    template <class StandsBetween>
    bool is_shadowed(const Hit& hit, const Vector& position, const Vector& l, StandsBetween stands_between) const;

    /// albedo / pi times what arrives.
    void shade(const Hit& hit, const Rgb& phi, const Interval& share, Rgb& sum) const {
        const double factor = middle(share / (atan(Interval(1)) * 4));
        const Rgb& albedo = spheres_[static_cast<size_t>(hit.id)].albedo;
        sum = {sum.r + albedo.r * phi.r * factor, sum.g + albedo.g * phi.g * factor, sum.b + albedo.b * phi.b * factor};
    }

    const Scene& scene_;
    const std::vector<Sphere>& spheres_;
    bool shadows_, last_;
};

/// Whether a sphere may come so near a line from p along the unit vector d, as doubles have it. They are off by a few
/// 2^-53 of the largest number involved; 2^-40 of it is far more, and costs nothing.
bool may_meet(const Sphere& s, const Vec3& p, const Vec3& d) {
    const Vec3 f = s.center - p;
    const double slack = 0x1p-40 * (length(s.center) + length(p) + s.radius), m = length(gnomon::cross(f, d));
    return !(m > s.radius + slack);  // NaN may
}

std::vector<int32_t> near_line(const std::vector<Sphere>& spheres, const Vec3& p, const Vec3& d) {
    std::vector<int32_t> near;
    for (size_t s = 0; s < spheres.size(); ++s)
        if (may_meet(spheres[s], p, d)) near.push_back(static_cast<int32_t>(s));
    return near;
}

template <class StandsBetween>
bool Attempt::is_shadowed(const Hit& hit, const Vector& position, const Vector& l, StandsBetween stands_between) const {
    if (!shadows_) return false;
    const Vec3 p = middle(position), d = middle(l);
    for (size_t i = 0; i < spheres_.size(); ++i) {
        const Sphere& s = spheres_[i];
        if (static_cast<int32_t>(i) == hit.id || !may_meet(s, p, d)) continue;
        if (!same(s, spheres_[static_cast<size_t>(hit.id)]) && stands_between(s)) return true;
    }
    return false;
}

int digits(int bits) { return static_cast<int>(bits * 0.30103) + 1; }

}  // namespace

struct Eye {
    explicit Eye(const Scene& scene)
        : image(scene.image),
          z(unit(Vector(scene.camera.at) - Vector(scene.camera.eye))),
          x(unit(cross(Vector(scene.camera.up), z))),
          y(cross(z, x)),
          half_pixel(tan(Interval(scene.camera.fov) * (atan(Interval(1)) * 4) / 360) / image.height) {}

    Vector ray(int i, int j) const {
        const Interval right = half_pixel * (2 * i + 1 - image.width), up = half_pixel * (image.height - 1 - 2 * j);
        return unit(z + x * right + y * up);
    }

    ImageSize image;
    Vector z, x, y;
    Interval half_pixel;  // at distance 1
};

/// At the default precision, which is of so many bits.
const Eye& Decider::eye(int bits) {
    std::shared_ptr<const Eye>& made = eyes_[bits];
    if (!made) made = std::make_shared<const Eye>(scene_);
    return *made;
}

Decider::Decider(const Scene& scene, bool shadows) : scene_(scene), shadows_(shadows) {
    spheres_.reserve(static_cast<size_t>(sphere_count(scene)));
    for_each_sphere(scene, 0, sphere_count(scene), [&](int64_t, const Sphere& s) { spheres_.push_back(s); });
}

Pixel Decider::decide(int i, int j) {
    std::vector<int32_t> candidates;
    for (int bits = least_bits;; bits = bits < patient_bits ? 2 * bits : most_bits) {
        Interval::default_precision(static_cast<unsigned>(digits(bits)));
        const Vector dir = eye(bits).ray(i, j);
        if (bits == least_bits) candidates = near_line(spheres_, scene_.camera.eye, middle(dir));
        try {
            return Attempt(scene_, spheres_, shadows_, bits >= most_bits).look(dir, candidates);
        } catch (const Unsettled&) {
            // the next attempt has more
        }
    }
}

}  // namespace gnomon::exact
