// What rounding to float leaves over, in pairs and in arrays, which compilers vectorise.
#include "catch.h"
#include "pencil.h"
#include "rounding.h"

using namespace gnomon;

TEST_CASE("rounding: hi and lo together are the number to 48 bits", "[rounding]") {
    double numbers[64], sums[64];
    for (int i = 0; i < 64; ++i) numbers[i] = (i % 2 == 0 ? 1.1 : -3.7) * std::sqrt(i + 2.0);
    for (int i = 0; i < 64; ++i)
        sums[i] = static_cast<double>(round_to_float(numbers[i])) + static_cast<double>(rest_of_float(numbers[i]));
    for (int i = 0; i < 64; ++i) {
        CHECK(std::fabs(sums[i] - numbers[i]) <= 0x1p-48 * std::fabs(numbers[i]));
        if (std::sqrt(i + 2.0) != std::floor(std::sqrt(i + 2.0))) CHECK_FALSE(is_float(numbers[i]));
        CHECK(is_float(static_cast<double>(round_to_float(numbers[i]))));
    }
}

TEST_CASE("rounding: an apex is its point to 48 bits", "[rounding]") {
    Camera camera;
    camera.eye = {3.6814665265422981, -1.1, 2.3};
    const Apex apex = eye_apex(camera, Frame());
    const double sums[] = {apex.hi.x + static_cast<double>(apex.lo.x), apex.hi.y + static_cast<double>(apex.lo.y),
                           apex.hi.z + static_cast<double>(apex.lo.z)};
    const double eye[] = {camera.eye.x, camera.eye.y, camera.eye.z};
    for (int i = 0; i < 3; ++i) {
        CHECK(std::fabs(sums[i] - eye[i]) <= 0x1p-48 * std::fabs(eye[i]));
        CHECK(sums[i] != static_cast<double>(static_cast<float>(eye[i])));  // the rest is there
    }
}
