// Many spheres in little memory, on their way into a scene.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "random.h"
#include "scene.h"

namespace bench {

/// Spheres in the making, their numbers rounded to float32, as most programs keep them.
class Crowd {
  public:
    /// Rows of 7 numbers take 28 bytes a sphere; rows of 4 take 16, and then all have the mean of the drawn albedos.
    explicit Crowd(int64_t expected, int columns = 7);

    void add(const gnomon::Sphere& sphere);
    int64_t count() const { return static_cast<int64_t>(rows_->size()) / columns_; }

    /// After the spheres that the scene has: more than a thousand as one table, fewer as single ones.
    void move_to(gnomon::Scene& scene);

  private:
    int columns_;
    std::shared_ptr<std::vector<float>> rows_ = std::make_shared<std::vector<float>>();
};

/// A cube full of spheres.
struct Cloud {
    gnomon::Vec3 center;
    double side = 100;
    double fill = 0.05;                     ///< the share of the cube that the volumes add up to
    std::optional<gnomon::Vec3> hole = {};  ///< where no sphere is near: an eye, a light
};

/// The mean radius of `count` spheres in the cloud; they go from a half to one and a half of it.
double mean_radius(const Cloud& cloud, int64_t count);

/// Adds `count` spheres at random.
void add_cloud(Crowd& crowd, const Cloud& cloud, int64_t count, Random& random);

}  // namespace bench
