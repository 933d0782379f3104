#include "core/io/csm_reader.h"

#include <algorithm>
#include <bitset>
#include <string_view>
#include <unordered_set>

#include "core/io/csm_cubes.h"
#include "core/io/csm_octant.h"
#include "core/svo/bake.h"
#include "core/svo/tree_builder.h"

namespace voxprite {
namespace {

using csm::Cube;
using csm::Cubes;
using csm::Turn;

constexpr std::uint64_t kMaxSolids = std::uint64_t{1} << 40;
// Blocks of 8 cubed, of which each takes some 600 bytes.
constexpr std::uint64_t kMaxBlocks = std::uint64_t{7} << 18;

using Path = std::vector<std::uint8_t>;  // octants of ours, from the root

struct Place {
    int line = 1;
    int column = 1;
};

struct CsmModel {
    Cubes cubes;
    Cube root;
    int levels = 0;
};

std::string quoted(char c) {
    constexpr char kDigits[] = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F) return std::string("'") + c + "'";
    return std::string("the byte 0x") + kDigits[byte >> 4] + kDigits[byte & 15];
}

// A leading 1, then three bits an octant.
std::uint64_t keyOf(const Path& path) {
    std::uint64_t key = 1;
    for (const std::uint8_t octant : path) key = key << 3 | octant;
    return key;
}

std::string nameOf(const Path& path) {
    if (path.empty()) return "the root";
    std::string name = "path ";
    for (const std::uint8_t octant : path) name += csm::letterOf(octant);
    return name;
}

class Parser {
  public:
    explicit Parser(ByteView text)
        : text_(reinterpret_cast<const char*>(text.data()), text.size()) {
        if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    }

    Result<CsmModel> run() {
        for (skipSpace(); !atEnd(); skipSpace()) {
            if (text_[at_] == '|') {
                endEpoch();
                step();
            } else if (text_[at_] == '>') {
                if (Status done = statement(); !done) return Failure(done.error());
            } else {
                return refuse(place(), "expected '>' or '|', found " + found());
            }
        }
        endEpoch();
        return CsmModel{std::move(cubes_), before_.root, before_.levels};
    }

  private:
    struct Epoch {
        Cube root;
        int levels = 0;                           // of its deepest path or bracket
        std::unordered_set<std::uint64_t> paths;  // that its statements named
    };

    void endEpoch() {
        if (epoch_.paths.empty()) return;
        before_ = std::move(epoch_);
        epoch_ = {};
        cubes_.seal();
    }

    Status statement() {
        step();
        const Result<Path> path = readPath(0);
        if (!path) return Failure(path.error());
        skipSpace();
        const Place start = place();
        const Result<Cube> cube = readCube(static_cast<int>(path->size()));
        if (!cube) return Failure(cube.error());
        epoch_.root = cubes_.replaced(epoch_.root, *path, *cube);
        if (cubes_.count() > kMaxCsmCubes) return refuse(start, tooMany());
        if (cubes_.unfolded(epoch_.root) > kMaxCsmCubes) {
            return refuse(start, "with this cube the model unfolds into more than " +
                                     std::to_string(kMaxCsmCubes) + " cubes");
        }
        const int depth = static_cast<int>(path->size()) + cubes_.levels(*cube);
        epoch_.levels = std::max(epoch_.levels, depth);
        epoch_.paths.insert(keyOf(*path));
        return {};
    }

    // A cube whose own path has `depth` letters. Goes no deeper than that allows.
    Result<Cube> readCube(int depth) {
        Turn turn;
        for (;; skipSpace()) {
            if (atEnd() || (text_[at_] != '/' && text_[at_] != '^')) break;
            const Result<Turn> next = readTurn();
            if (!next) return Failure(next.error());
            turn = turn * *next;
        }
        const Result<Cube> cube = readPlainCube(depth);
        if (!cube) return Failure(cube.error());
        return cubes_.turned(*cube, turn);
    }

