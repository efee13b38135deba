// One ray's way through a scene: what it meets, and which lights reach that. Real is an interval, of many digits
// (interval.h) or between doubles (quick_interval.h).
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "exact_line.h"

namespace gnomon::oracle {

template <class Real>
struct Meeting {
    const Kept* kept;
    Real t;
};

/// From where a sphere is met to a light.
template <class Real>
struct Way {
    Vector<Real> place, way;  ///< `way` has the light's distance for its length, if that is anywhere
    Real facing;              ///< n . way, times the radius
    const PointLight* point;  ///< none for parallel light
};

template <class Real>
class Look {
  public:
    Look(const std::vector<Kept>& spheres, Line<Real> line) : spheres_(spheres), line_(std::move(line)) {}

    const Line<Real>& line() const { return line_; }

    /// In the order of ids, so that of equal distances the lowest id's stays. What begins after another has ended need
    /// not be compared.
    std::optional<Meeting<Real>> closest() const {
        const std::vector<Meeting<Real>> met = meetings();
        if (met.empty()) return {};
        const auto first_end = upper(std::min_element(met.begin(), met.end(), [](const auto& a, const auto& b) {
                                         return upper(a.t) < upper(b.t);
                                     })->t);
        const Meeting<Real>* best = nullptr;
        for (const Meeting<Real>& m : met)
            if (!(lower(m.t) > first_end) && (!best || sign(Real(m.t - best->t)) < 0)) best = &m;
        return *best;
    }

    Way<Real> way_to(const Light& light, const Meeting<Real>& at) const {
        const Vector<Real> place = line_.origin + line_.dir * at.t;
        const auto* point = std::get_if<PointLight>(&light);
        const Vector<Real> way = point ? Vector<Real>(point->position) - place
                                       : Vector<Real>(std::get<DirectionalLight>(light).direction_to_light);
        return {place, way, dot(place - Vector<Real>(at.kept->sphere.center), way), point};
    }

    bool in_between(const Way<Real>& way, const Meeting<Real>& at) const {
        const Real distance = root(dot(way.way, way.way));
        const Line<Real> to_light{way.place, way.way * Real(1. / distance)};
        const Sight sight(to_light);
        const double reach = way.point ? double_above(distance) : Hit::infinity;
        return std::any_of(spheres_.begin(), spheres_.end(), [&](const Kept& kept) {
            if (&kept == at.kept || !sight.may_meet(kept.sphere, reach)) return false;
            return way.point ? blocks(to_light, kept.sphere, Vector<Real>(way.point->position), distance)
                             : blocks(to_light, kept.sphere);
        });
    }

  private:
    std::vector<Meeting<Real>> meetings() const {
        const Sight sight(line_);
        std::vector<Meeting<Real>> met;
        for (const Kept& kept : spheres_) {
            if (!sight.may_meet(kept.sphere, Hit::infinity)) continue;
            if (const auto t = first_root(Quadratic(line_, kept.sphere))) met.push_back({&kept, *t});
        }
        return met;
    }

    const std::vector<Kept>& spheres_;
    Line<Real> line_;
};

/// Everything that is to decide about a look.
template <class Real>
Decisions decisions(const Look<Real>& look, const std::vector<Light>& lights) {
    Decisions made{-1, std::vector<bool>(lights.size()), std::vector<bool>(lights.size())};
    const auto first = look.closest();
    if (!first) return made;
    made.id = first->kept->id;
    for (size_t i = 0; i < lights.size(); ++i) {
        const auto way = look.way_to(lights[i], *first);
        made.facing[i] = sign(way.facing) > 0;
        made.lit[i] = made.facing[i] && !look.in_between(way, *first);
    }
    return made;
}

}  // namespace gnomon::oracle
