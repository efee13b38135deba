// What a rendering leaves behind: one plane a channel, rows from the top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace gnomon {

/// Which results are wanted; what is not asked for is neither computed nor stored.
struct Outputs {
    bool radiance = true, distance = false, normal = false, id = false;
};

/// width x height values in one allocation that starts on a page, so that a device which shares the host's memory can
/// write straight into it. Empty when default-constructed; not initialised otherwise.
template <class T>
class Plane {
  public:
    static constexpr size_t page = 4096;

    Plane() = default;
    explicit Plane(size_t count) : count_(count), data_(static_cast<T*>(std::aligned_alloc(page, bytes()))) {
        if (!data_) throw std::bad_alloc();
    }

    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    /// Allocated bytes, a whole number of pages.
    size_t bytes() const { return (count_ * sizeof(T) + page - 1) / page * page; }
    T& operator[](size_t i) { return data_.get()[i]; }
    const T& operator[](size_t i) const { return data_.get()[i]; }
    T* begin() { return data(); }
    T* end() { return data() + count_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + count_; }

  private:
    struct Free {
        void operator()(T* p) const { std::free(p); }
    };
    size_t count_ = 0;
    std::unique_ptr<T, Free> data_;
};

/// The first hit's distance, normal and id, and the radiance it sends to the eye, linear and unclipped. A miss has
/// distance +inf, normal (inf, inf, inf), id -1 and radiance 0. Planes that were not asked for are empty.
struct Film {
    int width = 0, height = 0;
    Plane<float> radiance[3];  ///< R, G, B
    Plane<float> distance;     ///< along the ray from the eye, in the scene's unit
    Plane<float> normal[3];    ///< x, y, z; outward, unit length
    Plane<int32_t> id;         ///< index of the sphere

    Film() = default;
    Film(int w, int h, const Outputs& outputs);
    size_t pixels() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
};

}  // namespace gnomon
