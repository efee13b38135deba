// Workers are dealt one thing after the other, and errors come out where the caller waits.
#include "dealer.h"

#include <chrono>
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

TEST_CASE("dealer: all is launched, each worker has one thing to do at a time, and its end is told", "[dealer]") {
    on_markers([](Markers& markers) {
        for (const size_t tiles : {0, 1, 2, 3, 100})
            for (const size_t workers : {1, 2, 7}) {
                size_t launched = 0;
                std::vector<bool> under_way(workers);
                size_t ended = 0;
                std::vector<double> shares;
                Deal what{workers, {}, {}, [&](double share) { shares.push_back(share); }};
                what.launch = [&](size_t worker) {
                    CHECK(!under_way.at(worker));
                    if (launched == tiles) return cl::Event();
                    ++launched;
                    under_way[worker] = true;
                    return markers.mark();
                };
                what.ended = [&](size_t worker) {
                    CHECK(under_way.at(worker));
                    under_way[worker] = false;
                    return static_cast<double>(++ended) / static_cast<double>(tiles);
                };
                deal(what);
                CHECK(launched == tiles);
                CHECK(ended == tiles);
                CHECK(std::is_sorted(shares.begin(), shares.end()));
                if (tiles > 0) CHECK(shares.back() == 1);
            }
    });
}

TEST_CASE("dealer: after an error nothing is launched, and nothing is under way", "[dealer]") {
    on_markers([](Markers& markers) {
        for (const size_t bad : {0, 1, 5}) {
            size_t launched = 0, ended = 0;
            Deal what{3, {}, [&](size_t) { return static_cast<double>(++ended); }, {}};
            what.launch = [&](size_t) {
                if (launched == bad) throw std::runtime_error("launch");
                ++launched;
                return markers.mark();
            };
            CHECK_THROWS_WITH(deal(what), "launch");
            CHECK(launched == bad);
            CHECK(ended == launched);
        }
        size_t launched = 0, ended = 0;
        Deal what{3, {}, [&](size_t) { return static_cast<double>(++ended); }, {}};
        what.launch = [&](size_t) { return ++launched > 50 ? cl::Event() : markers.mark(); };
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
        Deal what{2, {}, [](size_t) { return 0.0; }, {}};
        what.launch = [&](size_t) {
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
