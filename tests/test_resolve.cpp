// resolve alone: every bit of every pixel, and nothing else, from block order to rows.
#include "kernel_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Bits that tell component and pixel; a third are NaNs, most of them signalling, which arithmetic would quieten.
int value_of(size_t c, int i, int j) {
    const auto id = static_cast<uint32_t>(c * 0x100000) + static_cast<uint32_t>(j * 0x400 + i);
    return static_cast<int>(id % 3 == 0 ? 0x7F800001u | id << 1 : id);
}

struct Shape {
    int first_x, first_y, pitch, rows;
    size_t values() const { return static_cast<size_t>(pitch) * static_cast<size_t>(rows); }
};

std::vector<int> blocks_of(const Tile& tile, size_t components) {
    std::vector<int> blocks(static_cast<size_t>(tile.blocks) * BLOCK_RAYS * components);
    for (size_t ray = 0; ray < blocks.size() / components; ++ray) {
        const auto [i, j] = pixel_of(tile, ray);
        for (size_t c = 0; c < components; ++c) blocks[place(ray, c, components)] = value_of(c, i, j);
    }
    return blocks;
}

/// What the tile leaves in plane c: values where it overlaps the image, else what was there.
void draw(std::vector<int>& plane, const Shape& shape, const Tile& tile, const ImageSize& image, size_t c) {
    const int right = std::min(image.width, tile.x + tile.blocks_x * BLOCK_SIDE);
    const int bottom = std::min(image.height, tile.y + tile.blocks / tile.blocks_x * BLOCK_SIDE);
    for (int j = tile.y; j < bottom; ++j)
        for (int i = tile.x; i < right; ++i)
            plane[static_cast<size_t>((j - shape.first_y) * shape.pitch + i - shape.first_x)] = value_of(c, i, j);
}

/// Resolves the tiles one after the other into the same planes, and compares the planes after each.
void check_resolved(Bench& bench, const std::vector<Tile>& tiles, const ImageSize& image, const Shape& shape,
                    int components, int stream) {
    INFO(image.width << " x " << image.height << ", " << components << " components, STREAM " << stream);
    const Variant variant{Kernel::resolve, {"STREAM=" + std::to_string(stream)}};
    // Not the sentinel, which a work-item too many would read behind the blocks.
    const std::vector<int> before(shape.values(), 0x5EA1ED00);
    const GuardedBuffer<int> planes[] = {{bench, before}, {bench, before}, {bench, before}};
    std::vector<int> expected[] = {before, before, before};
    for (const Tile& tile : tiles) {
        const GuardedBuffer<int> blocks(bench, blocks_of(tile, static_cast<size_t>(components)));
        const int items = (tile.blocks_x + 1) / 2 * (tile.blocks / tile.blocks_x) * BLOCK_SIDE;
        bench.launch(bench.programs.get(variant).kernel, items, blocks.buffer(), components, tile,
                     Planes{image.width, image.height, shape.first_x, shape.first_y, shape.pitch}, items,
                     planes[0].buffer(), planes[1].buffer(), planes[2].buffer());
        for (size_t c = 0; c < static_cast<size_t>(components); ++c) draw(expected[c], shape, tile, image, c);
        for (size_t c = 0; c < 3; ++c) CHECK(same_bits(planes[c].read(), expected[c]));
        blocks.check_unchanged();
    }
}

template <class Check>
void each_way(Check check) {
    for (const int components : {1, 3})
        for (const int stream : {0, 1}) check(components, stream);
}

}  // namespace

TEST_CASE("resolve: images of any width, in place", "[resolve]") {
    on_every_bench([](Bench& bench) {
        each_way([&](int components, int stream) {
            // Pitches that are and that are not whole cache lines; odd and even numbers of blocks in a row.
            for (const ImageSize& image : {ImageSize{1, 1},
                                           {7, 3},
                                           {8, 8},
                                           {9, 8},
                                           {15, 9},
                                           {16, 8},
                                           {17, 16},
                                           {24, 5},
                                           {32, 16},
                                           {37, 29},
                                           {48, 8},
                                           {63, 7},
                                           {64, 24},
                                           {65, 1}}) {
                const int x = (image.width + 7) / 8, y = (image.height + 7) / 8;
                check_resolved(bench, {{0, 0, x, x * y}}, image, {0, 0, image.width, image.height}, components, stream);
            }
        });
    });
}

TEST_CASE("resolve: tiles share the image's planes and stay apart", "[resolve]") {
    on_every_bench([](Bench& bench) {
        each_way([&](int components, int stream) {
            for (const ImageSize& image : {ImageSize{61, 21}, {64, 24}}) {
                const std::vector<Tile> tiles = {{0, 0, 3, 6},   {24, 0, 3, 6},  {48, 0, 2, 4},
                                                 {40, 16, 3, 3}, {32, 16, 1, 1}, {0, 16, 4, 4}};
                check_resolved(bench, tiles, image, {0, 0, image.width, image.height}, components, stream);
            }
        });
    });
}

TEST_CASE("resolve: a plane of the tile alone", "[resolve]") {
    on_every_bench([](Bench& bench) {
        each_way([&](int components, int stream) {
            for (const Tile& tile : {Tile{16, 8, 3, 6}, {40, 16, 4, 8}, {56, 24, 1, 1}, {8, 0, 2, 8}}) {
                const Shape shape{tile.x, tile.y, tile.blocks_x * BLOCK_SIDE, tile.blocks / tile.blocks_x * BLOCK_SIDE};
                check_resolved(bench, {tile}, {61, 43}, shape, components, stream);
                check_resolved(bench, {tile}, {61, 30}, shape, components, stream);
            }
        });
    });
}
