#include <algorithm>
#include <cstring>
#include <optional>

#include "channels.h"
#include "error.h"
#include "verify.h"

namespace gnomon::verify {

namespace {

template <class Value>
bool same_bits(const Value& a, const Value& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// A device that went through all of its pictures and has this one as recorded.
const Verdict* witness(const std::vector<Verdict>& verdicts, const Difference& difference, const Case& of) {
    const std::string mode = to_string(difference.mode);
    for (const Verdict& verdict : verdicts) {
        const std::vector<Mode> able = modes(verdict.device);
        const bool tried = verdict.error.empty() && of.suits(verdict.device) &&
                           std::any_of(able.begin(), able.end(), [&](const Mode& m) { return to_string(m) == mode; });
        const bool other = std::any_of(verdict.differences.begin(), verdict.differences.end(),
                                       [&](const Difference& d) { return d.picture == difference.picture; });
        if (tried && !other) return &verdict;
    }
    return nullptr;
}

}  // namespace

std::optional<Pixel> first_pixel(const Film& film, const Film& expected) {
    for (size_t p = 0; p < film.pixels(); ++p) {
        const auto at = static_cast<int>(p);
        Pixel pixel{at % film.width, at / film.width, "", 0, 0, ""};
        const auto differs = [&](const char* channel, auto value, auto wanted) {
            if (same_bits(value, wanted)) return false;
            pixel.channel = channel;
            pixel.value = static_cast<double>(value);
            pixel.expected = static_cast<double>(wanted);
            return true;
        };
        if (differs(id_channel, film.id[p], expected.id[p])) return pixel;
        for (const size_t c : {3, 4, 5, 6, 0, 1, 2})  // the distance, the normal, the radiance
            if (differs(float_channels[c].name, plane_of(film, c)[p], plane_of(expected, c)[p])) return pixel;
    }
    return {};
}

void find_pixels(std::vector<Verdict>& verdicts, const std::vector<Case>& cases, const Say& say) {
    for (Verdict& verdict : verdicts) try {
            for (Difference& difference : verdict.differences) {
                const Verdict* right = witness(verdicts, difference, cases[difference.scene]);
                if (!right) continue;
                say(verdict.device.number() + " and " + right->device.number() + " " + difference.picture);
                Film film, expected;
                Renderer here(verdict.device), there(right->device);
                render(here, cases[difference.scene], difference.mode, film);
                render(there, cases[difference.scene], difference.mode, expected);
                difference.pixel = first_pixel(film, expected);
                if (difference.pixel) difference.pixel->device = right->device.number();
            }
        } catch (const Error& error) {
            verdict.error = std::string("looking for pixels: ") + error.what();
        }
}

}  // namespace gnomon::verify