    Result<Cube> readPlainCube(int depth) {
        if (atEnd()) return refuse(place(), "expected a cube, but the text ends");
        const char c = text_[at_];
        if (c >= '0' && c <= '9') return readValue();
        if (c == '[') return readBracket(depth);
        if (c == '<') return readReference(depth);
        if (c == '-') return refuse(place(), "a negative value has no voxel: 0 to 255");
        return refuse(place(), "expected a cube, found " + found());
    }

    Result<Cube> readValue() {
        const Place start = place();
        int value = 0;
        for (; !atEnd() && text_[at_] >= '0' && text_[at_] <= '9'; step()) {
            value = std::min(value * 10 + (text_[at_] - '0'), 1000);
        }
        if (value > 255) return refuse(start, "a value above 255 has no voxel: 0 to 255");
        return Cube::of(static_cast<std::uint8_t>(value));
    }

    Result<Cube> readBracket(int depth) {
        const Place start = place();
        if (depth >= kMaxOctreeDepth) return refuse(start, tooDeep());
        step();
        std::array<Cube, 8> children;
        for (unsigned child = 0; child < 8; ++child) {
            skipSpace();
            if (!atEnd() && text_[at_] == ']') {
                return refuse(place(), "a bracket holds eight cubes; the one of line " +
                                           std::to_string(start.line) + ", column " +
                                           std::to_string(start.column) + " has " +
                                           std::to_string(child));
            }
            const Result<Cube> cube = readCube(depth + 1);
            if (!cube) return Failure(cube.error());
            children[csm::octantFromCsm(child)] = *cube;
        }
        skipSpace();
        if (atEnd()) return refuse(place(), "expected ']', but the text ends");
        if (text_[at_] != ']') {
            return refuse(place(), "a bracket holds eight cubes; expected ']', found " + found());
        }
        step();
        if (cubes_.count() >= kMaxCsmCubes) return refuse(start, tooMany());
        return cubes_.node(children);
    }

    Result<Cube> readReference(int depth) {
        const Place start = place();
        step();
        const Result<Path> path = readPath(0);
        if (!path) return Failure(path.error());
        if (!before_.paths.contains(keyOf(*path))) {
            return refuse(start, before_.paths.empty()
                                     ? "there is no epoch before to refer to"
                                     : "the epoch before assigned nothing at " + nameOf(*path));
        }
        Cube cube = before_.root;
        for (const std::uint8_t octant : *path) cube = cubes_.child(cube, octant);
        if (depth + cubes_.levels(cube) > kMaxOctreeDepth) return refuse(start, tooDeep());
        return cube;
    }

    Result<Path> readPath(int depth) {
        skipSpace();
        Path path;
        for (; !atEnd() && text_[at_] >= 'a' && text_[at_] <= 'h'; step()) {
            if (depth + static_cast<int>(path.size()) >= kMaxOctreeDepth) {
                return refuse(place(), tooDeep());
            }
            path.push_back(static_cast<std::uint8_t>(csm::octantFromLetter(text_[at_])));
        }
        return path;
    }

    Result<Turn> readTurn() {
        const bool mirror = text_[at_] == '/';
        const Place start = place();
        step();
        skipSpace();
        std::vector<std::uint8_t> axes;
        std::bitset<3> named;
        for (; !atEnd(); step()) {
            const char c = static_cast<char>(text_[at_] | 0x20);  // capitals count, too
            if (c < 'x' || c > 'z') break;
            const auto axis = static_cast<std::uint8_t>(c - 'x');
            if (named[axis]) return refuse(place(), std::string("the axis ") + c + " again");
            named.set(axis);
            axes.push_back(axis);
        }
        if (axes.empty()) {
            return refuse(start,
                          std::string("expected axes (x, y, z) after ") + (mirror ? "'/'" : "'^'"));
        }
        return mirror ? mirrorAlong(axes) : exchangeOf(axes);
    }

    static Turn mirrorAlong(const std::vector<std::uint8_t>& axes) {
        SignedPermutation mirror;
        for (const std::uint8_t axis : axes) mirror.sign[axis] = -1;
        return Turn::all(mirror);
    }

