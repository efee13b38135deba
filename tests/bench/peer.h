// Another renderer of the same scenes, to be timed in turn with gnomon.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "film.h"
#include "scene.h"

namespace bench {

/// Which lights arrive at which pixel: a bit a light.
struct Arrivals {
    size_t words = 0;  ///< 64 lights each, of a pixel
    std::vector<uint64_t> bits;

    bool at(size_t pixel, size_t light) const { return (bits[pixel * words + light / 64] >> light % 64 & 1) != 0; }
};

class Peer {
  public:
    virtual ~Peer() = default;

    /// Ways to build; which is best depends on the scene.
    virtual std::vector<std::string> modes() const = 0;
    /// Builds what it traces against, anew.
    virtual void build(const std::string& mode) = 0;
    /// Renders the radiance, all that `film` needs to hold; gives up after so many seconds and returns false.
    virtual bool frame(gnomon::Film& film, double limit) = 0;
    /// The same with the ids, and which lights arrived.
    virtual bool picture(gnomon::Film& film, Arrivals& arrivals, double limit) = 0;
};

/// "Embree 3.13.5", or that there is none.
std::string peer_name();
/// Takes what it needs from the scene; null when the benchmark was built without a peer.
std::unique_ptr<Peer> make_peer(const gnomon::Scene& scene, int threads);

}  // namespace bench
