#include "exact.h"

#include <boost/multiprecision/mpfr.hpp>
#include <limits>

namespace gnomon::report {

namespace {

namespace mp = boost::multiprecision;
using Exact = mp::number<mp::mpfr_float_backend<60, mp::allocate_stack>, mp::et_off>;

struct Exact3 {
    Exact x, y, z;
    explicit Exact3(const Float3& v) : x(v.x), y(v.y), z(v.z) {}
};
Exact dot(const Exact3& a, const Exact3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

ExactHit miss() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {false, infinity, {infinity, infinity, infinity}};
}

}  // namespace

ExactHit exact_hit(const RootSphere& sphere, const Float3& direction) {
    const Exact3 center(sphere.center), dir(direction);
    const Exact radius(sphere.radius), a = dot(dir, dir), b = -2 * dot(center, dir);
    const Exact c = dot(center, center) - radius * radius, discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return miss();
    const Exact root = sqrt(discriminant), near = (-b - root) / (2 * a), far = (-b + root) / (2 * a);
    const Exact t = near > 0 ? near : far;
    if (!(t > 0)) return miss();
    const auto component = [&](const Exact& d, const Exact& f) {
        return Exact((t * d - f) / radius).convert_to<double>();
    };
    return {true,
            t.convert_to<double>(),
            {component(dir.x, center.x), component(dir.y, center.y), component(dir.z, center.z)}};
}

float exact_power(const Float3& center, float radius) {
    const Exact3 f(center);
    const Exact r(radius);
    return Exact(dot(f, f) - r * r).convert_to<float>();
}

}  // namespace gnomon::report
