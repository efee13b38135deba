#include <fmt/format.h>

#include "scene_json.h"
#include "trials.h"

namespace gnomon::test {

Tally& Tally::operator+=(const Tally& other) {
    for (const auto member : {&Tally::scenes, &Tally::pixels, &Tally::rays, &Tally::shadows, &Tally::facings,
                              &Tally::wrong, &Tally::too_dark, &Tally::exactly, &Tally::confirmed,
                              &Tally::contradictions, &Tally::refined, &Tally::decided_exactly})
        this->*member += other.*member;
    render_seconds += other.render_seconds;
    oracle_seconds += other.oracle_seconds;
    return *this;
}

std::string to_string(const Tally& t) {
    return fmt::format(
        "{} decisions (of {} rays, and {} of hits and lights; and {} about facing), {} wrong; {} scenes; the oracle "
        "settled {} by doubles, {} exactly, asked both ways at {} pixels, {} contradictions; of the pixels certified "
        "refined {}, and decided {} exactly; {} times too dark to tell; rendered in {:.0f} s, judged in {:.0f} s",
        t.decisions(), t.rays, t.shadows, t.facings, t.wrong, t.scenes, t.decisions() - t.exactly, t.exactly,
        t.confirmed, t.contradictions, t.refined, t.decided_exactly, t.too_dark, t.render_seconds, t.oracle_seconds);
}

namespace {

std::string to_string(const oracle::Decisions& d) {
    std::string text = fmt::format("id {}", d.id);
    for (size_t k = 0; k < d.lit.size(); ++k)
        text += fmt::format(", light {} {}{}", k, d.facing[k] ? "faced" : "not faced", d.lit[k] ? ", arrives" : "");
    return text;
}

}  // namespace

std::string to_string(const Scene& scene, int i, int j, const Answer& a, const Answer& b) {
    return fmt::format("pixel ({}, {}): {}: {}; {}: {}\n{}", i, j, a.whose, to_string(a.decisions), b.whose,
                       to_string(b.decisions), to_json(scene).dump());
}

}  // namespace gnomon::test
