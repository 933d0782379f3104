// A cube with the name of the direction on each face, readable from outside, so that a mirrored or
// swapped axis is seen at once: FRONT is -Y, RIGHT is +X, BACK +Y, LEFT -X, TOP +Z, BOTTOM -Z.
#include <array>
#include <string_view>

#include "samples/generator/brush.h"

namespace voxprite::samples {

namespace {

constexpr int kEdge = 40;

struct Glyph {
    char letter;
    std::array<std::string_view, 5> rows;
};

constexpr std::array<Glyph, 16> kGlyphs{{
    {'G', {"###", "#..", "#.#", "#.#", "###"}},
    {'H', {"#.#", "#.#", "###", "#.#", "#.#"}},
    {'F', {"###", "#..", "##.", "#..", "#.."}},
    {'R', {"##.", "#.#", "##.", "#.#", "#.#"}},
    {'O', {"###", "#.#", "#.#", "#.#", "###"}},
    {'N', {"##.", "#.#", "#.#", "#.#", "#.#"}},
    {'T', {"###", ".#.", ".#.", ".#.", ".#."}},
    {'B', {"##.", "#.#", "##.", "#.#", "##."}},
    {'A', {".#.", "#.#", "###", "#.#", "#.#"}},
    {'C', {"###", "#..", "#..", "#..", "###"}},
    {'K', {"#.#", "#.#", "##.", "#.#", "#.#"}},
    {'L', {"#..", "#..", "#..", "#..", "###"}},
    {'E', {"###", "#..", "##.", "#..", "###"}},
    {'I', {"###", ".#.", ".#.", ".#.", "###"}},
    {'P', {"##.", "#.#", "##.", "#..", "#.."}},
    {'M', {"#.#", "###", "###", "#.#", "#.#"}},
}};

const Glyph* glyphOf(char letter) {
    for (const Glyph& glyph : kGlyphs)
        if (glyph.letter == letter) return &glyph;
    return nullptr;
}

struct Face {
    std::string_view word;
    Ramp ramp;
    glm::ivec3 corner;  // top left of the face, as seen from outside
    glm::ivec3 right, down, outward;
};

// A 3x5 pixel letter, `zoom` voxels a pixel.
void write(Brush& brush, const Face& face, std::string_view word, int column, int row, int zoom,
           std::uint8_t colour) {
    for (const char letter : word) {
        if (const Glyph* glyph = glyphOf(letter)) {
            for (int y = 0; y < 5 * zoom; ++y)
                for (int x = 0; x < 3 * zoom; ++x)
                    if (glyph->rows[static_cast<std::size_t>(y / zoom)]
                                   [static_cast<std::size_t>(x / zoom)] == '#')
                        brush.dot(face.corner + face.right * (column + x) + face.down * (row + y),
                                  colour);
        }
        column += 4 * zoom;
    }
}

}  // namespace

VoxelGrid letterCube() {
    VoxelGrid grid;
    Brush brush(grid);
    constexpr int e = kEdge - 1;
    brush.box({0, 0, 0}, {e, e, e}, grained(Ramp::stone, 2, 0.0));
    brush.erase({2, 2, 2}, {e - 2, e - 2, e - 2});
    const std::array<Face, 6> faces{{
        {"FRONT", Ramp::blue, {0, 0, e}, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
        {"RIGHT", Ramp::red, {e, 0, e}, {0, 1, 0}, {0, 0, -1}, {1, 0, 0}},
        {"BACK", Ramp::gold, {e, e, e}, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
        {"LEFT", Ramp::blossom, {0, e, e}, {0, -1, 0}, {0, 0, -1}, {-1, 0, 0}},
        {"TOP", Ramp::leaf, {0, e, e}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {"BOTTOM", Ramp::wood, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
    }};
    for (const Face& face : faces) {
        for (int y = 0; y < kEdge; ++y)
            for (int x = 0; x < kEdge; ++x) {
                const bool border = x < 2 || y < 2 || x > e - 2 || y > e - 2;
                const bool chequer = ((x / 4) + (y / 4)) % 2 == 0;
                brush.dot(face.corner + face.right * x + face.down * y,
                          shade(face.ramp, border    ? 1
                                           : chequer ? 3
                                                     : 2));
            }
        const int zoom = face.word.size() > 3 ? 1 : 2;
        const int width = static_cast<int>(face.word.size()) * 4 * zoom - zoom;
        write(brush, face, face.word, (kEdge - width) / 2, 6, zoom, shade(Ramp::plaster, 5));
        // The initial, large, in the middle of what is left.
        const int big = 4;
        write(brush, face, face.word.substr(0, 1), (kEdge - 3 * big) / 2, 15, big,
              shade(Ramp::plaster, 5));
    }
    return grid;
}

}  // namespace voxprite::samples
