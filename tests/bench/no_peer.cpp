// In place of embree.cpp, where Embree is not installed.
#include "peer.h"

namespace bench {

std::string peer_name() { return "Embree not installed"; }
std::unique_ptr<Peer> make_peer(const gnomon::Scene&, int) { return nullptr; }

}  // namespace bench
