// Tiles are dealt each once, and errors come out where the caller waits.
#include "dealer.h"

#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>

#include "catch.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// A queue whose markers stand for tiles.
struct Markers {
    cl::Context context;
    cl::CommandQueue queue;

    explicit Markers(const DeviceInfo& info) : context(open_device(info)), queue(context, open_device(info)) {}

    cl::Event mark() {
        cl::Event end;
        queue.enqueueMarkerWithWaitList(nullptr, &end);
        queue.flush();
        return end;
    }
};

template <class Test>
void on_markers(Test test) {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name) {
            Markers markers(device);
            test(markers);
        }
}

}  // namespace

TEST_CASE("dealer: each tile is launched once and ends once, in order for each worker", "[dealer]") {
    on_markers([](Markers& markers) {
        for (const size_t tiles : {0, 1, 2, 3, 100})
            for (const size_t workers : {1, 2, 7}) {
                std::vector<size_t> launched, under_way(workers);
                std::set<size_t> ended;
                std::vector<double> shares;
                Deal what{tiles, workers, {}, [&](size_t tile) { ended.insert(tile); }, {}};
                what.launch = [&](size_t tile, size_t worker) {
                    CHECK(worker < workers);
                    if (under_way.at(worker) > 0) CHECK(ended.count(under_way[worker] - 1) == 1);
                    under_way[worker] = tile + 1;
                    launched.push_back(tile);
                    return markers.mark();
                };
                what.progress = [&](double share) { shares.push_back(share); };
                deal(what);
                REQUIRE(launched.size() == tiles);
                for (size_t tile = 0; tile < tiles; ++tile) CHECK(launched[tile] == tile);
                CHECK(ended.size() == tiles);
                CHECK(std::is_sorted(shares.begin(), shares.end()));
                if (tiles > 0) CHECK(shares.back() == 1);
            }
    });
}

TEST_CASE("dealer: after an error no tile is launched, and none is under way", "[dealer]") {
    on_markers([](Markers& markers) {
        for (const size_t bad : {0, 1, 5}) {
            size_t launched = 0, ended = 0;
            Deal what{50, 3, {}, [&](size_t) { ++ended; }, {}};
            what.launch = [&](size_t tile, size_t) {
                if (tile == bad) throw std::runtime_error("launch");
                ++launched;
                return markers.mark();
            };
            CHECK_THROWS_WITH(deal(what), "launch");
            CHECK(launched == bad);
            CHECK(ended == launched);
        }
        size_t ended = 0;
        Deal what{50, 3, [&](size_t, size_t) { return markers.mark(); }, [&](size_t) { ++ended; }, {}};
        what.progress = [](double) { throw std::runtime_error("progress"); };
        CHECK_THROWS_WITH(deal(what), "progress");
        const size_t then = ended;
        markers.queue.finish();
        CHECK(ended == then);
    });
}

TEST_CASE("dealer: a command that fails is an error", "[dealer]") {
    on_markers([](Markers& markers) {
        cl::UserEvent before(markers.context);
        Deal what{2, 2, {}, [](size_t) {}, {}};
        what.launch = [&](size_t, size_t) {
            const std::vector<cl::Event> wait{before};
            cl::Event end;
            markers.queue.enqueueMarkerWithWaitList(&wait, &end);
            markers.queue.flush();
            return end;
        };
        std::thread fails([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));  // so that tiles wait for it
            before.setStatus(CL_OUT_OF_RESOURCES);
        });
        CHECK_THROWS_AS(deal(what), cl::Error);
        fails.join();
    });
}