    static Turn exchangeOf(const std::vector<std::uint8_t>& axes) {
        if (axes.size() == 1) return Turn::halves(axes[0]);
        SignedPermutation exchange;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            exchange.axis[axes[(i + 1) % axes.size()]] = axes[i];
        }
        return Turn::all(exchange);
    }

    void skipSpace() {
        for (bool comment = false; !atEnd(); step()) {
            const char c = text_[at_];
            if (c == '\n') comment = false;
            if (c == '#') comment = true;
            if (!comment && c != ' ' && (c < '\t' || c > '\r')) return;
        }
    }

    void step() {
        const bool lineEnds = text_[at_++] == '\n';
        place_ = lineEnds ? Place{place_.line + 1, 1} : Place{place_.line, place_.column + 1};
    }

    [[nodiscard]] bool atEnd() const { return at_ == text_.size(); }
    [[nodiscard]] Place place() const { return place_; }
    [[nodiscard]] std::string found() const { return quoted(text_[at_]); }
    [[nodiscard]] static std::string tooDeep() {
        return "deeper than " + std::to_string(kMaxOctreeDepth) + " levels";
    }
    [[nodiscard]] static std::string tooMany() {
        return "the text makes more than " + std::to_string(kMaxCsmCubes) + " cubes";
    }
    [[nodiscard]] static Failure refuse(Place place, std::string message) {
        return failAtLine(place.line, place.column, std::move(message));
    }

    std::string_view text_;
    std::size_t at_ = 0;
    Place place_;
    Cubes cubes_;
    Epoch epoch_;   // that is being read
    Epoch before_;  // the last one that assigned anything
};

class Baker {
  public:
    explicit Baker(const CsmModel& model) : model_(model), builder_(std::max(1, model.levels)) {}

    Result<Octree> run() {
        const glm::ivec3 size(1 << model_.levels);
        // A single voxel is the lowest of a brick.
        const bool single = model_.levels == 0 && model_.root.index != 0;
        const std::uint32_t root =
            single ? builder_.brick(model_.root.index) : word(model_.root, 0);
        return builder_.finish(root, size, glm::ivec3(0));
    }

  private:
    [[nodiscard]] std::uint32_t word(Cube cube, int depth) {
        if (cube.solid()) return cube.index;
        const Cubes& cubes = model_.cubes;
        if (depth == builder_.maxDepth() - 1) {
            std::uint64_t payload = 0;
            for (unsigned octant = 0; octant < 8; ++octant) {
                payload |= std::uint64_t{cubes.child(cube, octant).index} << (8 * octant);
            }
            return builder_.brick(payload);
        }
        return builder_.internal(
            depth, [&](unsigned octant) { return word(cubes.child(cube, octant), depth + 1); });
    }

    const CsmModel& model_;
    TreeBuilder builder_;
};

// Cubes of 8 voxels an edge that are not of one value all through.
std::uint64_t mixedBlocks(const Octree& octree, std::uint32_t word, int depth) {
    if (!node::isInternal(word) && !node::isBrick(word)) return 0;
    if (node::isBrick(word) || octree.maxDepth - depth <= 3) return 1;
    std::uint64_t blocks = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
        if (!node::hasChild(word, octant)) continue;
        blocks += mixedBlocks(octree, octree.nodes[node::childIndex(word, octant)], depth + 1);
    }
    return blocks;
}

}  // namespace

Result<Octree> octreeFromCsm(ByteView text) {
    const Result<CsmModel> model = Parser(text).run();
    if (!model) return Failure(model.error());
    return Baker(*model).run();
}

Result<Document> readCsm(ByteView text, const Palette& palette) {
    const Result<Octree> octree = octreeFromCsm(text);
    if (!octree) return Failure(octree.error());
    if (solidCount(octree->view()) > kMaxSolids) {
        return fail("the model holds more than 2^40 solid voxels");
    }
    if (mixedBlocks(*octree, octree->nodes[0], 0) > kMaxBlocks) {
        return fail("the model is too finely divided: its voxels would take more than a gigabyte");
    }
    Document document = Document::withEmptyModel();
    document.palette = palette;
    document.models[0] = {toVoxels(*octree), {glm::ivec3(0), octree->size}};
    return document;
}

}  // namespace voxprite
