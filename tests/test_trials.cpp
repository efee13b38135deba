// Certified pictures of thousands of scenes against the oracle: not one decision is wrong. A few seconds of it are
// among the tests; all of it is the target certified_trials.
//
// Environment: GNOMON_TRIALS_SEED, the first scene's seed, of which the next has the next; GNOMON_TRIALS_RANDOM and
// GNOMON_TRIALS_ADVERSARIAL, how many decisions the long trials take. A scene follows from its seed and its kind.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <map>

#include "catch.h"
#include "trials/trials.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

int64_t setting(const char* name, int64_t otherwise) {
    const char* text = std::getenv(name);
    return text ? std::strtoll(text, nullptr, 10) : otherwise;
}

/// Makes a scene of a seed, and says of which kind.
struct Series {
    const char* name;
    int64_t decisions;
    std::pair<Scene, std::string> (*make)(uint64_t seed);
};

std::pair<Scene, std::string> make_random(uint64_t seed) {
    Random random(seed);
    return {random_scenes.make(random), random_scenes.name};
}
/// Each kind in turn.
std::pair<Scene, std::string> make_adversary(uint64_t seed) {
    Random random(seed);
    const Maker& maker = adversaries()[seed % adversaries().size()];
    Scene scene = maker.make(random);
    return {elsewhere(random, std::move(scene)), maker.name};
}

void report(const std::string& series, uint64_t first, uint64_t next, const Tally& tally) {
    fmt::print("{}, seeds {} to {}: {}\n", series, first, next - 1, to_string(tally));
    std::fflush(stdout);
}

/// Until so many decisions are made, or so many seconds have passed; says now and then how far it is.
void run(Renderer& renderer, const Series& series, bool talks) {
    const auto first = static_cast<uint64_t>(setting("GNOMON_TRIALS_SEED", 1));
    uint64_t seed = first;
    Tally all;
    std::map<std::string, Tally> by_kind;
    for (int64_t said = 0; all.decisions() < series.decisions; ++seed) {
        const auto [scene, kind] = series.make(seed);
        const std::string name = fmt::format("{}, seed {}", kind, seed);
        INFO(name);  // for what may be thrown
        const Tally tally = try_scene(renderer, scene, name);
        all += tally;
        by_kind[kind] += tally;
        if (!talks || all.decisions() * 100 < series.decisions * (said + 1)) continue;
        said = all.decisions() * 100 / series.decisions;
        report(series.name, first, seed + 1, all);
    }
    if (talks)
        for (const auto& [kind, tally] : by_kind) fmt::print("{}: {}\n", kind, to_string(tally));
    if (talks) report(fmt::format("In the end, {}", series.name), first, seed, all);
    INFO(series.name << ": " << to_string(all));
    CHECK(all.wrong == 0);
    CHECK(all.contradictions == 0);
    CHECK(all.confirmed > 0);
    CHECK(all.refined > 0);  // or nothing was hard
    CHECK(all.exactly < all.decisions());
}

void run(const Series& series, bool talks) {
    on_every_device([&](Renderer& renderer) { run(renderer, series, talks); });
}

}  // namespace

TEST_CASE("trials: certified decides right in random scenes", "[certified][sample]") {
    run({"random", 500'000, make_random}, false);
}
TEST_CASE("trials: certified decides right in hard scenes", "[certified][sample]") {
    run({"adversarial", 200'000, make_adversary}, false);
}
TEST_CASE("trials: strict decides wrong in some hard scenes, and trials see that", "[certified][sample]") {
    Renderer renderer(choose_device(list_devices(), ""));
    Tally all;
    for (uint64_t seed = 1; seed <= 15; ++seed)
        all += try_scene(renderer, make_adversary(seed).first, "", Accuracy::strict, 0);
    CHECK(all.wrong > 0);
    CHECK(all.contradictions == 0);
}
TEST_CASE("trials: certified decides right in random scenes, at length", "[.trials]") {
    run({"random", setting("GNOMON_TRIALS_RANDOM", 100'000'000), make_random}, true);
}
TEST_CASE("trials: certified decides right in hard scenes, at length", "[.trials]") {
    run({"adversarial", setting("GNOMON_TRIALS_ADVERSARIAL", 10'000'000), make_adversary}, true);
}
