// How exactly pictures are computed.
#pragma once

#include <vector>

namespace gnomon {

/// `strict`: float, correctly rounded, the same bits everywhere; what a rendering uses unless told otherwise.
enum class Accuracy { fast, strict, certified, full };

inline const char* to_string(Accuracy accuracy) {
    switch (accuracy) {
        case Accuracy::fast:
            return "fast";
        case Accuracy::strict:
            return "strict";
        case Accuracy::certified:
            return "certified";
        case Accuracy::full:
            break;
    }
    return "double";
}

/// Those that a Renderer can be asked for.
inline std::vector<Accuracy> available_accuracies() { return {Accuracy::strict}; }

}  // namespace gnomon
